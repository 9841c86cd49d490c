"""English numbers in words: to the trillions, decimals, fractions, and the short forms of speech ("one eighty")."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from intent_engine.language.numbers.english_parts import Found, cardinal, decimals, fraction, numeral
from intent_engine.language.numbers.english_words import (
    DIGITS,
    HALVES,
    NUMBER_WORDS,
    ORDINAL_SCALES,
    ORDINAL_TENS,
    ORDINAL_UNITS,
    SCALES,
    SIGNS,
    SMALL,
    SUFFIXES,
    TEENS,
    TENS,
)
from intent_engine.language.numbers.numerals import is_numeral, numeral_value

__all__ = ["leaves_hundred_out", "may_be_from_to", "number", "numbers_at"]

_DENOMINATORS = (*ORDINAL_UNITS, *ORDINAL_TENS, *ORDINAL_SCALES)
_GOES_ON = NUMBER_WORDS.union(
    SUFFIXES, HALVES, _DENOMINATORS, [f"{word}s" for word in _DENOMINATORS], ("and", "over", "divided", "out")
)
"""Words with which a number may go on after its first."""

_GOES_ON_TO_A_SCALE = frozenset(("thousand", "million", "billion", "trillion"))
"""Of which there are halves and quarters."""


def numbers_at(words: Sequence[str], at: int) -> Iterator[Found]:
    """Every number that begins at a place; the first is the one most likely meant, and not always the longest."""
    if at >= len(words):
        return
    word = words[at]
    if word in SIGNS:
        sign = 1.0 if word == "plus" else -1.0
        # A second sign may say the first one again, or turn it round: "minus -5".
        if at + 1 < len(words) and words[at + 1] not in SIGNS and not words[at + 1].startswith("-"):
            yield from ((sign * value, after) for value, after in numbers_at(words, at + 1))
        return
    if word[0] == "-" and is_numeral(word):
        value = numeral_value(word)
        if value is not None:
            yield from (
                (-positive, after) for positive, after in numbers_at([*words[:at], word[1:], *words[at + 1 :]], at)
            )
        return
    yield from _positive(words, at)


def _positive(words: Sequence[str], at: int) -> Iterator[Found]:
    word = words[at]
    simple = _single(words, at)
    if simple is not None:
        yield simple
        return
    if word == "point":
        behind = decimals(words, at + 1)
        if behind is not None:
            yield from _scaled(words, behind)
        return
    if word in ("a", "an", "the") and at + 1 < len(words) and words[at + 1] in ("couple", "pair"):
        yield 2.0, at + 3 if tuple(words[at + 2 : at + 3]) == ("of",) else at + 2
        return
    dozens = _dozens(words, at)
    if dozens is not None:
        yield dozens
        return
    if word in ("couple", "pair"):
        after = at + 2 if tuple(words[at + 1 : at + 2]) == ("of",) else at + 1
        yield 2.0, after
        return
    # "ten and a half thousand" is below, with what may follow "and".
    scaled = _part_of_a_scale(words, at)
    if scaled is not None:
        yield scaled
        return
    whole = cardinal(words, at)
    if whole is not None:
        value, here = whole
        following = tuple(words[here : here + 2])
        if following[:1] == ("point",):
            behind = decimals(words, here + 1)
            if behind is not None:
                yield from _scaled(words, (value + behind[0], behind[1]))
                return
        if following[:1] in (("over",), ("divided",)) or following == ("out", "of"):
            bottom = cardinal(words, here + (2 if following in (("divided", "by"), ("out", "of")) else 1))
            if bottom is not None and bottom[0]:
                yield value / bottom[0], bottom[1]
                return
        if following[:1] == ("and",) and value.is_integer():
            part = fraction(words, here + 1)
            if part is not None and part[0] < 1:
                yield from _with_part(words, whole, part)
                yield value, here
                return
        joined = _hundreds_and_fraction(words, at)
        if joined is not None:
            yield joined
            return
        part = fraction(words, here)
        if part is not None and part[0] < 1 and not _doubtful_part(words, here, part[1]):
            yield value + part[0], part[1]  # "two three quarters", "2 1/2" written as two numerals
    part = fraction(words, at)
    if part is not None and part != whole:
        yield part
    if whole is not None:
        yield whole


def _part_of_a_scale(words: Sequence[str], at: int) -> Found | None:
    """ "Half a million", "a quarter million", "three quarters of a million"."""
    if _GOES_ON_TO_A_SCALE.isdisjoint(words[at : at + 5]):
        return None
    part = fraction(words, at)
    if part is None or part[0] >= 1 or words[part[1] - 1] not in HALVES:
        return None
    here = part[1]
    for joint in ("of", "a"):
        here += tuple(words[here : here + 1]) == (joint,)
    if tuple(words[here : here + 1]) and words[here] in _GOES_ON_TO_A_SCALE:
        return part[0] * SCALES[words[here]], here + 1
    return None


def _dozens(words: Sequence[str], at: int) -> Found | None:
    """ "A dozen", "dozen of", "a dozen and a half", "half a dozen", "a half dozen": what a dozen has no number for."""
    here = at + 1 if words[at] in ("a", "an", "the") else at
    half = here < len(words) and words[here] == "half"
    if half:
        here = here + 2 if here == at and tuple(words[here + 1 : here + 2]) == ("a",) else here + 1
    if tuple(words[here : here + 1]) != ("dozen",):
        return None
    if half:
        return 6.0, here + 1
    part = fraction(words, here + 2) if tuple(words[here + 1 : here + 2]) == ("and",) else None
    if part is not None and part[0] < 1:
        return 12.0 * (1 + part[0]), part[1]
    return 12.0, here + 2 if tuple(words[here + 1 : here + 2]) == ("of",) else here + 1


def _single(words: Sequence[str], at: int) -> Found | None:
    """A number of one word with which no other goes on, as most are: "five", "ninety", "2.5"; None: it is another."""
    after = words[at + 1] if at + 1 < len(words) else ""
    if after in _GOES_ON or after[:1].isdigit():
        return None
    value = SMALL.get(words[at])
    return (float(value), at + 1) if value is not None else numeral(words, at)


def _hundreds_and_fraction(words: Sequence[str], at: int) -> Found | None:
    """ "two hundred and fifty-four hundredths": what follows "and" is the fraction's top."""
    for place in range(at + 1, min(len(words) - 1, at + 8)):
        if words[place] != "and":
            continue
        whole = cardinal(words[:place], at)
        part = fraction(words, place + 1)
        if whole is not None and whole[1] == place and part is not None and part[0] < 1 and whole[0].is_integer():
            return whole[0] + part[0], part[1]
    return None


def _doubtful_part(words: Sequence[str], at: int, end: int) -> bool:
    """Whether a fraction straight after a number may be none of it: "two half"; "one one hundredth" is 0.01."""
    small = words[end - 1].removesuffix("s")
    return words[at] in ("half", "quarter", "second") or small in ORDINAL_SCALES or small in ORDINAL_TENS


def _with_part(words: Sequence[str], whole: Found, part: Found) -> Iterator[Found]:
    """ "Two and a half", "two and a half million"; of "a million and a half" it is half a million."""
    (value, here), (more, end) = whole, part
    last = SCALES.get(words[here - 1], 1.0)
    if last == 1.0:
        yield from _scaled(words, (value + more, end))
        return
    smaller = SCALES.get(words[end], last) if end < len(words) else last
    if smaller < last:  # "one billion and a half million"
        yield value + more * smaller, end + 1
    elif last >= 1e6 and words[end - 1] in HALVES:
        yield value + more * last, end
    elif last >= 1e6:
        yield value + more, end
    # Of "a thousand and a half" nobody can know.


def _scaled(words: Sequence[str], found: Found) -> Iterator[Found]:
    value, here = found
    if here < len(words) and words[here] in SCALES:
        yield value * SCALES[words[here]], here + 1
    elif here < len(words) and words[here] == "dozen":
        yield value * 12, here + 1
    yield found


def number(words: Sequence[str]) -> float | None:
    """The value of exactly these words."""
    for value, after in numbers_at(words, 0):
        if after == len(words):
            return value
    return None


def leaves_hundred_out(words: Sequence[str]) -> bool:
    """Whether words begin with a digit and tens, as in "one eighty", perhaps after a sign."""
    signed = bool(words) and words[0] in ("minus", "negative")
    first, second, *_ = (*words[signed : signed + 2], "", "")
    return first in DIGITS and (second in TENS or second in TEENS)


def may_be_from_to(words: Sequence[str]) -> bool:
    """Whether words hold two numbers between which a "to" may have been left out: "eight ten minutes" are eight to
    ten, and not 810. "One ten" and "five fifty" are only one number."""
    return any(DIGITS.get(first, 0) > 3 and second in TEENS for first, second in pairwise(words))
