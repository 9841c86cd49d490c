"""Sound to text: the protocol and what it returns."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass, replace
from typing import Any, Protocol, runtime_checkable

from intent_engine.speech.audio import Samples
from intent_engine.values import is_number

__all__ = ["Encoded", "Following", "Glancing", "Recognizer", "Transcript"]

SLACK = 1e-6
"""By which rounding may carry a probability beyond 0 and 1."""


@dataclass(frozen=True, slots=True)
class Transcript:
    """What was heard in one stretch of speech.

    Raises:
        TypeError: a text or number is none, or words are no list of texts: one text would be taken letter by letter.
        ValueError: the confidence is no probability, or a number is NaN, which would be less than no threshold, and all
            would be acted on.
    """

    text: str
    """The words, as the recogniser writes them; in the words of the grammar if it was steered. Empty: nothing."""
    score: float = 0.0
    """Mean log probability of a token: 0 is certain, below -1 is doubtful."""
    free_text: str = ""
    """What was heard without steering; the same as ``text`` if there was none."""
    gap: float | None = None
    """Log probability of the free text less that of the best sentence of the grammar, in nats, for each word of the
    grammar in that sentence and one more; None if not steered or nothing of the grammar was near. Small: the grammar
    explains the sound as well as anything. Large: something else was said."""
    alternatives: tuple[str, ...] = ()
    """Further readings, best first."""
    behind: tuple[float, ...] = ()
    """nats by which each of these is less likely than the likeliest sentence of the grammar, which is the text, or, of
    :meth:`as_heard`, the first of them; empty: not known."""
    unclear: tuple[str, ...] = ()
    """Words on which the meaning hangs and that were not heard clearly: names that no list has, and numbers that sound
    like others."""
    left_out: tuple[str, ...] = ()
    """Words that were heard clearly before or after the sentence and are no part of it ("do you", "at six miles")."""
    language: str | None = None
    confidence: float | None = None
    """0 to 1: how likely it is that the words were said, where they are those of the grammar and not those that were
    heard freely; None if not steered, or if nothing of the grammar was near."""
    decode_seconds: float = 0.0
    """Time that recognition took."""
    draft: bool = False
    """Whether the recogniser would hear it better with more care: it is not acted on, and an utterance that seems to be
    over is recognised again, as final."""

    def __post_init__(self) -> None:
        for name in ("text", "free_text"):
            if not isinstance(text := getattr(self, name), str):
                raise TypeError(f"a transcript's {name} is a str, not {type(text).__name__}")
        for name in ("alternatives", "behind", "unclear", "left_out"):
            if not isinstance(several := getattr(self, name), (tuple, list)):
                raise TypeError(f"a transcript's {name} are a tuple, not {several!r:.80}")
            kind, right = ("numbers", is_number) if name == "behind" else ("texts", _is_text)
            if not all(map(right, several)):
                raise TypeError(f"a transcript's {name} are {kind}, not {several!r:.80}")
        if self.confidence is not None and not -SLACK <= self.confidence <= 1.0 + SLACK:  # NaN is in no range
            raise ValueError(f"a transcript's confidence is from 0 to 1 or None, not {self.confidence!r}")
        if self.language is not None and not isinstance(self.language, str):
            raise TypeError(f"a transcript's language is a str or None, not {self.language!r:.80}")
        gap = 0.0 if self.gap is None else self.gap
        for name, value in (("score", self.score), ("gap", gap), ("decode_seconds", self.decode_seconds)):
            if not is_number(value):
                raise TypeError(f"a transcript's {name} is a number, not {value!r:.80}")
            if math.isnan(value):
                what = "a time in s" if name == "decode_seconds" else "a log probability"
                raise ValueError(f"a transcript's {name} is {what}, not {value!r}")

    @property
    def word_by_word(self) -> bool:
        """Whether the words are those that were heard, and no sentence of the grammar that they are like."""
        return self.confidence in (None, 1.0)

    @property
    def sureness(self) -> float:
        """The confidence as a number: 0 where there is none."""
        return self.confidence or 0.0

    def as_heard(self) -> Transcript:
        """With the words heard freely for its text; what it was taken for becomes the first of its further readings."""
        if self.text == self.free_text:
            return self
        behind = (0.0, *self.behind) if len(self.behind) == len(self.alternatives) else ()
        return replace(self, text=self.free_text, alternatives=(self.text, *self.alternatives), behind=behind)

    def alternatives_to_json(self) -> list[dict[str, Any]]:
        """The further readings, best first: each ``text``, and how many nats it is ``behind``, None where that is not
        known."""
        behind = itertools.chain(self.behind, itertools.repeat(None))
        return [
            {"text": text, "behind": None if nats is None else round(nats, 3)}
            for text, nats in zip(self.alternatives, behind, strict=False)
        ]


def _is_text(value: object) -> bool:
    return isinstance(value, str)


@dataclass(frozen=True, slots=True)
class Encoded:
    """A stretch of speech, encoded by a model."""

    features: Any
    """The model's own; Whisper: CTranslate2 storage, ``(1, frames / 2, width)``; Moonshine: ``(1, frames, width)``."""
    seconds: float
    """Length of the speech."""


class Recognizer(Protocol):
    """Turns a stretch of speech into text. Called from one thread at a time."""

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        """What was said.

        Args:
            samples: ``(n,)`` at 16 kHz, the speech with a little silence around it.
            final: False for a look at speech that may go on; may be answered with less care.
        """
        ...

    def close(self) -> None:
        """Let go of the model. Idempotent."""
        ...


@runtime_checkable
class Glancing(Protocol):
    """A recogniser that can tell quickly whether anything is to be found out."""

    def glance(self, samples: Samples) -> Transcript:
        """What was said, if it is clear at first sight: a command that was heard word by word. Else a draft.

        Args:
            samples: ``(n,)`` at 16 kHz, of which the last sounds may be missing.
        """
        ...


@runtime_checkable
class Following(Protocol):
    """A recogniser that can listen along while somebody speaks, so that little is left to do when they pause."""

    def follow(self, samples: Samples) -> Transcript:
        """The words so far, of speech that goes on: a draft, for what is heard next of the same speech.

        Args:
            samples: as for :meth:`Recognizer.transcribe`.
        """
        ...

    def lose(self) -> None:
        """Forget the last words that were followed: it would not have heard them in time."""
        ...
