"""One way to understand some words: which sentence they are, and what its slots hold."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from intent_engine.interpretation import Cause
from intent_engine.language.grammar import Intent, Sentence, Slot

__all__ = ["Reading", "SlotReading"]


@dataclass(frozen=True, slots=True)
class SlotReading:
    """What was heard for one slot."""

    label: str
    slot: Slot
    start: int
    """First word."""
    end: int
    """Word after the last."""
    value: Any
    """SI float, canonical name, text; None if the words have no value."""
    score: float = 1.0
    """1: exactly said."""
    rivals: tuple[tuple[str, float], ...] = ()
    """Fuzzy names: the nearest, best first."""
    status: str = "exact"
    """``exact``, ``fuzzy``, ``ambiguous``, ``unknown``, ``unfinished`` or ``limit``."""
    problem: str = ""
    """Why there is no value."""

    @property
    def cause(self) -> Cause | None:
        """What kind of reason that is, where a program has to know it."""
        if self.status == "limit":
            return Cause.BEYOND_LIMITS
        return Cause.UNKNOWN_PLACE if (self.slot.type, self.status) == ("location", "unknown") else None


@dataclass(frozen=True, slots=True)
class Reading:
    """One way to understand all the words."""

    intent: Intent
    sentence: Sentence
    slots: tuple[SlotReading, ...]
    words: tuple[str, ...]
    """The words as understood, with sound-alikes replaced."""
    alikes: int
    """Words that were replaced,"""
    misheard: int
    """of them by others that only sound alike, not the same."""
    free_words: int
    """Words swallowed by text slots."""

    @property
    def problem(self) -> str:
        for slot in self.slots:
            if slot.problem:
                return slot.problem
        return ""

    @property
    def understood(self) -> bool:
        """Whether nothing is wrong with it but a number beyond its limits."""
        return all(slot.status == "limit" for slot in self.slots if slot.problem)

    @property
    def heard_exactly(self) -> int:
        """Words that are not only like a name, or the name of nothing. Sound-alikes count: by ear nobody
        can tell them apart."""
        compared = sum(slot.end - slot.start for slot in self.slots if slot.status in ("fuzzy", "unknown"))
        return len(self.words) - compared

    @property
    def score(self) -> float:
        """1 for exact words; each fuzzy slot and misheard word lowers it."""
        score = 1.0
        for slot in self.slots:
            score *= slot.score
        return score * 0.97**self.misheard

    def values(self) -> dict[str, Any]:
        """Slot label to value, with the sentence's own slots."""
        found = dict(self.sentence.fixed)
        for slot in self.slots:
            found[slot.label] = slot.value
        return found
