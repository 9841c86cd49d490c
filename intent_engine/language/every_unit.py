"""One of a unit that is said without a number: "every hour" for "every one hour", as people say how often."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import QUANTITY_KINDS
from intent_engine.language.numbers.units import LONGEST, units
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance

__all__ = ["every_one", "is_every_one"]

_ONE = "1"


def every_one(said: Utterance, language: str) -> Utterance | None:
    """An utterance with a one between "every" and the unit right behind it; None: it has no such two."""
    places = _places(said, language)
    if not places:
        return None
    words, breaks = list(said.words), list(said.breaks)
    for place in reversed(places):
        words.insert(place, _ONE)
        breaks.insert(place, False)
    return Utterance(words, breaks)


def is_every_one(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    """Whether each such one of an utterance begins a quantity, how often or how far apart, and is no name or text."""
    begun = {
        tuple(reading.words[slot.start - 1 : slot.start + 2])
        for reading in readings
        for slot in reading.slots
        if slot.slot.type in QUANTITY_KINDS and reading.words[slot.start : slot.start + 1] == (_ONE,)
    }
    words = said.words
    return all((words[place - 1], _ONE, words[place]) in begun for place in _places(said, language))


def _places(said: Utterance, language: str) -> list[int]:
    """Where units stand right behind an "every", in one breath."""
    table = units(language)
    every = table.words.get("every", frozenset[str]()) if table is not None else frozenset[str]()
    if table is None or not every:
        return []
    kinds = [unit for kind in ("distance", "duration", "angle") for unit in table.by_kind.get(kind, {})]
    found = []
    for place in range(1, len(said.words)):
        led = any(" ".join(said.words[max(place - length, 0) : place]) in every for length in (1, 2))
        unit = any(tuple(said.words[place : place + length]) in kinds for length in range(1, LONGEST + 1))
        if led and unit and not said.breaks[place]:
            found.append(place)
    return found
