"""A number that is a name, said with that word, "row number seven" for "row seven", or in order: "the seventh row"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from intent_engine.language import quantities
from intent_engine.language.loading.language_words import default_parted
from intent_engine.language.numbers.units import units
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["InOrder", "in_order", "is_called_so", "without_number"]

MOST_OF_AN_ORDINAL = 3
"""Words of an ordinal: "hundred twenty first"."""


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
    named = _named(readings, language)
    words = said.words
    verbs = {reading.words[0] for reading in readings}  # "Pumpe Nummer zwei einschalten", but "take number seven"
    return all(
        (words[place - 1], words[place + 1]) in named and (place > 1 or words[0] not in verbs)
        for place in _places(said, language)
    )


@dataclass(frozen=True, slots=True)
class InOrder:
    """What was said of one in order, and the same by its number."""

    said: str
    """The words that told it: "the third drawer"."""
    meant: tuple[Utterance, ...]
    """The whole utterance with the number, with its article and without: "open drawer 3"."""
    noun: str
    number: str

    def is_named(self, readings: Sequence[Reading], language: str) -> bool:
        """Whether its number names what a word of a sentence before it says, and counts nothing behind it."""
        return (self.noun, self.number) in _named(readings, language)


def in_order(said: Utterance, language: str) -> InOrder | None:
    """What an utterance says of one in order, "the third drawer"; None: nothing, or of several."""
    known, words = thing_words(language), said.words
    found: list[tuple[int, int, int]] = []
    at = 0
    while at < len(said) - 1:
        value, end = _ordinal(said, at, language)
        if value is not None and not is_number(words[end], language):
            found.append((at, end, value))
        at = max(end, at + 1)
    if len(found) != 1:
        return None
    (start, end, value), before = found[0], words[: found[0][0]]
    begin = start - (bool(before) and before[-1] in (known.definite or known.articles))
    if begin == start and before and (before[-1] in known.articles or is_number(before[-1], language)):
        return None  # "a third drawer"
    noun, number = words[end], str(value)
    ways = (
        Utterance(
            [*words[:at], noun, number, *words[end + 1 :]], [*said.breaks[: at + 1], False, *said.breaks[end + 1 :]]
        )
        for at in sorted({begin, start}, reverse=True)
    )
    return InOrder(" ".join(words[begin : end + 1]), tuple(ways), noun, number)


def _named(readings: Sequence[Reading], language: str) -> set[tuple[str, ...]]:
    """The words that name something by the number behind them, each with its number."""
    joining = thing_words(language).joining | default_parted(language)
    return {
        reading.words[slot.start - 1 : slot.start + 1]
        for reading in readings
        for slot in reading.slots
        if slot.slot.type == "number"
        and not any(other.end == slot.start for other in reading.slots)
        and (slot.end == len(reading.words) or reading.words[slot.end] in joining)
    }


def _ordinal(said: Utterance, at: int, language: str) -> tuple[int | None, int]:
    """The ordinal that begins at a word, in one breath with one behind it, and where it ends."""
    for end in range(min(at + MOST_OF_AN_ORDINAL, len(said) - 1), at, -1):
        words = said.words[at:end]
        if words[0] in thing_words(language).articles:
            break
        if any(said.breaks[at + 1 : end + 1]) or quantities.evaluate(words, "number", language) is not None:
            continue
        value = quantities.evaluate(words, "ordinal", language)
        if isinstance(value, float) and value > 0:
            return int(value), end
    return None, at


def _places(said: Utterance, language: str) -> list[int]:
    """Where such words stand, in one breath with a word before and a number behind them."""
    table = units(language)
    numbers = table.words.get("number", frozenset[str]()) if table is not None else frozenset[str]()
    words, breaks = said.words, said.breaks
    return [
        place
        for place in range(1, len(words) - 1)
        if words[place] in numbers
        and not any(breaks[place : place + 2])
        and is_number(words[place + 1], language)
        and not is_number(words[place - 1], language)
    ]
