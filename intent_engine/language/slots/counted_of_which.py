"""Some of the things that there are, with an "of the" behind their number: "five *of the* washers", where a grammar has
"{amount} {object}". All of them, or a part, are no such number."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.numbers.units import units
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.slots.name_words import singular
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["are_of_which", "without_of_which"]


def without_of_which(said: Utterance, language: str) -> Utterance | None:
    """An utterance without the "of the" behind its numbers; None: there is none."""
    other = said
    for start, end in reversed(_places(said, language)):
        other = other.cut(start, end)
    return other if other.words != said.words else None


def are_of_which(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    """Whether each is a whole number of a slot, and of a thing that a list names right behind it."""
    counted = [
        (reading.words[slot.end - 1], reading.words[slot.end])
        for reading in readings
        for slot in reading.slots
        if slot.slot.type == "number" and not slot.slot.units and float(slot.value).is_integer() and slot.value > 0
        if any(other.start == slot.end and other.slot.type == "choice" for other in reading.slots)
    ]
    plurals = thing_words(language).plurals
    for start, end in _places(said, language):
        noun = said.words[end]
        ways = {(said.words[start - 1], word) for word in (noun, *(one for (one,) in singular((noun,), plurals)))}
        found = next((one for one in counted if one in ways), None)
        if found is None:
            return False
        counted.remove(found)
    return True


def _places(said: Utterance, language: str) -> list[tuple[int, int]]:
    """Where an "of the" stands behind a number, in one breath with it and with what follows, which is no number:
    "three of the five cups" may be any three."""
    table, known = units(language), thing_words(language)
    if table is None:
        return []
    nouns = {*table.nouns, *table.words.get("two", ())}  # "a dozen of the rolls", "a couple of those cups"
    which = known.definite | (known.telling_which - known.owning)
    words, found = said.words, list[tuple[int, int]]()
    for start in range(1, len(words) - 1):
        one = known.contracted.get(words[start])
        apart = words[start] in table.words["of"] and words[start + 1] in which
        end = start + (1 if one is not None and one[0] in table.words["of"] else 2 * apart)
        counts = is_number(words[start - 1], language) or words[start - 1] in nouns
        if start < end < len(words) and counts and not any(said.breaks[start : end + 1]):
            if is_number(words[end], language):
                return []
            found.append((start, end))
    return found
