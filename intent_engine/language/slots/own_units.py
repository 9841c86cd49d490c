"""Units that a grammar has of its own: "two steps", "half a crate", with their size in SI."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

from intent_engine.language import quantities
from intent_engine.language.grammar import Slot
from intent_engine.language.numbers import english, english_parts, english_words, foreign
from intent_engine.language.numbers.units import units
from intent_engine.language.templates.spellings import spellings
from intent_engine.language.templates.template_tree import Node

__all__ = ["MAX_NAMES", "OwnUnits", "hundredth", "units_called"]

MAX_NAMES = 200
"""Ways to say one unit."""


def units_called(slot: Slot, phrases: Mapping[str, Node]) -> Iterator[tuple[float, list[tuple[str, ...]]]]:
    """The size of each unit of a slot, and what it is called, the shortest names first."""
    for size, node in slot.units:
        yield size, sorted(spellings(node, phrases, MAX_NAMES), key=len)


def hundredth(size: float, sizes: Iterable[float]) -> float | None:
    """The one of some units that is a hundredth of another: cents of a euro; None: there is none."""
    return next((other for other in sizes if math.isclose(other * 100, size)), None)


class OwnUnits:
    """The units of one slot."""

    def __init__(self, slot: Slot, phrases: Mapping[str, Node], language: str) -> None:
        self._language = language
        self._sizes = {words: size for size, names in units_called(slot, phrases) for words in names}
        self._ends = frozenset(words[-1] for words in self._sizes)

    def value(self, words: Sequence[str]) -> float | None:
        """The value in SI units of exactly these words, normalised: how many, the unit, and perhaps "and a half" or how
        many of a smaller one: "two kilos three hundred grams"."""
        may_be_two = self._language == "en" and english.may_be_from_to(words)
        return self._below(words, math.inf) if not may_be_two else None

    def is_unit(self, words: Sequence[str]) -> bool:
        """Whether words are one of them, without how many there are."""
        return tuple(words) in self._sizes

    def _below(self, words: Sequence[str], largest: float) -> float | None:
        """The same of units that are smaller than that."""
        if self._ends.isdisjoint(words) or len(words) > quantities.MAX_WORDS:
            return None
        for count, after in self._counts(words):
            for end in range(len(words), after, -1):
                size = self._sizes.get(tuple(words[after:end]))
                if size is None or size >= largest:
                    continue
                if end == len(words):
                    return quantities.tidy(count * size)
                if not count.is_integer():
                    continue
                whole, sign = count * size, math.copysign(1.0, count)  # below zero it is so with its parts
                if (part := self._part(words[end:])) is not None:
                    return quantities.tidy(whole + sign * part * size)
                if (hundredths := self._hundredths(words[end:], size)) is not None:
                    return quantities.tidy(whole + sign * hundredths)
                more = self._below(self._without_and(words[end:]), size)
                if more is not None and 0 <= more < size:
                    return quantities.tidy(whole + sign * more)
        return None

    def _hundredths(self, words: Sequence[str], size: float) -> float | None:
        """What a number alone counts behind a unit of which the slot has the hundredth: "two euros *fifty*"."""
        small = hundredth(size, self._sizes.values())
        count = quantities.evaluate(words, "number", self._language) if small is not None else None
        if small is None or not isinstance(count, float) or not count.is_integer() or not 0 < count < 100:
            return None
        return count * small

    def _counts(self, words: Sequence[str]) -> Iterator[tuple[float, int]]:
        """How many there are and where that ends: of "5 k" 5, where the slot has a "k", and else 5000."""
        sign = next((at for at, word in enumerate(words) if at and self._is_sign(word)), len(words))
        yield from quantities.counts(words[:sign], self._language)

    def _is_sign(self, word: str) -> bool:
        """Whether a letter that may stand for thousands is a unit of the slot."""
        return (word,) in self._sizes and word in english_words.SUFFIXES

    def _without_and(self, words: Sequence[str]) -> Sequence[str]:
        table = units(self._language)
        led = table is not None and bool(words) and words[0] in table.words.get("and", ())
        return words[1:] if led else words

    def _part(self, words: Sequence[str]) -> float | None:
        """What is said after a unit: "and a half"."""
        table = units(self._language)
        if table is None or not words or words[0] not in table.words.get("and", ()):
            return None
        part = (
            english_parts.fraction(words, 1) if self._language == "en" else foreign.fraction(words, 1, self._language)
        )
        return part[0] if part is not None and part[0] < 1 and part[1] == len(words) else None
