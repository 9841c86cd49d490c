"""How fast people speak: what cannot have been said in the time there was, and what leaves much of the time unsaid."""

from __future__ import annotations

from collections.abc import Iterable

from intent_engine.speech.audio import SAMPLE_RATE, Samples

__all__ = ["too_few", "too_many"]

FASTEST = 30.0
"""Letters in a second of sound that nobody says. Of 233 commands heard right at 10 dB none had more than 15 (half of
them less than 10), with the half second before the voice; a model that goes round in a loop writes 60 and more."""
USUAL = 12.0
"""Letters in a second of speech, as people say them who do not hurry."""
BEFORE = 0.5
"""s of sound that an utterance has from before its first word."""
UNSAID = 0.8
"""s of sound beyond what words need at this pace, from which some may be missing: two seconds are no "right"."""


def too_many(words: Iterable[str], samples: Samples) -> bool:
    """Whether words cannot all have been said in a sound of shape ``(n,)``."""
    return _letters(words) > FASTEST * samples.size / SAMPLE_RATE


def too_few(words: Iterable[str], samples: Samples) -> bool:
    """Whether so much of a sound of shape ``(n,)`` is left beside words that there may have been more."""
    return samples.size / SAMPLE_RATE - BEFORE - _letters(words) / USUAL > UNSAID


def _letters(words: Iterable[str]) -> int:
    return sum(map(len, words))
