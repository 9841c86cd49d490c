"""Where one name ends and the next begins: in "put the cup on the table in the kitchen" the cup may be on the table, or
the table in the kitchen.

An automaton has one way to part the names of a sentence. The others are looked for here, and asked about where they
would be another action.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.matcher import Matcher
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.slots.action_builder import names_taken
from intent_engine.language.slots.names_apart import named_otherwise
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["WhosePlace"]

NAME = "\0name"
"""Stands for a name, as a word that no grammar has."""
MOST_BETWEEN = 3
"""Words between two names: "up off of", "that is on"."""


@dataclass(frozen=True, slots=True)
class _Way:
    """One way to part some words: a name up to ``end``, and another from ``start`` on."""

    one: SlotReading
    other: SlotReading


class WhosePlace:
    """The ways to part the names of one grammar's sentences. Thread-safe."""

    def __init__(self, matcher: Matcher) -> None:
        self._matcher = matcher
        words = thing_words(matcher.grammar.language)
        self._joining = words.joining
        self._particles = words.alone - words.joining
        """Words that belong to the verb: "down" of "put the cup down on the table"."""
        self._pronouns = PhraseSet(matcher.grammar.operators.pronoun)

    def settled(self, reading: Reading) -> tuple[Reading, tuple[Reading, ...], str]:
        """A reading with its names parted where they are meant to be; else also all that it may be, and what is not
        clear about it.

        "It" is a whole name, so that "put it on the table in the kitchen" is clear. Where the action takes only the
        first name, what follows says where that one is, however it is parted: "pick up the cup on the table in the
        kitchen" takes a cup. All else is for the person to say; so are names of lists, of which one ends as another
        begins.
        """
        if len(reading.slots) > 1 and (otherwise := self._of_lists(reading)) is not None:
            return reading, (reading, otherwise), "it could mean two things"
        if reading.free_words < 2:  # no name goes on
            return reading, (), ""
        slots = sorted(reading.slots, key=lambda slot: slot.start)
        for one, other in pairwise(slots):
            if not (self._may_go_on(reading, one) or self._may_go_on(reading, other)):
                continue
            if other.slot.type not in FREE_KINDS or not self._matcher.values.is_thing(one.slot) or one.slot.dictation:
                continue
            ways = self._ways(reading, one, other)
            if len(ways) < 2 and ways[0].one is one:
                continue
            first, last = ways[0], ways[-1]
            taken = names_taken(reading.intent, reading.values())
            whole = self._pronouns.cover(reading.words[first.one.start : first.one.end])
            if whole or (one.label in taken and other.label not in taken):
                reading = self._parted(reading, next((way for way in ways if self._fits(reading, way)), first))
            elif one.label in taken or other.label in taken:
                said = reading.words
                between = " ".join(said[first.one.end : last.one.end])
                behind = " ".join(said[last.one.end : last.other.end])
                reason = f"whether {between!r} belongs to {first.one.value!r} or to {behind!r} is not clear"
                return reading, tuple(self._parted(reading, way) for way in ways), reason
        return reading, (), ""

    def _of_lists(self, reading: Reading) -> Reading | None:
        """The same words with other names of lists in them."""
        words, read = list(reading.words), self._matcher.values.from_words
        slots = named_otherwise(
            reading.slots, words, lambda one, begin, end: read(one.slot, one.label, words[begin:end], begin)
        )
        return replace(reading, slots=slots) if slots is not None else None

    def _may_go_on(self, reading: Reading, name: SlotReading) -> bool:
        """A quick look: whether a word within a name may stand between two."""
        return name.slot.type in FREE_KINDS and not self._joining.isdisjoint(reading.words[name.start + 1 : name.end])

    def _ways(self, reading: Reading, one: SlotReading, other: SlotReading) -> list[_Way]:
        """All ways to part the words of two names and what stands between them."""
        found = {(one.value, other.value): _Way(one, other)}
        words, begin, stop = reading.words, one.start, other.end
        for end in range(begin + 1, stop - 1):
            if words[end] not in self._joining and end != one.end:
                continue
            for start in range(end + 1, min(end + MOST_BETWEEN, stop - 1) + 1):
                if (end, start) != (one.end, other.start) and self._joins(reading, one, other, end, start):
                    way = self._way(reading, one, other, end, start)
                    if way is not None:
                        found.setdefault((way.one.value, way.other.value), way)
        # "Next to" stands between two names as a whole: nothing is called "cup next".
        ways: dict[int, _Way] = {}
        for way in sorted(found.values(), key=lambda way: way.one.end):
            ways.setdefault(way.other.start, way)
        first, *others = ways.values()
        return [first] if words[first.one.end] in self._particles else [first, *others]

    def _joins(self, reading: Reading, one: SlotReading, other: SlotReading, end: int, start: int) -> bool:
        """Whether the words between two places may stand between these names, by some sentence of the intent."""
        words = reading.words
        said = [*words[: one.start], NAME, *words[end:start], NAME, *words[other.end :]]
        after = reading.intent.name if any(reading.sentence is later for later in reading.intent.then) else ""
        at = one.start + 1 + start - end
        rest = self._besides(reading, one, other)
        return any(
            not found.problem and found.intent is reading.intent and rest == self._besides(found, *named)
            for found in self._matcher.read(said, after=after)
            if (named := _named(found, (one.label, one.start), (other.label, at))) is not None
        )

    def _besides(self, reading: Reading, one: SlotReading, other: SlotReading) -> dict[str, object]:
        return {label: value for label, value in reading.values().items() if label not in (one.label, other.label)}

    def _way(self, reading: Reading, one: SlotReading, other: SlotReading, end: int, start: int) -> _Way | None:
        words, read = list(reading.words), self._matcher.values.text
        first = read(one.slot, one.label, words, one.start, end)
        second = read(other.slot, other.label, words, start, other.end)
        return _Way(first, second) if not (first.problem or second.problem) else None

    def _fits(self, reading: Reading, way: _Way) -> bool:
        """Whether neither name has more words than its slot takes."""
        names, has_room = (way.one, way.other), self._matcher.values.has_room
        return all(has_room(name.slot, reading.words[name.start : name.end]) for name in names)

    def _parted(self, reading: Reading, way: _Way) -> Reading:
        names = {way.one.label: way.one, way.other.label: way.other}
        return replace(reading, slots=tuple(names.get(slot.label, slot) for slot in reading.slots))


def _named(reading: Reading, *places: tuple[str, int]) -> tuple[SlotReading, SlotReading] | None:
    """The slots of two labels, if each holds the one word at its place."""
    found = [
        slot
        for label, place in places
        for slot in reading.slots
        if (slot.label, slot.start, slot.end) == (label, place, place + 1)
    ]
    return (found[0], found[1]) if len(found) == 2 else None
