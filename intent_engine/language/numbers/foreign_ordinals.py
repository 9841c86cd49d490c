"""Ordinals of other languages in words and figures: "der dritte", "vingt et unième", "3ª"; through text2num."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache

from intent_engine.language.numbers.foreign import LANGUAGES, number
from intent_engine.language.numbers.numerals import is_numeral, numeral_value
from intent_engine.language.numbers.units import Units, units

__all__ = ["is_ordinal_word", "ordinal"]

_DIGITS = re.compile(r"(\d+)[^\d\s]*")
"""A numeral, with what makes an ordinal of it."""


def ordinal(words: Sequence[str], language: str) -> float | None:
    """ "Dritte", "vingt et unième", "3ème", "3."; a plain number too, and "the last" (-1)."""
    table = units(language) or Units({}, {})
    if not words:
        return None
    if len(words) > 1 and words[0] in table.words.get("the", ()):
        words = words[1:]  # "der dritte"
    if len(words) > 1 and words[0] in table.words.get("number", ()):
        words = words[1:]  # "numéro trois"
    value = number(words, language)
    if value is not None:
        return value if value >= 0 and value.is_integer() else None
    if len(words) == 1 and words[0] in table.words.get("last", ()):
        return -1.0
    if len(words) == 1 and words[0] in table.words.get("second", ()):
        return 2.0
    if len(words) == 2 and is_numeral(words[0]) and words[1] in table.words.get("nth", ()):
        return numeral_value(words[0])
    return _nth(" ".join(words), language)


def is_ordinal_word(word: str, language: str) -> bool:
    """Whether a word is an ordinal of the language, or part of one; a number is one too, as for :func:`ordinal`."""
    table = units(language)
    known = table is not None and any(word in table.words.get(key, ()) for key in ("last", "second", "nth"))
    return known or _nth(word, language) is not None


@lru_cache(maxsize=65536)
def _nth(text: str, language: str) -> float | None:
    """An ordinal in words, as text2num writes it in digits: "3.", "21ème", "1ª"."""
    if language not in LANGUAGES:
        return None
    from text_to_num import alpha2digit

    found = _DIGITS.fullmatch(alpha2digit(text, language, 0))
    return float(found[1]) if found is not None else None
