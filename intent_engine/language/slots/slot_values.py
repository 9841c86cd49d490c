"""What a slot holds: the value of the words that were said for it, or why they have none."""

from __future__ import annotations

import threading
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from intent_engine.language import quantities
from intent_engine.language.grammar import FREE_KINDS, QUANTITY_KINDS, Grammar, Slot
from intent_engine.language.names import NameIndex
from intent_engine.language.normalize import elided
from intent_engine.language.numbers import english, foreign
from intent_engine.language.numbers.digit_by_digit import said_together
from intent_engine.language.numbers.units import units
from intent_engine.language.reading import SlotReading
from intent_engine.language.slots.free_text import FreeText
from intent_engine.language.slots.led_things import LedThings
from intent_engine.language.slots.own_units import OwnUnits
from intent_engine.language.templates.spellings import spellings
from intent_engine.language.words.thing_words import thing_words

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["NamesOf", "SlotValues"]

MAX_SPELLINGS = 64
"""Ways of saying one choice value that are compared with misheard words."""
LEAST_OF_TWO = 2
"""Words of a number that can be two, or have a sign."""
LEAST_BEFORE_NAME = 2
"""Words before the number of a name: a verb, and what is called so."""


class SlotValues:
    """The values of one grammar's slots and one map. Thread-safe."""

    def __init__(self, grammar: Grammar, locations: LocationMap | None, free: FreeText) -> None:
        self._grammar = grammar
        self._locations = locations
        self._free = free
        self._led = LedThings(grammar)
        self._indexes: dict[str, NameIndex] = {}
        self._index_lock = threading.Lock()
        self._units = {
            slot.name: OwnUnits(slot, grammar.phrases, grammar.language)
            for slot in grammar.slots.values()
            if slot.units
        }

    def read(
        self, slot: Slot, label: str, words: list[str], start: int, end: int, value: Any, loosely: bool
    ) -> SlotReading:
        if slot.type in QUANTITY_KINDS:
            found = self._quantity(slot, label, words[start:end], start, end, before_word=end < len(words))
            return self._as_one_number(found, words) if self._grammar.language == "en" else found
        if slot.type in FREE_KINDS:
            if not self.has_room(slot, words[start:end]):  # the "a" of "a 42 red" is a part of the name
                problem = f"{' '.join(words[start:end])!r} has more words than slot {slot.name!r} takes"
                return SlotReading(label, slot, start, end, None, 0.0, (), "unknown", problem)
            return self.text(slot, label, words, start, end)
        if not loosely:
            return SlotReading(label, slot, start, end, value)
        return self._name(slot, label, words[start:end], start, end)

    def text(self, slot: Slot, label: str, words: list[str], start: int, end: int) -> SlotReading:
        """What words name in a free slot, however many they are."""
        said = words[start:end]
        problem = self._free.problem(slot, words, start, end)
        status = "unknown"
        unfinished = self._free.is_unfinished(slot, said, start) or self._free.is_left_out(slot, words, start, end)
        if not problem and unfinished:
            problem, status = f"the sentence is not finished: {' '.join(said)!r}", "unfinished"
        if not problem and (word := self._free.no_handful(slot, said)):
            problem = f"{word!r} is nothing for slot {slot.name!r}"
        if not problem and self._free.tells_when(slot, said):
            problem = f"{' '.join(said)!r} says when or for how long, and is nothing for slot {slot.name!r}"
        if not problem and self._free.is_thing(slot) and self._led.tells_a_way(slot, said):
            problem = f"{' '.join(said)!r} says where, and is nothing for slot {slot.name!r}"
        if not problem and self._free.is_amount(slot, said):
            problem = f"{' '.join(said)!r} is an amount, and nothing for slot {slot.name!r}"
        if problem:
            return SlotReading(label, slot, start, end, None, 0.0, (), status, problem)
        thing = self._free.thing(slot, said)
        return SlotReading(label, slot, start, end, elided(thing, self._grammar.language))

    def _quantity(
        self, slot: Slot, label: str, said: list[str], start: int, end: int, *, before_word: bool = False
    ) -> SlotReading:
        if slot.digits:
            said = list(said_together(said, self._grammar.language))
        value: float | quantities.Relative | None = self.in_own_units(slot, said)  # "5 k" are no 5000 to one with a "k"
        if value is None and slot.type == "percent":
            value = quantities.share(said, self._grammar.language)  # "half" is never half a percent
        if value is None and (slot.type != "number" or slot.bare):
            value = quantities.evaluate(said, slot.type, self._grammar.language, slot.unit)
        if value is None and slot.type == "number" and slot.bare and before_word:
            value = quantities.part_of_one(said, self._grammar.language)
        problem = ""
        status = "exact"
        if value is None:
            article = "an" if slot.type[0] in "aeiou" else "a"
            problem = f"{' '.join(said)!r} is not {article} {slot.type.replace('_', ' ')}"
            status = "unknown"
        elif isinstance(value, float) and (beyond := slot.beyond(value)) is not None:
            problem, status = f"{label} of {slot.written(value)} is {beyond[1]}", "limit"
        elif isinstance(value, float):
            value = slot.counted(value)
        return SlotReading(label, slot, start, end, value, problem=problem, status=status)

    def _as_one_number(self, found: SlotReading, words: Sequence[str]) -> SlotReading:
        """An English quantity as it was read, without a value if it may be no one number: of "five ten tablets" nobody
        knows how many are meant ("room five ten" has its name). Or if its plus may add to what it is now, since none is
        below zero: "dim to plus five percent"."""
        slot, said = found.slot, words[found.start : found.end]
        if found.problem or len(said) < LEAST_OF_TWO:
            return found
        a_row = slot.digits and len(said_together(said, "en")) == 1
        if slot.type == "number" and not a_row and english.may_be_from_to(said) and not self._is_name(found, words):
            problem = f"{' '.join(said)!r} could be one number or two"
        elif "plus" in said and slot.smallest is not None and slot.smallest >= 0:
            problem = f"{' '.join(said)!r} may add to what it is now; say how much it shall be"
        else:
            return found
        return replace(found, value=None, status="unknown", problem=problem)

    def _is_name(self, found: SlotReading, words: Sequence[str]) -> bool:
        """Whether a number names what is called so before it, and counts nothing: "go to room *five ten*"."""
        joining = thing_words(self._grammar.language).joining
        led = found.start >= LEAST_BEFORE_NAME and words[found.start - 1] not in joining
        return led and (found.end == len(words) or words[found.end] in joining)

    def has_room(self, slot: Slot, said: Sequence[str]) -> bool:
        """Whether a free slot takes so many words, as :meth:`FreeText.has_room` has it."""
        return self._free.has_room(slot, said)

    def tells_besides(self, slot: Slot, words: Sequence[str]) -> bool:
        """Whether words behind a pause tell of something besides, as :meth:`FreeText.tells_besides` has it."""
        return self._free.tells_besides(slot, words)

    def is_thing(self, slot: Slot) -> bool:
        """Whether a slot holds the name of a thing, as :meth:`FreeText.is_thing` has it."""
        return self._free.is_thing(slot)

    def in_own_units(self, slot: Slot, said: Sequence[str]) -> float | None:
        """What words are in the units that only this slot has, in SI; None: nothing."""
        own = self._units.get(slot.name)
        return own.value(said) if own is not None else None

    def is_unit(self, slot: Slot, said: Sequence[str]) -> bool:
        """Whether words are a unit of a quantity, and nothing else."""
        own, table = self._units.get(slot.name), units(self._grammar.language)
        usual = table.by_kind.get(slot.type, {}) if table is not None else {}
        return (own is not None and own.is_unit(said)) or tuple(said) in usual

    def _name(self, slot: Slot, label: str, said: list[str], start: int, end: int) -> SlotReading:
        match = self.index(slot).resolve(said)
        if match.status == "unknown" and self._grammar.language != "en":  # the index knows English numbers and articles
            match = self.index(slot).resolve(self._as_named(said))
        words = " ".join(said)
        problem = ""
        if match.status == "unknown":
            kind = "place" if slot.type == "location" else label
            problem = f"no {kind} is called {words!r}"
        elif match.status == "ambiguous":
            problem = f"{words!r} could be {' or '.join(name for name, _ in match.candidates[:3])}"
        return SlotReading(
            label,
            slot,
            start,
            end,
            match.name if not problem else None,
            score=match.score if not problem else 0.0,
            rivals=tuple(match.candidates),
            status=match.status,
            problem=problem,
        )

    def _as_named(self, said: Sequence[str]) -> tuple[str, ...]:
        """A name as maps have it: numbers in digits, no article before it."""
        language = self._grammar.language
        articles = thing_words(language).articles
        first = next((place for place, word in enumerate(said[:-1]) if word not in articles), len(said) - 1)
        return foreign.in_digits(said[first:], language)

    def from_words(self, slot: Slot, label: str, said: list[str], start: int = 0) -> SlotReading:
        """What a slot holds if it is exactly these words, for patterns that find the words themselves.

        Args:
            slot: the slot.
            label: name under which its value is given.
            said: the words.
            start: place of the first among those of the sentence.
        """
        end = len(said)
        if slot.type in ("choice", "boolean", "location"):
            reading = self._name(slot, label, said, 0, end)
        elif slot.type in FREE_KINDS and not self._grammar.operators.closed.isdisjoint(
            set(said) - slot.allow - slot.known
        ):
            problem = f"{' '.join(said)!r} holds a word that changes what is meant"
            reading = SlotReading(label, slot, 0, end, None, 0.0, (), "unknown", problem)
        elif slot.type in FREE_KINDS:  # of as many words as the pattern says
            reading = self.text(slot, label, said, 0, end)
        else:
            reading = self.read(slot, label, said, 0, end, None, False)
        return replace(reading, start=start, end=start + end)

    def index(self, slot: Slot) -> NameIndex:
        """The fuzzy index of a location or choice slot, made at first use."""
        if slot.type == "location" and not slot.tags and self._locations is not None:
            return self._locations.index_in(self._grammar.language)
        with self._index_lock:
            index = self._indexes.get(slot.name)
            if index is None:
                index = self._indexes[slot.name] = NameIndex(list(self._spellings(slot)), self._grammar.language)
            return index

    def _spellings(self, slot: Slot) -> Iterator[tuple[str, str]]:
        if slot.type == "location":
            for words, name in NamesOf(self._locations, slot.tags, self._grammar.language):
                yield " ".join(words), name
            return
        for value, node in slot.values:
            for words in spellings(node, self._grammar.phrases, MAX_SPELLINGS):
                yield " ".join(words), value


@dataclass(frozen=True)
class NamesOf(Sequence[tuple[tuple[str, ...], str]]):
    """The names of a map, listed only when the walk first comes to a place."""

    locations: LocationMap | None
    tags: frozenset[str]
    language: str
    """Of the grammar: of its articles a name needs none ("Die Halle")."""

    def __iter__(self) -> Iterator[tuple[tuple[str, ...], str]]:
        articles = thing_words(self.language).articles if self.language != "en" else frozenset[str]()
        led: list[tuple[tuple[str, ...], str]] = []
        for words, name in self._names():
            yield words, name
            if len(words) > 1 and words[0] in articles:
                led.append((words[1:], name))
        if led:
            others = {words for words, _ in self._names()}
            yield from ((words, name) for words, name in led if words not in others)

    def _names(self) -> Iterator[tuple[tuple[str, ...], str]]:
        if self.locations is None:
            return
        for words, name in self.locations.names():
            if self.tags:
                place = self.locations.get(name)
                if place is None or not self.tags & set(place.tags):
                    continue
            yield words, name

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __getitem__(self, index: Any) -> Any:
        return list(self)[index]
