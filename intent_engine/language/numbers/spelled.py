"""Numbers in digits to words and back, word by word, for comparing what two writers wrote."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache

from intent_engine.language.numbers import english
from intent_engine.language.numbers.numerals import is_numeral

__all__ = ["in_digits", "in_words", "number_end", "number_ways", "numbers_otherwise"]

_ONES = {value: word for word, value in {**english.DIGITS, **english.TEENS}.items()}
_TENS = {value: word for word, value in english.TENS.items() if word != "fourty"}


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


def in_words(words: Sequence[str]) -> list[str]:
    """English numerals as words; others and all other words as they are."""
    spelled: list[str] = []
    for word in words:
        spelled.extend(_spell(word) if is_numeral(word) else (word,))
    return spelled


def _spoken(words: Sequence[str], at: int) -> tuple[float, int] | None:
    """The value of a number in English words that begins here, and where it ends."""
    return english.cardinal(words, at) if words[at] in english.SMALL else None


def number_end(words: Sequence[str], at: int) -> int:
    """Where a number in digits or in English words ends that begins here; here, if none does."""
    if is_numeral(words[at]):
        return at + 1
    found = _spoken(words, at)
    return found[1] if found is not None else at


def in_digits(words: Sequence[str]) -> tuple[str, ...]:
    """English number words as digits, as a recogniser likes to write them."""
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


def numbers_otherwise(words: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Words that begin with a number, with its digits in words or its English words in digits."""
    if words[0][0].isdigit():
        yield tuple(in_words(words))
    elif words[0] in english.SMALL:
        yield in_digits(words)


def number_ways(words: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Other ways to write a whole number, in digits or in English words: "180", "one hundred and eighty" and "one
    eighty"."""
    digits = tuple(words) if is_numeral(words[0]) else in_digits(words)
    if len(digits) > 1 or not digits[0].isdigit() or (digits[0].startswith("0") and digits != ("0",)):
        return
    yield digits
    spelled = _spell(digits[0])
    if spelled == digits:  # too large to be said
        return
    yield spelled
    if len(digits[0]) == 3 and len(spelled) > 2:
        yield (*spelled[:2], "and", *spelled[2:])
        if int(digits[0]) % 100 >= 10:
            yield (spelled[0], *spelled[2:])
