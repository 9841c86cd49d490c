"""Half of one more, said behind what is counted: "sept tonnes *et demie*", where a grammar has "{n} tonnes"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.numbers.units import units
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance

__all__ = ["half_before", "is_half_of_it"]


def half_before(said: Utterance, language: str) -> Utterance | None:
    """An utterance with such halves behind their numbers: "sept et demie tonnes"; None: there is none."""
    other = said
    for place in _places(said, language):
        noun, joint, half = said.words[place : place + 3]
        other = other.with_other(place, place + 3, Utterance.in_one_breath([joint, half, noun]))
    return other if other.words != said.words else None


def is_half_of_it(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    """Whether each is a part of a number, of which the sentence says what is counted."""
    ends = {
        (reading.words[slot.end - 1], *reading.words[slot.end : slot.end + 1])
        for reading in readings
        for slot in reading.slots
        if slot.slot.type == "number"
    }
    return all((said.words[place + 2], said.words[place]) in ends for place in _places(said, language))


def _places(said: Utterance, language: str) -> list[int]:
    """Where what is counted stands before such a half, in one breath with a number before it."""
    table = units(language)
    if table is None:
        return []
    words, joints, halves = said.words, table.words["and"], table.words["half"]
    return [
        place
        for place in range(1, len(words) - 2)
        if words[place + 1] in joints
        and words[place + 2] in halves
        and not any(said.breaks[place : place + 3])
        and is_number(words[place - 1], language)
        and not is_number(words[place], language)
    ]
