"""English ordinals below a hundred as they are said, and as recognisers and signs write them: "twenty first" is
"21st"."""

from __future__ import annotations

import re
from collections.abc import Sequence
from types import MappingProxyType

from intent_engine.language.numbers.english_words import ORDINAL_TENS, ORDINAL_UNITS, TENS

__all__ = ["in_figures", "ordinal_otherwise", "ordinals_in_figures", "ordinals_in_words"]

_FIGURES = re.compile(r"(\d{1,2})(?:st|nd|rd|th)")
_TENS = {value: word for word, value in TENS.items() if word != "fourty"}
_WORDS = MappingProxyType(
    {
        **{value: (word,) for word, value in {**ORDINAL_UNITS, **ORDINAL_TENS}.items()},
        **{
            tens + value: (word, unit)
            for tens, word in _TENS.items()
            for unit, value in ORDINAL_UNITS.items()
            if value < 10
        },
    }
)
_VALUES = {words: value for value, words in _WORDS.items()}


def in_figures(number: int) -> str:
    """A whole number as "1st", "11th", "22nd"."""
    teens = number % 100 // 10 == 1
    return f"{number}{'th' if teens else {1: 'st', 2: 'nd', 3: 'rd'}.get(number % 10, 'th')}"


def ordinals_in_words(words: Sequence[str]) -> list[str]:
    """Ordinals in figures as words; all other words as they are."""
    return [spelled for word in words for spelled in _in_words(word) or (word,)]


def ordinals_in_figures(words: Sequence[str]) -> tuple[str, ...]:
    """Ordinals in words as figures; all other words as they are."""
    found: list[str] = []
    at = 0
    while at < len(words):
        count = _length(words[at : at + 2])
        found.append(in_figures(_VALUES[tuple(words[at : at + count])]) if count else words[at])
        at += count or 1
    return tuple(found)


def ordinal_otherwise(words: Sequence[str]) -> tuple[int, tuple[str, ...]]:
    """The ordinal with which some words begin: how many words it has (0: there is none), and its other writing."""
    if spelled := _in_words(words[0]):
        return 1, spelled
    count = _length(words[:2])
    return count, ordinals_in_figures(words[:count])


def _in_words(word: str) -> tuple[str, ...]:
    figures = _FIGURES.fullmatch(word)
    number = int(figures[1]) if figures else 0
    return _WORDS.get(number, ()) if in_figures(number) == word else ()


def _length(words: Sequence[str]) -> int:
    """Of the ordinal in words with which some begin: 2, 1, or 0."""
    return next((count for count in (2, 1) if tuple(words[:count]) in _VALUES and len(words) >= count), 0)
