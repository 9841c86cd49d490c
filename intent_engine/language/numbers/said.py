"""Whole numbers of other languages than English in words, by the rules of the Unicode CLDR: "45", "fünfundvierzig"."""

from __future__ import annotations

import re
from functools import cache, lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from unicode_rbnf import RbnfEngine

__all__ = ["LARGEST", "spell", "usual"]

RULES = "spellout-numbering"
"""The name of the rules for counting, in every language."""
LARGEST = 999_999
"""Larger numbers are not said to robots."""
USUAL = (*range(101), *range(105, 361, 5), 400, 450, 500, 540, 600, 700, 720, 750, 800, 900, 1000)
"""Numbers that people say: angles, and small ones."""
HALVES = range(1, 11)
"""German has one word for each of these and a half: "zweieinhalb"."""


@cache
def _engine(language: str) -> RbnfEngine | None:
    from unicode_rbnf import RbnfEngine

    try:
        return RbnfEngine.for_language(language)
    except ValueError:
        return None


@lru_cache(maxsize=4096)
def spell(number: int, language: str) -> tuple[str, ...]:
    """A whole number in words as an utterance has them; nothing where it is too large, or the language unknown."""
    engine = _engine(language)
    if engine is None or not 0 <= number <= LARGEST:
        return ()
    text = engine.format_number(number, ruleset_names=[RULES]).text.replace("\N{SOFT HYPHEN}", "")
    return tuple(re.split(r"[\s-]+", text.lower()))


@cache
def usual(language: str) -> tuple[tuple[str, ...], ...]:
    """The numbers that people say, each in words."""
    found = [spell(number, language) for number in USUAL]
    if language == "de":
        (one,), *more = (spell(number, language) for number in HALVES)
        found += [("anderthalb",), *((f"{word}einhalb",) for word in (one[:-1], *(word for (word,) in more)))]
    return tuple(dict.fromkeys(words for words in found if words))
