"""What is understood of words as one command, and how it is told."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from intent_engine.actions import Action
from intent_engine.interpretation import Cause
from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.quantities import Relative
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.words.thing_words import any_articles

__all__ = ["Clause", "described", "more_telling", "slot_values"]


@dataclass(frozen=True, slots=True)
class Clause:
    """One command, understood, or why not."""

    reading: Reading | None = None
    action: Action | None = None
    reason: str = ""
    """Why it is not accepted; or what was changed to accept it."""
    causes: frozenset[Cause] = frozenset()
    """What kinds of reason that is."""
    alternatives: tuple[str, ...] = ()
    ambiguous: bool = False
    at_fault: tuple[str, ...] = ()
    """What its reason finds fault with: words that follow a name or a pause, or any of those that are no thing."""
    parted: bool = False
    """Whether it is a sentence, but was not said in one breath where it must be."""

    @property
    def accepted(self) -> bool:
        return self.action is not None

    @property
    def wrong_slot(self) -> SlotReading | None:
        """The first of its slots that has no value, and why; None: all have one."""
        if self.reading is None:
            return None
        return next((slot for slot in self.reading.slots if slot.problem), None)

    @property
    def unknown_place(self) -> bool:
        """Whether it would be a command, were its place on the map; an article is none, it begins a name."""
        slot = self.wrong_slot
        if self.reading is None or slot is None or slot.cause is not Cause.UNKNOWN_PLACE:
            return False
        return not any_articles().issuperset(self.reading.words[slot.start : slot.end])

    @property
    def no_name(self) -> bool:
        """Whether it would be a command, were some free words the name of anything: "take your time"."""
        slot = self.wrong_slot
        return slot is not None and slot.slot.type in FREE_KINDS

    @property
    def free_names(self) -> list[tuple[str, ...]]:
        """The words of its slots that hold any words."""
        if self.reading is None:
            return []
        slots = (slot for slot in self.reading.slots if slot.slot.type in FREE_KINDS)
        return [self.reading.words[slot.start : slot.end] for slot in slots]


def slot_values(reading: Reading) -> dict[str, Any]:
    """Slots for a person or a program: SI numbers, names, text; a relative speed as its factor of the usual one."""
    values: Mapping[str, Any] = reading.values()
    return {
        label: value.factor if isinstance(value, Relative) else value
        for label, value in values.items()
        if value is not None
    }


def described(reading: Reading) -> str:
    """A short name of a meaning, for "did you mean"."""
    values = ", ".join(f"{label}: {value}" for label, value in slot_values(reading).items())
    return f"{reading.intent.name} ({values})" if values else reading.intent.name


def more_telling(exact: Clause | None, loose: Clause | None) -> Clause | None:
    """Of two reasons why words are no command the one that tells more: that no place is called "library" says more of
    "take me to the library" than that "me" is nothing to take."""
    if exact is None or loose is None:
        return exact or loose
    return loose if exact.no_name and loose.unknown_place else exact
