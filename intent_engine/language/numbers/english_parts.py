"""The parts of which English numbers are made: whole numbers, decimals and fractions, in words or figures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from intent_engine.language.numbers.english_words import (
    DIGITS,
    HALVES,
    ORDINAL_SCALES,
    ORDINAL_TENS,
    ORDINAL_UNITS,
    SCALES,
    SUFFIXES,
    TEENS,
    TENS,
    ZERO,
)
from intent_engine.language.numbers.numerals import is_numeral, numeral_value

__all__ = ["Found", "cardinal", "decimals", "fraction", "numeral"]

Found: TypeAlias = tuple[float, int]
"""A value and the place after its last word."""


def _below_hundred(words: Sequence[str], at: int) -> Found | None:
    word = words[at] if at < len(words) else ""
    if word in TENS:
        after = words[at + 1] if at + 1 < len(words) else ""
        if after in DIGITS:
            return float(TENS[word] + DIGITS[after]), at + 2
        return float(TENS[word]), at + 1
    value = DIGITS.get(word) or TEENS.get(word)
    return (float(value), at + 1) if value else None


def numeral(words: Sequence[str], at: int) -> Found | None:
    if at < len(words) and words[at][:1].isdigit() and is_numeral(words[at]):
        value = numeral_value(words[at])
        return (value, at + 1) if value is not None else None
    return None


def _group(words: Sequence[str], at: int) -> Found | None:
    """Below a thousand, or a numeral: "a hundred and five", "twelve hundred", "one eighty", "3 hundred"."""
    found = _below_hundred(words, at) or numeral(words, at)
    if found is None and at < len(words) and words[at] in ("a", "an", "hundred"):
        found = (1.0, at if words[at] == "hundred" else at + 1)
        if found[1] >= len(words) or words[found[1]] != "hundred":
            return None
    if found is None:
        return None
    value, here = found
    if here < len(words) and words[here] in ("hundred", "hundreds"):
        value, here = value * 100, here + 1
        more = here + 1 if here < len(words) and words[here] == "and" else here
        tail = _below_hundred(words, more) or _small_numeral(words, more)
        if tail is not None and tuple(words[tail[1] : tail[1] + 1]) not in (("hundred",), ("hundreds",)):
            return value + tail[0], tail[1]
        return value, here
    if words[at].isdigit() and value % 100 == 0 and 100 <= value < 1000 and tuple(words[here : here + 1]) == ("and",):
        # A recogniser's "100 and 20".
        tail = _below_hundred(words, here + 1) or _small_numeral(words, here + 1)
        if tail is not None:
            return value + tail[0], tail[1]
    if value < 10 and here == at + 1 and words[at] in DIGITS and here < len(words):
        # "one eighty", "two seventy five": hundreds left out, as angles are said; "one oh five" likewise.
        if words[here] in TENS or words[here] in TEENS:
            tail = _below_hundred(words, here)
            if tail is not None:
                return value * 100 + tail[0], tail[1]
        if words[here] in ZERO and here + 1 < len(words) and words[here + 1] in DIGITS:
            return value * 100 + DIGITS[words[here + 1]], here + 2
    return value, here


def _small_numeral(words: Sequence[str], at: int) -> Found | None:
    found = numeral(words, at)
    return found if found is not None and found[0] < 100 and words[at].isdigit() else None


def cardinal(words: Sequence[str], at: int) -> Found | None:
    """The longest whole number (or scaled numeral) that begins here."""
    here = at
    if here < len(words) and words[here] in ZERO:
        return 0.0, here + 1
    if here + 1 < len(words) and words[here] in ("a", "an") and words[here + 1] in SCALES:
        found: Found | None = (1.0, here + 1)
    elif here + 1 < len(words) and words[here] in ("thousand", "million") and _group(words, here + 1) is not None:
        found = (1.0, here)  # "thousand nine hundred twenty", its "one" left out
    else:
        found = _group(words, here)
    total, last, best = 0.0, float("inf"), None
    while found is not None:
        value, here = found
        scale = 1.0
        while here < len(words) and words[here] in SCALES and SCALES[words[here]] * scale <= 1e15:
            scale *= SCALES[words[here]]
            here += 1
        if scale == 1.0 and here < len(words) and words[here] in SUFFIXES and words[here - 1][0].isdigit():
            scale = SUFFIXES[words[here]]
            here += 1
        if scale >= last:
            break
        total += value * scale
        best = (total, here)
        if scale == 1.0:
            break
        last = scale
        more = here + 1 if here < len(words) and words[here] == "and" else here
        found = _group(words, more) if more == here or not _begins_part(words, more) else None
    if best is not None and best[1] < len(words) and words[best[1]] in ("dozen", "dozens"):
        return best[0] * 12, best[1] + 1
    return best


def _begins_part(words: Sequence[str], at: int) -> bool:
    """Whether a half or a fraction in digits stands here: of "a million and one half" it is no "one"."""
    part = fraction(words, at)
    return part is not None and part[0] < 1 and (words[part[1] - 1] in HALVES or "/" in words[at])


def decimals(words: Sequence[str], at: int) -> Found | None:
    digits = ""
    here = at
    while here < len(words) and len(digits) < 15:
        word = words[here]
        if word in DIGITS:
            digits += str(DIGITS[word])
        elif word in ZERO:
            digits += "0"
        elif word.isdigit():
            digits += word
        elif not digits and (word in TENS or word in TEENS):
            tail = _below_hundred(words, here)
            assert tail is not None
            return float(f"0.{int(tail[0])}"), tail[1]
        else:
            break
        here += 1
    return (float("0." + digits), here) if digits else None


def _denominator(words: Sequence[str], at: int) -> Found | None:
    word = words[at] if at < len(words) else ""
    if word in HALVES:
        return HALVES[word], at + 1
    singular = word[:-1] if word.endswith("s") else word
    if singular in ORDINAL_SCALES:
        return ORDINAL_SCALES[singular], at + 1
    if singular in ORDINAL_TENS:
        return float(ORDINAL_TENS[singular]), at + 1
    if singular in ORDINAL_UNITS and ORDINAL_UNITS[singular] > 2:
        return float(ORDINAL_UNITS[singular]), at + 1
    if word in TENS and at + 1 < len(words):
        after = words[at + 1][:-1] if words[at + 1].endswith("s") else words[at + 1]
        if after in ORDINAL_UNITS and ORDINAL_UNITS[after] < 10:
            return float(TENS[word] + ORDINAL_UNITS[after]), at + 2
    digits = singular.rstrip("thndrs")
    if digits.isdigit() and singular != digits and 2 < int(digits) < 10**6:
        return float(digits), at + 1
    return None


def fraction(words: Sequence[str], at: int) -> Found | None:
    """ "a half", "three quarters", "two thirds", "a twenty-first"; below one, except "three halves"."""
    if at >= len(words):
        return None
    if words[at] in ("half", "quarter"):
        return 1.0 / HALVES[words[at]], at + 1
    if "/" in words[at]:
        written = numeral(words, at)
        return written if written is not None and "-" not in words[at] else None
    if words[at] in ("a", "an"):
        bottom = _denominator(words, at + 1)
        if bottom is not None:
            return 1.0 / bottom[0], bottom[1]
    for top in (cardinal(words, at), _below_hundred(words, at), _group(words, at), numeral(words, at)):
        if top is None:
            continue
        if top[1] - at > 1 and words[top[1] - 1] in TENS:
            # "one hundred thirty-fifths": the tens go with the ordinal after them
            shorter = cardinal(words[: top[1] - 1], at)
            joined = _denominator(words, top[1] - 1)
            if shorter is not None and shorter[1] == top[1] - 1 and joined is not None and joined[1] > top[1]:
                if shorter[0] % 100 == 0 and words[top[1]] in ORDINAL_UNITS:
                    return None  # "one hundred thirty fifth"
                return shorter[0] / joined[0], joined[1]
        bottom = _denominator(words, top[1])
        if bottom is not None and (top[0] == 0 or (top[0] > 1 and words[bottom[1] - 1] == "half")):
            return None  # "two half meters" are rather two and a half
        if bottom is not None and not _is_ordinal(words, top, bottom[1]):
            return top[0] / bottom[0], bottom[1]
        # "three twenty-firsts": the tens belong to the denominator, not to "three twenty"
        if words[at] in DIGITS:
            bottom = _denominator(words, at + 1)
            if bottom is not None:
                return DIGITS[words[at]] / bottom[0], bottom[1]
    return None


def _is_ordinal(words: Sequence[str], top: Found, end: int) -> bool:
    """Whether a number and what would be its denominator are an ordinal: "twenty fifth" is no 20/5."""
    last = words[end - 1]
    if last in ORDINAL_UNITS:
        fits = top[0] % 100 == 0 or (ORDINAL_UNITS[last] < 10 and top[0] % 10 == 0)
        return end == top[1] + 1 and top[0] >= 20 and fits
    return last in ORDINAL_TENS and top[0] >= 100 and top[0] % 100 == 0
