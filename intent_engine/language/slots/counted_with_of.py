"""What is counted behind a noun that is a number, with an "of" between them: "une douzaine *de* pains"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.numbers.units import units
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance

__all__ = ["is_counted_with_of", "without_of"]

_NOUNS = ("two", "million", "billion")


def without_of(said: Utterance, language: str) -> Utterance | None:
    """An utterance without the "of" behind such numbers, as a grammar has what is counted ("{n} pains"); None: there is
    none."""
    other = said
    for place in reversed(_places(said, language)):
        other = other.cut(place, place + 1)
    return other if other.words != said.words else None


def is_counted_with_of(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    """Whether each such number is that of a slot, and no part of a name."""
    numbers = [
        reading.words[slot.end - 1] for reading in readings for slot in reading.slots if slot.slot.type == "number"
    ]
    return all(said.words[place - 1] in numbers for place in _places(said, language))


def _places(said: Utterance, language: str) -> list[int]:
    """Where an "of" stands behind such a noun, in one breath."""
    table = units(language)
    if table is None or language == "en":  # where "a dozen of" is a number by itself
        return []
    nouns = {*table.nouns, *(word for scale in _NOUNS for word in table.words.get(scale, ()))}
    words = said.words
    return [
        place
        for place in range(1, len(words) - 1)
        if words[place] in table.words["of"] and words[place - 1] in nouns and not said.breaks[place]
    ]
