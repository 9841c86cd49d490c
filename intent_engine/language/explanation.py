"""What an explanation is: the path from a text to its interpretation, as plain data."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from intent_engine.interpretation import Interpretation

__all__ = ["Candidate", "Explanation", "Noticed", "SlotSource", "Step", "Word"]


@dataclass(frozen=True, slots=True)
class Word:
    """A normalised word and what it was written as."""

    word: str
    text: str
    pause: bool
    """Whether a pause or punctuation stands before it."""


@dataclass(frozen=True, slots=True)
class Noticed:
    """Words that are no content: a filler, a negation, a correction."""

    kind: str
    words: str
    start: int
    """Place of the first among the words."""


@dataclass(frozen=True, slots=True)
class SlotSource:
    """A value and where it came from."""

    name: str
    value: Any
    source: str
    """``said``, ``sentence`` (it has the value without saying it), ``default`` or ``condition``."""
    words: str = ""
    """What was said, as understood; or the condition."""
    how: str = "exact"
    """Of what was said: ``exact``, ``fuzzy``, ``ambiguous``, ``unknown`` or ``limit``."""
    score: float = 1.0
    rivals: tuple[tuple[str, float], ...] = ()
    """Names that came near, best first."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """A sentence of the grammar that has the words."""

    intent: str
    sentence: str
    """As the grammar file has it."""
    place: str
    """``file:line`` of it."""
    words: str
    """As understood: sound-alikes replaced."""
    slots: tuple[SlotSource, ...]
    score: float
    priority: int
    free_words: int
    """Words that fell into free text."""
    refused: str
    """Why it was not taken; empty: it was."""


@dataclass(frozen=True, slots=True)
class Step:
    """Something that was tried."""

    name: str
    words: str
    """What it was tried on."""
    outcome: str
    candidates: tuple[Candidate, ...] = ()
    steps: tuple[Step, ...] = ()
    """What was tried to find it out."""
    untold: int = 0
    """Further steps inside that are not listed."""


@dataclass(frozen=True, slots=True)
class Explanation:
    """The path from a text to its interpretation."""

    language: str
    words: tuple[Word, ...]
    noticed: tuple[Noticed, ...]
    steps: tuple[Step, ...]
    slots: tuple[tuple[SlotSource, ...], ...]
    """Of each command that was understood, in order: values and where they came from."""
    interpretation: Interpretation

    def to_json(self) -> dict[str, Any]:
        """A plain dictionary: the interpretation's own keys, and ``explanation``."""
        return self.interpretation.to_json() | {
            "explanation": {
                "language": self.language,
                "words": [_plain(word) for word in self.words],
                "noticed": [_plain(one) for one in self.noticed],
                "steps": [_plain(step) for step in self.steps],
                "slots": [[_plain(slot) for slot in slots] for slots in self.slots],
            }
        }


def _plain(value: Any) -> Any:
    if hasattr(value, "__dataclass_fields__"):
        return {name: _plain(getattr(value, name)) for name in value.__dataclass_fields__}
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    return value
