"""Numerals in digits: "10", "2.5", "1/2", "2-1/2", "-3"."""

from __future__ import annotations

import math
import re

__all__ = ["is_numeral", "numeral_value"]

_NUMERAL = re.compile(r"-?(?:\d+(?:\.\d+)?|\d+/\d+|\d+-\d+/\d+)")

_PARTS_AS_COUNTED = frozenset((16, 32, 64, 100, 1000))
"""Parts that people also count without reducing them: sixteenths of an inch on a ruler, hundredths of anything."""


def is_numeral(word: str) -> bool:
    """Whether a normalised word is a number in digits."""
    return (word[:1].isdigit() or word[:1] == "-") and _NUMERAL.fullmatch(word) is not None


def numeral_value(word: str) -> float | None:
    """Its value; None for a word that is no numeral, divides by zero, or may be two numbers, as "40/50" and "4/6"."""
    if word.isdigit():
        return float(word) if len(word) < 300 else None
    if not is_numeral(word):
        return None
    sign = -1.0 if word[0] == "-" else 1.0
    rest = word.lstrip("-")
    if len(rest) > 300:
        return None
    if "/" not in rest:
        return sign * float(rest)
    whole, _, fraction = rest.rpartition("-")
    top, _, bottom = fraction.partition("/")
    if float(bottom) == 0 or (not whole and _may_be_two(int(top), int(bottom))):
        return None
    return sign * ((float(whole) if whole else 0.0) + float(top) / float(bottom))


def _may_be_two(top: int, bottom: int) -> bool:
    """Whether a stroke rather stands between two numbers: "every 4/6 hours". Who means a part of one writes "2/3"."""
    return top > 0 and math.gcd(top, bottom) > 1 and bottom not in _PARTS_AS_COUNTED
