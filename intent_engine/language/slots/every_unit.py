"""One or two of a unit that are said without a number: "every hour" for "every one hour", as people say how often, and
"every other hour" for "every two hours"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import QUANTITY_KINDS
from intent_engine.language.numbers.units import LONGEST, units
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance

__all__ = ["every_one", "is_every_one"]

_ONE, _TWO = "1", "2"


def every_one(said: Utterance, language: str) -> Utterance | None:
    """An utterance with a one between "every" and the unit right behind it, or with a two for the "other" between them;
    None: it has none of that."""
    places = _places(said, language)
    if not places:
        return None
    words, breaks = list(said.words), list(said.breaks)
    for place, number in reversed(places):
        begin = place - (number == _TWO)
        words[begin:place] = [number]
        breaks[begin:place] = [False]
    return Utterance(words, breaks)


def is_every_one(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    """Whether each such number of an utterance begins a quantity, how often or how far apart, and is no name or
    text."""
    begun = {
        tuple(reading.words[slot.start - 1 : slot.start + 2])
        for reading in readings
        for slot in reading.slots
        if slot.slot.type in QUANTITY_KINDS and reading.words[slot.start : slot.start + 1] in ((_ONE,), (_TWO,))
    }
    words = said.words
    return all(
        (words[place - 1 - (number == _TWO)], number, words[place]) in begun
        for place, number in _places(said, language)
    )


def _places(said: Utterance, language: str) -> list[tuple[int, str]]:
    """Where units stand right behind an "every", or an "every other", in one breath, and of how many there are."""
    table = units(language)
    every = table.words.get("every", frozenset[str]()) if table is not None else frozenset[str]()
    if table is None or not every:
        return []
    others = table.words.get("every_other", frozenset[str]())
    kinds = [unit for kind in ("distance", "duration", "angle") for unit in table.by_kind.get(kind, {})]
    words, found = said.words, []
    for place in range(1, len(words)):
        other = words[place - 1] in others and not said.breaks[place - 1]
        end = place - other
        led = any(" ".join(words[max(end - length, 0) : end]) in every for length in (1, 2))
        unit = any(tuple(words[place : place + length]) in kinds for length in range(1, LONGEST + 1))
        if led and unit and not said.breaks[place]:
            found.append((place, _TWO if other else _ONE))
    return found
