"""What a grammar file says, checked: the description that the automaton is built from."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from intent_engine.errors import Problem
from intent_engine.language.templates.template_tree import Node
from intent_engine.language.wording import Wording
from intent_engine.needs import Needs

__all__ = [
    "ACTION_PARAMETERS",
    "FREE_KINDS",
    "LONGEST_WAIT",
    "MOTIONS",
    "NEVER_NEGATIVE",
    "QUANTITY_KINDS",
    "SLOT_TYPES",
    "TELLING_APART",
    "ActionSpec",
    "Condition",
    "Example",
    "Grammar",
    "Intent",
    "Operators",
    "Place",
    "Sentence",
    "Slot",
    "problem_at",
]

QUANTITY_KINDS = ("number", "ordinal", "distance", "angle", "duration", "speed", "angular_speed", "percent")
"""Slot types whose value is a float in SI units (``ordinal`` and ``number`` have none)."""
FREE_KINDS = frozenset(("text", "object"))
"""Slot types that hold any words."""
TELLING_APART = frozenset(("choice", "location", "ordinal", "boolean"))
"""Slot types that tell one thing from another; an amount does not ("fade A to 20 and A to 30")."""

_WRITTEN: Mapping[str, tuple[float, str]] = {
    "distance": (1.0, " m"),
    "angle": (math.degrees(1.0), "°"),
    "duration": (1.0, " s"),
    "speed": (1.0, " m/s"),
    "angular_speed": (math.degrees(1.0), "°/s"),
    "percent": (100.0, " %"),
}
"""How people write a value in SI units: what it is multiplied by, and the unit."""
NEVER_NEGATIVE = frozenset(("duration", "percent"))
"""Quantities of which there is none less than none, but where a file says so."""
_POINTING = _WRITTEN.keys() - NEVER_NEGATIVE
"""Quantities that have a size and point one of two ways."""

SLOT_TYPES = (*QUANTITY_KINDS, "choice", "location", "text", "object", "boolean")

MOTIONS = frozenset(("move", "turn", "navigate"))
"""Actions that are nothing but a way of the robot, which ends at rest."""

ACTION_PARAMETERS: dict[str, dict[str, str]] = {
    "move": {
        "direction": "forward or backward",
        "distance": "distance",
        "duration": "duration",
        "speed": "speed",
    },
    "turn": {
        "direction": "left or right",
        "angle": "angle",
        "duration": "duration",
        "speed": "angular_speed",
    },
    "stop": {},
    "navigate": {"location": "location"},
    "pick": {"object": "text"},
    "place": {"object": "text", "location": "text"},
    "change_speed": {"factor": "number"},
    "custom": {},
}
"""What each action takes, and the kind of each value."""

LONGEST_WAIT = 5.0
"""s of silence in a sentence. Who pauses longer says another, and a robot that waits longer seems not to have heard."""


@dataclass(frozen=True, slots=True)
class Place:
    """Where something stands in a file, for messages."""

    file: str
    line: int
    """From 1."""
    column: int
    """From 1."""
    source: str
    """The line."""


def problem_at(place: Place | None, message: str, hint: str | None = None) -> Problem:
    """A problem of what stands at a place; None: it is in no file."""
    if place is None:
        return Problem(message, hint=hint)
    return Problem(message, place.file, place.line, place.column, place.source, hint)


@dataclass(frozen=True, slots=True)
class Slot:
    """A hole in a sentence."""

    name: str
    type: str
    """One of ``SLOT_TYPES``."""
    unit: str | None = None
    """Taken when a number is said without one; None: a unit must be said."""
    units: tuple[tuple[float, Node], ...] = ()
    """Units of its own, besides those that everybody knows: the size of each in SI, and the template that spells it."""
    minimum: float | None = None
    """SI, inclusive."""
    maximum: float | None = None
    """SI, inclusive."""
    least: float | None = None
    """SI, inclusive: the smallest size, whichever its sign."""
    usual_steps: tuple[float, ...] = ()
    """SI: people say their multiples. Another number that sounds like one must be heard far more clearly."""
    usual_max: float | None = None
    """SI: people hardly say more. Of two numbers that sound alike the other is likelier; None: any."""
    whole: bool = False
    """Number: whether it counts something, so that nothing between two whole numbers is one."""
    digits: bool = False
    """Quantity: whether its digits may be said one by one: "one eight zero"."""
    values: tuple[tuple[Any, Node], ...] = ()
    """Choice: value and the template that spells it."""
    max_words: int = 4
    """Text: at most so many words, articles before the name not counted."""
    dictation: bool = False
    """Text: whether it is dictated. It ends its sentence, and holds all that is said from there on, as it was said."""
    allow: frozenset[str] = frozenset()
    """Text: words that it may hold though they are operators ("and")."""
    without: frozenset[str] = frozenset()
    """Text: words that show that something else is meant ("email" is nothing to pick up)."""
    known: frozenset[str] = frozenset()
    """Text: words that are likely in it. Speech that sounds like one is heard as it; others are taken all the same."""
    known_names: frozenset[tuple[str, ...]] = frozenset()
    """Text: the names of which these are the words. A name may hold words that a text else may not: "brake pads"."""
    tags: frozenset[str] = frozenset()
    """Location: only places with one of these tags; empty: all."""
    fuzzy: bool = True
    """Choice and location: whether misspelled and misheard values are resolved."""
    place: Place | None = None

    @property
    def smallest(self) -> float | None:
        """The lower bound in SI, inclusive. Where the file names none, a ``max`` bounds the size both ways, so that
        nobody drives twenty meters back by "forward minus twenty meters"; and no time or share is less than none."""
        if self.minimum is not None:
            return self.minimum
        if self.type in NEVER_NEGATIVE:
            return 0.0
        return -self.maximum if self.maximum is not None and self.maximum > 0 and self.type in _POINTING else None

    @property
    def bare(self) -> bool:
        """Whether a number alone may be a value of a number's slot: where a unit of its own is as large as one ("gram"
        beside "kilo"), a person who leaves it out may mean another, unless the slot has a ``unit``."""
        return self.unit is not None or all(size != 1 for size, _ in self.units)

    def beyond(self, value: float) -> tuple[str, str] | None:
        """Why a quantity is no value of the slot: (the key that says so, "more than the largest, 5 m"); None: it is."""
        if self.whole and not float(value).is_integer():
            return "whole", "no whole number"
        if self.smallest is not None and value < self.smallest:
            key = "min" if self.maximum is None or self.minimum is not None or self.type in NEVER_NEGATIVE else "max"
            return key, f"less than the smallest, {self.written(self.smallest)}"
        if self.least is not None and abs(value) < self.least:
            return "least", f"less than the smallest, {self.written(self.least)}"
        if self.maximum is not None and value > self.maximum:
            return "max", f"more than the largest, {self.written(self.maximum)}"
        return None

    def counted(self, value: float) -> float:
        """A quantity as programs get it: where it counts something, and an ordinal, an ``int``, for ``range(value)``
        and ``items[value - 1]``."""
        counts = self.whole or self.type == "ordinal"
        return int(value) if counts and float(value).is_integer() else value

    def written(self, value: float) -> str:
        """A quantity for people to read, with its unit: "1.2 m", "90°", "40 %"."""
        factor, unit = _WRITTEN.get(self.type, (1.0, ""))
        return f"{value * factor:.6g}{unit}"


@dataclass(frozen=True, slots=True)
class Sentence:
    text: str
    template: Node
    fixed: Mapping[str, Any] = field(default_factory=dict)
    """Slot values that the sentence has without saying them ("back up" -> direction: backward)."""
    place: Place | None = None


@dataclass(frozen=True, slots=True)
class ActionSpec:
    """How slots become an action."""

    type: str
    name: str | None = None
    """Name of a custom action."""
    parameters: Mapping[str, Any] = field(default_factory=dict)
    """Parameter -> ``{slot}`` or a value. A parameter not listed takes the slot of its own name."""


@dataclass(frozen=True, slots=True)
class Condition:
    """Defaults that hold only for some slot values."""

    slots: Mapping[str, Any]
    defaults: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Example:
    """A sentence with its meaning, written beside the sentences."""

    text: str
    expected: Mapping[str, Any] | str | None
    """Slots; ``rejected``, ``ambiguous`` or ``incomplete``; None: accepted, whatever the slots."""
    place: Place | None = None


@dataclass(frozen=True, slots=True)
class Intent:
    name: str
    action: ActionSpec
    sentences: tuple[Sentence, ...] = ()
    then: tuple[Sentence, ...] = ()
    """What is a command only behind one of this intent and a joint: "and then to the bedroom"."""
    regex: tuple[str, ...] = ()
    lark: str | None = None
    defaults: Mapping[str, Any] = field(default_factory=dict)
    when: tuple[Condition, ...] = ()
    requires: frozenset[str] = frozenset()
    """States that the robot must be in."""
    excludes: frozenset[str] = frozenset()
    """States that the robot must not be in."""
    priority: int = 0
    """Wins over intents of lower priority where both accept a text."""
    min_confidence: float | None = None
    """How sure it must be that it was said, 0 to 1, before spoken words are acted on; None: the runtime's own."""
    wait: float | None = None
    """s of silence that end a spoken one that could go on; None: the endpoint's own."""
    examples: tuple[Example, ...] = ()
    description: str = ""
    place: Place | None = None

    @property
    def all_sentences(self) -> tuple[Sentence, ...]:
        """Also those that are one only behind another."""
        return (*self.sentences, *self.then)

    @property
    def needs(self) -> Needs:
        return Needs(self.name, self.requires, self.excludes)


@dataclass(frozen=True, slots=True)
class Operators:
    """The words that change what a sentence does, as plain phrases of normalised words."""

    negation: tuple[tuple[str, ...], ...] = ()
    correction: tuple[tuple[str, ...], ...] = ()
    cancel: tuple[tuple[str, ...], ...] = ()
    sequence: tuple[tuple[str, ...], ...] = ()
    later: tuple[tuple[str, ...], ...] = ()
    """Those of ``sequence`` that say that something else is done first: "when you get there", not "and"."""
    contrast: tuple[tuple[str, ...], ...] = ()
    """After a negated part, what comes next is wanted: "don't turn left, *instead* turn right"."""
    opener: tuple[tuple[str, ...], ...] = ()
    """What people begin with, and what says nothing there alone: "first", "well"."""
    stop: tuple[tuple[str, ...], ...] = ()
    stop_by_sound: tuple[tuple[str, ...], ...] = ()
    """The same as they may be written by their sound: "break". They stop where nothing else was said."""
    hold: tuple[tuple[str, ...], ...] = ()
    """They stop a robot that moves where nothing else is said: "wait", "don't move"."""
    objection: tuple[tuple[str, ...], ...] = ()
    """They object to what a robot that moves is doing, and stop it where nothing else is said: "no", "not that"."""
    closed: frozenset[str] = frozenset()
    """Words that a text slot never swallows: they would change what is meant."""
    pronoun: tuple[tuple[str, ...], ...] = ()
    """Words for a thing that was named before: "it"."""

    @property
    def opening(self) -> tuple[tuple[str, ...], ...]:
        """Words that say nothing where an utterance begins: "and", "but", "first"."""
        return (*self.sequence, *self.contrast, *self.opener)


@dataclass(frozen=True, slots=True)
class Grammar:
    """One language's grammar, from one or more files."""

    language: str
    fillers: tuple[tuple[str, ...], ...]
    """What says nothing, wherever it stands."""
    phrases: Mapping[str, Node]
    slots: Mapping[str, Slot]
    intents: Mapping[str, Intent]
    operators: Operators
    sound_alikes: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Heard word -> words that may have been meant."""
    homophones: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Word -> words of the grammar that sound the same, or are the same word spelled otherwise."""
    wake: tuple[tuple[str, ...], ...] = ()
    """If given, a spoken command must begin with one of these."""
    around: tuple[tuple[str, ...], ...] = ()
    """Fillers before a number, and nowhere else: "about ten seconds"."""
    counting: tuple[tuple[str, ...], ...] = ()
    """Fillers between a number and what is counted, and nowhere else: "two *more* coffees"."""
    counted: tuple[tuple[str, ...], ...] = ()
    """Fillers behind what is counted, and nowhere else: "dos cafés *más*"."""
    wording: Wording = field(default_factory=Wording)
    as_written: Mapping[str, str] = field(default_factory=dict)
    """Words that the files write with a capital or an apostrophe, by the same small and plain: speech is compared with
    both."""
    files: tuple[str, ...] = ()
    warnings: tuple[Problem, ...] = ()
    """What is doubtful though it can be used."""

    @property
    def stop_intent(self) -> str:
        """The name under which a stop is told: every grammar has one, also without an intent for it."""
        return next((intent.name for intent in self.intents.values() if intent.action.type == "stop"), "stop")

    @property
    def dictates(self) -> bool:
        """Whether anything can be dictated."""
        return any(slot.dictation for slot in self.slots.values())
