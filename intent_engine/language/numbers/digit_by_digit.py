"""Numbers whose digits are said one by one, as pilots and sailors do: "heading one eight zero", "kanal eins sechs"; and
in English two by two, as those of rooms, gates and years are: "room eleven thirty", "nineteen oh five"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.numbers import english_words, foreign
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.templates.template_tree import Choice, Node, Optional, Word, WordClass
from intent_engine.language.templates.template_tree import Sequence as TemplateSequence

__all__ = ["MOST_DIGITS", "digit_of", "digits_in_words", "said_together", "template_of"]

MOST_DIGITS = 8
"""Digits of the longest number that is said so."""
_SIGNS = ("minus", "negative")
_ENGLISH = {
    **{word: str(value) for word, value in english_words.DIGITS.items()},
    **dict.fromkeys(english_words.ZERO, "0"),
}
_WORDS = {digit: word for word, digit in _ENGLISH.items()} | {"0": "zero"}


def digit_of(word: str, language: str) -> str:
    """The digit that a word is; empty: it is none."""
    if len(word) == 1 and word.isdecimal() and word.isascii():
        return word
    if language == "en":
        return _ENGLISH.get(word, "")
    value = foreign.number((word,), language) if foreign.is_number_word(word, language) else None
    return str(int(value)) if value is not None and 0 <= value <= 9 and float(value).is_integer() else ""


def said_together(words: Sequence[str], language: str) -> Sequence[str]:
    """Words that begin with digits, with these as one numeral: "180 degrees" of "one eight zero degrees". Others as
    they are, and so are digits that go on to be another number: "one two hundred"."""
    start = int(language == "en" and bool(words) and words[0] in _SIGNS)
    if language == "en" and (pairs := _in_pairs(words, start)) is not None:
        number, end = pairs
        return [*words[:start], number, *words[end:]]
    digits = ""
    end = start
    while end < len(words) and (digit := digit_of(words[end], language)):
        digits += digit
        end += 1
    decimals = ""
    if len(digits) > 1 and language == "en" and words[end : end + 1] in (["point"], ("point",)):
        after = end + 1
        while after < len(words) and (digit := digit_of(words[after], language)):
            decimals += digit
            after += 1
        end = after if decimals else end
    if not 1 < len(digits) <= MOST_DIGITS or (end < len(words) and _goes_on(words[end], language)):
        return words
    number = f"{int(digits)}.{decimals}" if decimals else str(int(digits))
    return [*words[:start], number, *words[end:]]


def _in_pairs(words: Sequence[str], start: int) -> tuple[str, int] | None:
    """The number that is said by two digits at a time, and where it ends; None: there is none. The first two are no
    "oh five", and one pair alone is a number like any other."""
    digits, end = "", start
    while pair := _pair(words, end, first=end == start):
        digits += pair[0]
        end = pair[1]
    if not 2 < len(digits) <= MOST_DIGITS or (end < len(words) and _goes_on(words[end], "en")):
        return None
    return digits, end


def _pair(words: Sequence[str], at: int, *, first: bool) -> tuple[str, int] | None:
    """Two digits that stand at a place, as figures, and where they end: "thirty", "thirty five", "oh five", "05"."""
    word = words[at] if at < len(words) else ""
    if len(word) == 2 and word.isdecimal() and word.isascii():
        return (word, at + 1) if word[0] != "0" or not first else None
    digit = english_words.DIGITS.get(words[at + 1]) if at + 1 < len(words) else None
    if word in english_words.TEENS:
        return str(int(english_words.TEENS[word])), at + 1
    if word in english_words.TENS:
        tens = int(english_words.TENS[word])
        return (str(tens), at + 1) if digit is None else (str(tens + int(digit)), at + 2)
    if word in english_words.ZERO and digit is not None and not first:
        return f"0{int(digit)}", at + 2
    return None


def _goes_on(word: str, language: str) -> bool:
    """Whether a word behind digits belongs to their number, which then is no row of digits."""
    if is_numeral(word):
        return True
    return word in english_words.NUMBER_WORDS if language == "en" else foreign.is_number_word(word, language)


def digits_in_words(number: int, language: str) -> str:
    """A whole number as it is said digit by digit; in other languages than English with the digits themselves."""
    return " ".join(_WORDS[digit] if language == "en" else digit for digit in str(number))


def template_of(language: str) -> Node:
    """Two digits or more, and in English a sign and a point: a little more than :func:`said_together` takes."""
    word: Node = Choice(tuple(map(Word, sorted(_ENGLISH)))) if language == "en" else WordClass("#word")
    digit = Choice((word, WordClass("#")))
    digits: Node = TemplateSequence((digit, digit, *[Optional(digit)] * (MOST_DIGITS - 2)))
    if language != "en":
        return digits
    decimals: Node = TemplateSequence((Word("point"), digit, Optional(digit), Optional(digit)))
    by_one = TemplateSequence((digits, Optional(decimals)))
    return TemplateSequence((Optional(Choice(tuple(map(Word, _SIGNS)))), Choice((by_one, _pairs_template()))))


def _pairs_template() -> Node:
    """Two or three pairs of digits in words; in figures they are rows of digits."""
    words = english_words
    one, zero, teen, ten = (
        Choice(tuple(map(Word, sorted(some)))) for some in (words.DIGITS, words.ZERO, words.TEENS, words.TENS)
    )
    pair = Choice((teen, TemplateSequence((ten, Optional(one)))))
    later = Choice((pair, TemplateSequence((zero, one))))
    return TemplateSequence((pair, later, Optional(later)))
