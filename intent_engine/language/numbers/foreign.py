"""Numbers of other languages, through text2num."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache

from intent_engine.language.numbers.numerals import is_numeral, numeral_value
from intent_engine.language.numbers.units import units

__all__ = [
    "LANGUAGES",
    "TEMPLATES",
    "fraction",
    "in_digits",
    "is_article",
    "is_number_word",
    "number",
    "numbers_at",
    "point_word",
    "said_apart",
]

LANGUAGES = frozenset(("de", "es", "fr", "it", "nl", "pt"))
"""What text2num knows, besides English; of any other it raises."""
MAX_WORDS = 16

SCALES: Mapping[str, float] = {"two": 2.0, "thousand": 1e3, "million": 1e6, "billion": 1e9}
"""Function words of ``<language>.yaml`` that multiply what stands before them; a billion is 1e9."""
TEMPLATES: Mapping[str, str] = {
    "below_hundred": "{#word} [{#word} [{#word}]]",
    "fraction": "{#word} [{#word}]",
    "number": "([{#word}] {#} [{#word} [{#word} [{#word}]]]|{#word} " + "[{#word} " * 7 + "]" * 7 + ")",
    "ordinal": "({#} [{#word}]|{#word} [{#word} [{#word}]])",
}


@lru_cache(maxsize=65536)
def _text2num(text: str, language: str) -> float | None:
    if language not in LANGUAGES:
        return None
    from text_to_num import text2num

    try:
        return float(text2num(text, language))
    except (ValueError, KeyError, AttributeError, TypeError, IndexError):
        return None


@lru_cache(maxsize=65536)
def is_number_word(word: str, language: str) -> bool:
    """Whether a word is a number of the language, or a word that stands inside numbers ("und", "komma", "halbe")."""
    table = units(language)
    inside = ("one", "half", "halves", "quarter", "and", "point", "minus", *SCALES)
    if table is not None and (word in table.nouns or any(word in table.words.get(key, ()) for key in inside)):
        return True
    if table is not None and ((word, True) in table.parts or (word, False) in table.parts):
        return True
    return _whole([word], language) is not None or _one_word(word, language) is not None


def numbers_at(words: Sequence[str], at: int, language: str) -> Iterator[tuple[float, int]]:
    """Every number that begins at a place, longest first."""
    if at >= len(words):
        return
    table = units(language)
    if table is not None and words[at] in table.words.get("minus", ()):
        yield from ((-value, end) for value, end in numbers_at(words, at + 1, language) if value >= 0)
        return
    if is_numeral(words[at]):
        value = numeral_value(words[at])
        if value is not None:
            if (decimals := _decimals_after_figures(words, at + 1, language)) is not None:
                yield math.copysign(abs(value) + decimals[0], value), decimals[1]
                return
            here = at + 1
            while here < len(words) and (scale := _scale_of_figures(words, here, language)) is not None:
                half = _and_half(words, here + 1, language) if here == at + 1 else None
                if half is not None:
                    yield (value + half[0]) * scale, half[1]
                value, here = value * scale, here + 1
            if here > at + 1:
                yield value, here
                return
            part = fraction(words, at, language)
            if part is not None:
                yield part
            half = _and_half(words, at + 1, language)
            if half is not None and value.is_integer():
                yield value + half[0], half[1]
            yield value, at + 1
        return
    last = at
    while last < len(words) and last - at < MAX_WORDS and is_number_word(words[last], language):
        last += 1
    for end in range(last, at, -1):
        value = _value(words, at, end, language)
        if value is not None:
            yield value, end


def in_digits(words: Sequence[str], language: str, *, whole: bool = True) -> tuple[str, ...]:
    """Words with the numbers among them in digits: "halle drei" is "halle 3". An article is none ("ein"), if a word
    follows that it may belong to.

    Args:
        words: normalised.
        language: of the words.
        whole: only whole numbers, as maps have them; else all, as recognisers write them.
    """
    found: list[str] = []
    at = 0
    while at < len(words):
        value, end = next(numbers_at(words, at, language), (-1.0, at + 1))
        other = value < 0 or (whole and not value.is_integer())
        if other:
            end = at + 1
        article = not 0 < at == len(words) - 1 and is_article(words[at:end], language)
        kept = other or is_numeral(words[at]) or article
        found += words[at:end] if kept else [str(int(value)) if value.is_integer() else f"{value:.10g}"]
        at = end
    return tuple(found)


def _value(words: Sequence[str], at: int, end: int, language: str) -> float | None:
    table = units(language)
    if table is None:  # text2num knows more languages than have such a file
        return _whole(words[at:end], language)
    for place in range(at + 1, end - 1):
        if words[place] in table.words.get("point", ()):
            whole = _whole(words[at:place], language)
            scale = _scale(words[end - 1], language) if end - place > 2 else None
            decimals = _decimals(words[place + 1 : end if scale is None else end - 1], language)
            return (whole + decimals) * (scale or 1.0) if whole is not None and decimals is not None else None
    whole = _whole(words[at:end], language)
    if whole is not None:
        return whole
    if end - at == 1:
        return _one_word(words[at], language) or _part(words[at], table.words)
    if (part := fraction(words, at, language)) is not None and part[1] == end:
        return part[0]
    if language == "de" and words[at] in table.words.get("one", ()):
        part = fraction(words, at + 1, language)
        one_more = words[at + 1] in table.words.get("halves", ()) or words[at + 1] in table.words.get("one", ())
        if part is not None and one_more:
            return 1 + part[0] if part[1] == end else None  # "ein einhalb", "ein ein viertel"
        if part is not None and part[1] == end:
            return part[0]  # "eine drei viertel Stunde"
    if (scale := _scale(words[end - 1], language)) is not None:
        before = _value(words, at, end - 1, language)
        fits = before is not None and not 0 < before < 0.01 and (words[end - 1] in table.nouns or before < scale)
        return before * scale if before is not None and fits else None
    for place in range(at + 1, end):
        half = _and_half(words, place, language)
        if half is not None and half[1] == end:
            before = _whole(words[at:place], language)
            scale = _scale(words[place - 1], language) or 1.0
            if before is None or scale == 1e3:  # of "mille et demi" nobody can know
                return None
            return before + half[0] * (scale if scale >= 1e6 else 1.0)  # "un million et demi"
    return None


def _decimals(words: Sequence[str], language: str) -> float | None:
    """What follows a point: digits ("zwei fünf"), or one number ("soixante quinze"), with zeros before it."""
    zeros = 0
    while zeros < len(words) - 1 and _whole(words[zeros : zeros + 1], language) == 0:
        zeros += 1
    rest = words[zeros:]
    whole = _whole(rest, language)
    found = [whole] if whole is not None else [_whole([word], language) for word in rest]
    limit = 1000 if whole is not None else 10
    if any(digit is None or not 0 <= digit < limit for digit in found):
        return None
    return float("0." + "0" * zeros + "".join(str(int(digit or 0)) for digit in found))


def _whole(words: Sequence[str], language: str) -> float | None:
    """A whole number in words: as text2num has it, and millions, whose plurals it does not know everywhere."""
    table = units(language)
    if table is not None and not table.words.get("no_number", frozenset()).isdisjoint(words):
        return None  # "unos metros" are some, and not one
    if len(words) > 1 and _text2num(_respelled(words[0], language), language) == 0:
        return None  # "null vier" may be a rest of "null Komma vier"; text2num has 4
    known = [_respelled(word, language) for word in _joined(words, language)]
    value = _text2num(" ".join(known), language)
    if value is not None:
        return value
    for place, word in enumerate(words):
        scale = _scale(word, language)
        if scale is None or scale < 1e6:
            continue
        before = _whole(words[:place], language) if place else 1.0
        after = _whole(words[place + 1 :], language) if place + 1 < len(words) else 0.0
        return before * scale + after if before is not None and after is not None and after < scale else None
    return None


def _joined(words: Sequence[str], language: str) -> Sequence[str]:
    """Words with those as one that are said apart: "veinte y tres" as "veintitres"."""
    table = units(language)
    for apart, begin in table.joined.items() if table is not None else ():
        for at in range(len(words) - len(apart)):
            if tuple(words[at : at + len(apart)]) == apart:
                end = at + len(apart)
                return [*words[:at], begin + words[end], *words[end + 1 :]]
    return words


def said_apart(number: int, spelled: tuple[str, ...], language: str) -> Iterator[tuple[str, ...]]:
    """A whole number, as it is spelled in words, with its last word as several: "veinte y tres" of "veintitrés"."""
    from intent_engine.language.numbers import said

    table = units(language)
    for apart, begin in table.joined.items() if table is not None else ():
        tens = _whole(apart[:-1], language)
        if tens is not None and spelled[-1].startswith(begin) and 0 < number % 100 - tens < 10:
            yield (*spelled[:-1], *apart, *said.spell(int(number % 100 - tens), language))


def _respelled(word: str, language: str) -> str:
    """A number word as text2num spells it."""
    table = units(language)
    if table is None:
        return word
    if word.isascii():
        for written, meant in table.respelled_parts.items():
            word = word.replace(written, meant)
    return table.respelled.get(word, word)


def _scale(word: str, language: str) -> float | None:
    table = units(language)
    if table is None:
        return None
    return table.nouns.get(word) or next((one for key, one in SCALES.items() if word in table.words.get(key, ())), None)


def _one_word(word: str, language: str) -> float | None:
    """German numbers of one word that are not whole: "anderthalb", "zweieinhalb", "dreiviertel"."""
    table = units(language)
    if language != "de" or table is None:
        return None
    word = _respelled(word, language)
    if word in ("anderthalb", "einhalb"):
        return 1.5 if word == "anderthalb" else 0.5
    for ending in ("undeinhalb", "einhalb"):
        if word.endswith(ending):
            whole = _text2num(word.removesuffix(ending), language)
            return whole + 0.5 if whole is not None else None
    if word.endswith("halbtausend"):
        half = _one_word(word.removesuffix("tausend"), language)
        return half * 1000 if half is not None else None
    for (part, one), denominator in table.parts.items():
        if not one and len(word) > len(part) and word.endswith(part):
            before = word.removesuffix(part)
            top = _text2num(before, language)
            if top is not None:
                return top / denominator if 0 < top < denominator else None
            whole = _text2num(before.removesuffix("ein"), language) if before.endswith("ein") else None
            return whole + 1 / denominator if whole is not None else None  # "zweieinviertel"
    return None


def is_article(words: Sequence[str], language: str) -> bool:
    """Whether words are a one that is mostly none: "ein", "une"."""
    table = units(language)
    return len(words) == 1 and table is not None and words[0] in table.words.get("one", ())


def point_word(language: str) -> str:
    """What is said for the point of a number: "komma"; nothing where that is not known."""
    table = units(language)
    return table.point if table is not None else ""


def _part(word: str, words: Mapping[str, frozenset[str]]) -> float | None:
    if word in words.get("half", ()):
        return 0.5
    if word in words.get("quarter", ()):
        return 0.25
    return None


def _scale_of_figures(words: Sequence[str], at: int, language: str) -> float | None:
    """What multiplies the figures before it: "2 mil millones", "10 k"."""
    return 1e3 if words[at] == "k" and words[at - 1][-1].isdigit() else _scale(words[at], language)


def _decimals_after_figures(words: Sequence[str], at: int, language: str) -> tuple[float, int] | None:
    """What follows a point that is said behind figures: "1 komma 5", "2 punto cinco"."""
    table = units(language)
    if table is None or at + 1 >= len(words) or words[at] not in table.words.get("point", ()):
        return None
    if not words[at - 1].lstrip("-").isdigit():
        return None
    if words[at + 1].isdigit():
        return float(f"0.{words[at + 1]}"), at + 2
    for end in range(min(len(words), at + 5), at + 1, -1):
        if (decimals := _decimals(words[at + 1 : end], language)) is not None:
            return decimals, end
    return None


def _and_half(words: Sequence[str], at: int, language: str) -> tuple[float, int] | None:
    """ "y medio", "et demi", "e mezzo", "einhalb"."""
    table = units(language)
    if table is None or at >= len(words):
        return None
    if words[at] in table.words.get("halves", ()):
        return 0.5, at + 1
    here = at + 1 if words[at] in table.words.get("and", ()) else at
    if here == at:
        return None
    return fraction(words, here, language)


def fraction(words: Sequence[str], at: int, language: str) -> tuple[float, int] | None:
    """A half or a quarter, or some: "demi", "un quart", "trois quarts", "zwei Drittel"."""
    table = units(language)
    if table is None or at >= len(words):
        return None
    one = words[at] in table.words.get("one", ())
    here = at + 1 if one and at + 1 < len(words) else at
    value = _part(words[here], table.words)
    if value is not None:
        return value, here + 1
    if here > at:
        denominator = table.parts.get((words[here], True))
        return (1 / denominator, here + 1) if denominator is not None else None
    word = _one_word(words[at], language)
    if word is not None and word < 1:
        return word, at + 1
    if at + 1 == len(words):
        return None
    top = numeral_value(words[at]) if words[at].isdigit() else _whole(words[at : at + 1], language)
    quarters = 4.0 if words[at + 1] in table.words.get("quarter", ()) else None
    denominator = table.parts.get((words[at + 1], False), quarters)
    return (top / denominator, at + 2) if top is not None and denominator and 1 < top < denominator else None


def number(words: Sequence[str], language: str) -> float | None:
    """The value of exactly these words."""
    return next((value for value, end in numbers_at(words, 0, language) if end == len(words)), None)
