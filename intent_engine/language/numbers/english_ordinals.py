"""English ordinals in words and figures: "the twenty first", "3rd", "number three"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.numbers.english import number
from intent_engine.language.numbers.english_words import ORDINAL_SCALES, ORDINAL_TENS, ORDINAL_UNITS

__all__ = ["ordinal"]


def ordinal(words: Sequence[str]) -> float | None:
    """ "third", "twenty first", "3rd", "number three", "the last" (-1)."""
    if not words:
        return None
    if words[0] == "the" and len(words) > 1:
        words = words[1:]
    if words[0] == "number":
        value = number(words[1:])
        return value if value is not None and value >= 0 and value == int(value) else None
    if words[-1] == "one" and words[0] != "one" and len(words) > 1:  # "the third one", "the last one"
        words = words[:-1]
    if words[-1] == "last" and len(words) == 1:
        return -1.0
    last = words[-1]
    if len(words) == 1 and last[0].isdigit():
        digits = last.rstrip("thndrs")
        return float(digits) if digits.isdigit() and digits != last else None
    if last in ORDINAL_UNITS:
        value = ORDINAL_UNITS[last]
    elif last in ORDINAL_TENS:
        value = ORDINAL_TENS[last]
    elif last in ORDINAL_SCALES:
        before = number(words[:-1]) if len(words) > 1 else 1.0
        return before * ORDINAL_SCALES[last] if before is not None else None
    else:
        return None
    if len(words) == 1:
        return float(value)
    before = number(words[: -2 if words[-2] == "and" else -1])
    if before is None or before < 20 or before % 100 == 10 or before % (100 if value >= 10 else 10):
        return None
    return before + value
