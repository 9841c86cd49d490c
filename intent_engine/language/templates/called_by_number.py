"""A number that is a name, said with that word: "row number seven" for "row seven"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.numbers.units import units
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["is_called_so", "without_number"]


def without_number(said: Utterance, language: str) -> Utterance | None:
    """An utterance without the word "number" between what is called so and its number; None: it has none."""
    places = _places(said, language)
    if not places:
        return None
    kept = [place for place in range(len(said.words)) if place not in places]
    return Utterance([said.words[place] for place in kept], [said.breaks[place] for place in kept])


def is_called_so(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    """Whether each such number names what a word of the sentence before it says, and counts nothing behind it: "door
    number three times" is no "three times"."""
    joining = thing_words(language).joining
    named = {
        reading.words[slot.start - 1 : slot.start + 1]
        for reading in readings
        for slot in reading.slots
        if slot.slot.type == "number"
        and not any(other.end == slot.start for other in reading.slots)
        and (slot.end == len(reading.words) or reading.words[slot.end] in joining)
    }
    words = said.words
    return all((words[place - 1], words[place + 1]) in named for place in _places(said, language))


def _places(said: Utterance, language: str) -> list[int]:
    """Where such words stand, in one breath with a word before and a number behind them."""
    table = units(language)
    numbers = table.words.get("number", frozenset[str]()) if table is not None else frozenset[str]()
    words, breaks = said.words, said.breaks
    return [
        place
        for place in range(2, len(words) - 1)
        if words[place] in numbers
        and not any(breaks[place : place + 2])
        and is_number(words[place + 1], language)
        and not is_number(words[place - 1], language)
    ]
