"""Words to quantities in SI units: the one page that the rest of the language asks. How a number is read with its unit
is in :mod:`~intent_engine.language.numbers.quantity_parser`.

Kinds: ``number``, ``ordinal``, ``distance`` (m), ``angle`` (rad), ``duration`` (s), ``speed`` (m/s),
``angular_speed`` (rad/s), ``percent`` (a fraction of 1).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache

from intent_engine.language.numbers import (
    english,
    english_ordinals,
    english_parts,
    english_words,
    foreign,
    foreign_ordinals,
)
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.quantity_parser import MAX_WORDS, parser_of, tidy
from intent_engine.language.numbers.relative import Relative
from intent_engine.language.numbers.templates import templates
from intent_engine.language.numbers.units import Units, units
from intent_engine.language.slots.quantity_finder import Found, find

__all__ = [
    "MAX_WORDS",
    "Found",
    "Relative",
    "counts",
    "evaluate",
    "find",
    "is_number_word",
    "is_numeral",
    "is_ordinal_word",
    "part_of_one",
    "share",
    "templates",
    "tidy",
]

PART_OF_ONE = 3
"""Words before a unit among which a part of one may be: "a *quarter* of an hour"."""
KEPT = 2048
"""Quantities whose values are remembered: people say the same few over and over, and reading one takes as long as all
else that is done with a plain sentence."""


def is_number_word(word: str, language: str = "en") -> bool:
    """Whether a word is a number of a language, or part of one. Templates spell out the English ones, but not "3rd"."""
    if language == "en":
        return word[:1].isdigit() and not is_numeral(word) and english_ordinals.ordinal([word]) is not None
    return foreign.is_number_word(word, language)


def is_ordinal_word(word: str, language: str = "en") -> bool:
    """Whether a word is a number or an ordinal of a language, or part of one."""
    return is_number_word(word, language) or (language != "en" and foreign_ordinals.is_ordinal_word(word, language))


def people_rest_after(words: Sequence[str], language: str = "en") -> bool:
    """Whether words end in a quantity that people like to add to, after a rest: a single unit ("an hour", "and a half")
    and hours ("two hours", "and twenty minutes"); unless a part of one is in it ("half a minute", "two and a half
    hours")."""
    table = units(language)
    found = table.unit_at_end(words) if table is not None else None
    if table is None or found is None:
        return False
    unit, begin = found
    if not table.parts_of_one.isdisjoint(words[max(0, begin - PART_OF_ONE) : begin]):
        return False
    counts = (evaluate(words[at:begin], "number", language) for at in range(max(0, begin - MAX_WORDS), begin))
    count = next((one for one in counts if isinstance(one, float)), None)
    if count is not None and not count.is_integer():  # "2.5 hours"
        return False
    single = count == 1.0 or table.words.get("one", frozenset()).issuperset(words[begin - 1 : begin])
    return unit == "h" or (begin > 0 and single)


def evaluate(words: Sequence[str], kind: str, language: str = "en", unit: str | None = None) -> float | Relative | None:
    """The value of exactly these words in SI units.

    Args:
        words: normalised words, all of which must belong to the quantity.
        kind: see the module.
        unit: taken if the words carry none, in English ("deg"); None: a unit must be said.

    Returns:
        A finite float; :class:`Relative` for a speed said in terms of the usual one; None if the words are no
        such quantity.
    """
    if not words or len(words) > MAX_WORDS:
        return None
    return _evaluated(tuple(words), kind, language, unit)


@lru_cache(maxsize=KEPT)
def _evaluated(words: tuple[str, ...], kind: str, language: str, unit: str | None) -> float | Relative | None:
    if kind == "number":
        return _whole(parser_of(language).numbers_at(words, 0), len(words))
    if kind == "ordinal":
        return english_ordinals.ordinal(words) if language == "en" else foreign_ordinals.ordinal(words, language)
    table = units(language)
    if table is None:
        return None
    parser = parser_of(language)
    if kind in ("speed", "angular_speed"):
        relative = table.speeds.get(" ".join(words))
        if relative is not None:
            return Relative(relative)
        share = words[: _speed_begins(words, table)]
        percent = _whole(parser.quantities_at(share, 0, "percent"), len(share)) if len(share) > 1 else None
        if percent is not None and math.isfinite(percent):
            return Relative(percent) if 0 < percent <= 2 else None
    value = _whole(parser.quantities_at(words, 0, kind), len(words))
    if value is None and unit is not None:
        number = _whole(parser.numbers_at(words, 0), len(words))
        if kind == "angle" and words[-1] in english_words.HALVES and number is not None and number < 1:
            return None  # "a quarter" of a turn, or of what? Never 0.25 degrees
        factor = parser_of("en").factor(unit, kind)  # grammar files write units in English, whatever is spoken
        if number is not None and factor is not None:
            value = tidy(number * factor)
    if value is None or not math.isfinite(value) or (kind == "angle" and _in_two_pieces(words, value, language)):
        return None
    if language == "en" and english.may_be_from_to(words):
        return None  # a plain number may be a name: "room five ten"
    return value


def _speed_begins(words: Sequence[str], table: Units) -> int:
    """Where the words for what a percentage is of begin, "of the speed"; the end: it is said without."""
    said = table.words.get("speed", frozenset())
    return next((at for at in range(1, len(words)) if " ".join(words[at:]) in said), len(words))


def _in_two_pieces(words: Sequence[str], angle: float, language: str) -> bool:
    """Whether "five ten degrees" are two numbers, of which the second puts the first right: nobody turns by 510.
    Hundreds are left out of angles up to a whole turn ("one eighty"), and of quarter turns ("seven twenty")."""
    quarters = abs(angle) / (math.pi / 2)
    left_out = language == "en" and english.leaves_hundred_out(words)
    return left_out and quarters > 4 and not math.isclose(quarters, round(quarters))


def counts(words: Sequence[str], language: str = "en") -> Iterator[tuple[float, int]]:
    """How many of something the words begin with, and where that ends: "two", "half a", "another"."""
    yield from parser_of(language).counts_at(words, 0)


def part_of_one(words: Sequence[str], language: str = "en") -> float | None:
    """How much of one thing the words say, before the word for it: "half a", "three quarters of a"; None: nothing."""
    if len(words) < 2 or words[-1] not in (units(language) or Units({}, {})).words.get("one", ()):
        return None
    return next((value for value, after in counts(words, language) if after == len(words)), None)


def share(words: Sequence[str], language: str = "en") -> float | None:
    """How much of the whole exactly these words say, above 0 and at most 1: "half", "two thirds", "1/2", "full", "die
    Hälfte"; None: nothing.

    What is written with a point is no such share: "0.5" may be half a percent.
    """
    table = units(language)
    if not words or table is None:
        return None
    if " ".join(words) in table.words.get("all_of_it", ()):
        return 1.0
    if " ".join(words[words[0] in table.words.get("the", ()) :]) in table.words.get("half_of_it", ()):
        return 0.5
    part = english_parts.fraction(words, 0) if language == "en" else foreign.fraction(words, 0, language)
    return part[0] if part is not None and part[1] == len(words) and 0 < part[0] < 1 else None


def _whole(found: Iterator[tuple[float, int]], length: int) -> float | None:
    return next((value for value, after in found if after == length and math.isfinite(value)), None)
