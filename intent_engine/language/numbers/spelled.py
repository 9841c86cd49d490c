"""Numbers in digits to words and back, word by word, for comparing what two writers wrote."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache, lru_cache

from intent_engine.language.numbers import english_parts, english_words, foreign, said
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.ordinals_spelled import ordinal_otherwise
from intent_engine.language.numbers.units import units

__all__ = [
    "figures_otherwise",
    "first_figure_apart",
    "in_digits",
    "in_words",
    "number_end",
    "number_otherwise",
    "number_words",
]

_ONES = {value: word for word, value in {**english_words.DIGITS, **english_words.TEENS}.items()}
_TENS = {value: word for word, value in english_words.TENS.items() if word != "fourty"}

_THREE_FIGURES = re.compile(r"(?<![\d.,:])([1-9])([1-9]\d)(?![.,:]?\d)")


@lru_cache(maxsize=4096)
def _spell(numeral: str) -> tuple[str, ...]:
    whole, _, rest = numeral.partition(".")
    if not whole.isdigit() or len(whole) > 6:
        return (numeral,)
    words = _spell_whole(int(whole))
    if rest:
        words = (*words, "point", *(_ONES.get(int(digit), "zero") for digit in rest))
    return words


def _spell_whole(number: int) -> tuple[str, ...]:
    if number == 0:
        return ("zero",)
    if number >= 1000:
        rest = _spell_whole(number % 1000) if number % 1000 else ()
        return (*_spell_whole(number // 1000), "thousand", *rest)
    if number >= 100:
        rest = _spell_whole(number % 100) if number % 100 else ()
        return (_ONES[number // 100], "hundred", *rest)
    if number in _ONES:
        return (_ONES[number],)
    tens = (_TENS[number // 10 * 10],)
    return (*tens, _ONES[number % 10]) if number % 10 else tens


def in_words(words: Sequence[str], language: str | None = "en") -> list[str]:
    """Numerals as words of a language (None: English); others and all other words as they are."""
    spelled: list[str] = []
    for word in words:
        spelled.extend(_spelled(word, language or "en") if is_numeral(word) else (word,))
    return spelled


def _spelled(numeral: str, language: str) -> tuple[str, ...]:
    if language == "en":
        return _spell(numeral)
    whole, _, rest = numeral.partition(".")
    parts = [whole, *rest]  # after the point digit by digit
    words = [said.spell(int(part), language) if part.isdecimal() else () for part in parts]
    point = foreign.point_word(language) if rest else ""
    if not all(words) or (rest and not point):
        return (numeral,)
    return (*words[0], *([point] if rest else []), *(word for digit in words[1:] for word in digit))


@cache
def number_words(language: str | None = "en") -> frozenset[str]:
    """The words that numbers of a language are made of (None: English); of other languages those that people say."""
    if language in (None, "en"):
        return english_words.NUMBER_WORDS
    return frozenset(word for words in said.usual(language) for word in words)


def _spoken(words: Sequence[str], at: int) -> tuple[float, int] | None:
    """The value of a number in English words that begins here, and where it ends."""
    return english_parts.cardinal(words, at) if words[at] in english_words.SMALL else None


def number_end(words: Sequence[str], at: int) -> int:
    """Where a number in digits or in English words ends that begins here; here, if none does."""
    if is_numeral(words[at]):
        return at + 1
    found = _spoken(words, at)
    return found[1] if found is not None else at


def in_digits(words: Sequence[str], language: str | None = "en") -> tuple[str, ...]:
    """Number words of a language (None: English) as digits, as a recogniser likes to write them."""
    if language not in (None, "en"):
        return foreign.in_digits(words, language, whole=False)
    result: list[str] = []
    at = 0
    while at < len(words):
        found = _spoken(words, at)
        if found is not None and found[0] == int(found[0]):
            result.append(str(int(found[0])))
            at = found[1]
        else:
            result.append(words[at])
            at += 1
    return tuple(result)


def number_otherwise(words: Sequence[str]) -> tuple[int, tuple[tuple[str, ...], ...]]:
    """The number in digits or in English words that some words begin with: how many words it has (0: there is none),
    and all other ways to write it, if it is whole: "204", "two hundred and four" and "two oh four"; "21st" and "twenty
    first"."""
    count, ordinal = ordinal_otherwise(words)
    if count:
        apart = in_digits(words[:count])  # "twenty second": 22nd, and what lasts twenty seconds
        return count, tuple(dict.fromkeys(way for way in (ordinal, apart) if way != tuple(words[:count])))
    end = number_end(words, 0)
    if not end:
        return 0, ()
    own = tuple(words[:end])
    digits = own if is_numeral(own[0]) else in_digits(own)
    if len(digits) > 1 or not digits[0].isdigit() or (digits[0].startswith("0") and digits != ("0",)):
        return end, ()
    spelled = _spell(digits[0])
    if spelled == digits:  # too large to be said
        return end, ()
    ways = dict.fromkeys((digits, spelled, *_said(digits[0], spelled)))
    return end, tuple(way for way in ways if way != own)


def first_figure_apart(text: str, language: str | None = "en") -> str:
    """A text with the first of three figures of an English number by itself, as it may have been said: "4 60" for
    "460", which is what recognisers write for "four sixty" too, and for the "pour sixty" of a grammar, or "for sixty".
    """
    return _THREE_FIGURES.sub(r"\1 \2", text) if language in (None, "en") else text


def figures_otherwise(words: Sequence[str], language: str) -> tuple[int, tuple[tuple[str, ...], ...]]:
    """The whole number in digits with which some words begin: how many words it has (0: there is none), and how it is
    said in another language than English: "21" is "vingt et un" and "vingt et une". Of "1" nothing is told, it may be
    an article."""
    if not words[0].isdecimal() or str(int(words[0])) != words[0] or words[0] == "1":
        return 0, ()
    return 1, _ways_to_say(words[0], language)


@lru_cache(maxsize=65536)
def _ways_to_say(digits: str, language: str) -> tuple[tuple[str, ...], ...]:
    spelled = said.spell(int(digits), language)
    table = units(language)
    one = table.words.get("one", frozenset()) if table is not None else frozenset[str]()
    if not spelled:
        return ()
    ways = [spelled, *foreign.said_apart(int(digits), spelled, language)]
    if spelled[-1] in one:
        ways += [(*spelled[:-1], other) for other in sorted(one) if other != spelled[-1]]
    return tuple(ways)


def _said(digits: str, spelled: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """A whole number as people say it beside its full words: with an "and", and from three digits on with none of its
    "hundred" and "thousand", as rooms and gates are called."""
    hundreds, rest = divmod(int(digits), 100)
    if int(digits) >= 100 and rest:
        head = spelled[: len(spelled) - len(_spell_whole(rest))]
        yield (*head, "and", *spelled[len(head) :])
    if len(digits) not in (3, 4):
        return
    if rest == 0:
        yield (*_spell_whole(hundreds), "hundred")
    if rest >= 10:
        yield (*_spell_whole(hundreds), *_spell_whole(rest))
    for zero in ("oh", "zero"):
        if 0 < rest < 10:
            yield (*_spell_whole(hundreds), zero, _ONES[rest])
        yield tuple(_ONES.get(int(digit), zero) for digit in digits)
