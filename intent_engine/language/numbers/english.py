"""English numbers in words: to the trillions, decimals, fractions, and the short forms of speech ("one eighty")."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

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
    ZERO,
)
from intent_engine.language.numbers.numerals import is_numeral, numeral_value

__all__ = [
    "cardinal",
    "fraction",
    "leaves_hundred_out",
    "may_be_from_to",
    "number",
    "numbers_at",
]

_DENOMINATORS = (*ORDINAL_UNITS, *ORDINAL_TENS, *ORDINAL_SCALES)
_GOES_ON = NUMBER_WORDS.union(
    SUFFIXES, HALVES, _DENOMINATORS, [f"{word}s" for word in _DENOMINATORS], ("and", "over", "divided", "out")
)
"""Words with which a number may go on after its first."""

_GOES_ON_TO_A_SCALE = frozenset(("thousand", "million", "billion", "trillion"))
"""Of which there are halves and quarters."""

Found = tuple[float, int]
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


def _numeral(words: Sequence[str], at: int) -> Found | None:
    if at < len(words) and words[at][:1].isdigit() and is_numeral(words[at]):
        value = numeral_value(words[at])
        return (value, at + 1) if value is not None else None
    return None


def _group(words: Sequence[str], at: int) -> Found | None:
    """Below a thousand, or a numeral: "a hundred and five", "twelve hundred", "one eighty", "3 hundred"."""
    found = _below_hundred(words, at) or _numeral(words, at)
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
    found = _numeral(words, at)
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


def _decimals(words: Sequence[str], at: int) -> Found | None:
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
        written = _numeral(words, at)
        return written if written is not None and "-" not in words[at] else None
    if words[at] in ("a", "an"):
        bottom = _denominator(words, at + 1)
        if bottom is not None:
            return 1.0 / bottom[0], bottom[1]
    for top in (cardinal(words, at), _below_hundred(words, at), _group(words, at), _numeral(words, at)):
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
        decimals = _decimals(words, at + 1)
        if decimals is not None:
            yield from _scaled(words, decimals)
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
            decimals = _decimals(words, here + 1)
            if decimals is not None:
                yield from _scaled(words, (value + decimals[0], decimals[1]))
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
    return (float(value), at + 1) if value is not None else _numeral(words, at)


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
    """Whether words begin with two numbers between which a "to" may have been left out: "eight ten minutes" are eight
    to ten, and not 810. "One ten" and "five fifty" are only one number."""
    signed = bool(words) and words[0] in ("minus", "negative")
    first, second, *_ = (*words[signed : signed + 2], "", "")
    return DIGITS.get(first, 0) > 3 and second in TEENS
