"""A name as it is compared: plain words, its numbers in digits, without articles.

"Bay three", "the bay 3", "Bay number 03" and "bay_3" are all ``("bay", "3")``; "the third floor" is
``("3th", "floor")``. Numbers, ordinals and single letters are *identifiers*: two names that differ in one are
different names, however alike they are written.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache

from intent_engine.language.normalize import without_accents, words_of
from intent_engine.language.numbers import english_ordinals, english_parts, english_words
from intent_engine.language.words.homophones import LETTERS_BY_SOUND, SPELLING_ALPHABET
from intent_engine.language.words.thing_words import thing_words

__all__ = [
    "OWNERS", "accented_names", "compared_as_written", "heard_otherwise", "is_identifier", "name_words", "owner",
    "raw_words", "singular", "without_article",
]  # fmt: skip

ARTICLES = frozenset(("a", "an", "my", "our", "your", "this", "that", "these", "those"))
"""Dropped before a name if the name is not known with it. "the" carries nothing and is dropped
everywhere but at the end, where what it belongs to was not said."""
OWNERS = {"my": "us", "our": "us", "your": "you"}
"""Those of them that say whose it is: "your nose" is no "my nose", though either is a "nose". "Our office" may be "my
office"."""
NUMBER_WORDS = frozenset((*english_words.SMALL, *english_words.ZERO, *english_words.SCALES, "hundred", "hundreds"))
ORDINALS = frozenset((*english_words.ORDINAL_UNITS, *english_words.ORDINAL_TENS))
_SPECIAL = NUMBER_WORDS | ORDINALS | frozenset(("the", "number", "nr", "point"))
_PLAIN = re.compile(r"[a-z]+(?: [a-z]+)*(?: (?:0|[1-9][0-9]*))?")
_ABBREVIATED = re.compile(r"\b(?:no|nr)\s*\.\s*(?=\d)|#\s*(?=\d)", re.IGNORECASE)
_ORDINAL_NUMERAL = re.compile(r"(\d+)(?:st|nd|rd|th)")

_NUMBER_ALIKES = {
    "won": "one", "wan": "one", "to": "two", "too": "two", "tu": "two", "tree": "three", "free": "three",
    "for": "four", "fore": "four", "fife": "five", "sicks": "six", "sex": "six", "ate": "eight", "hate": "eight",
    "nein": "nine", "tin": "ten",
}  # fmt: skip
ALIKES: dict[str, str] = {
    **LETTERS_BY_SOUND,
    **SPELLING_ALPHABET,
    **_NUMBER_ALIKES,
}
"""What is written for a number or a letter that was said: "dock to", "bay tree", "aisle bee", "aisle bravo"."""


def is_identifier(word: str) -> bool:
    """Whether a normalised word is a number, an ordinal or a single letter."""
    return len(word) == 1 or word[0].isdigit() or word[0] == "-"


def raw_words(text: str) -> tuple[str, ...]:
    """The words of a written name, numbers as they were written."""
    if _PLAIN.fullmatch(text) is not None:
        return tuple(text.split(" "))
    text = _ABBREVIATED.sub(" number ", text.replace("_", " "))
    return words_of(text)


def compared_as_written(name: str) -> bool:
    """Whether the words of a name are its own, one space between them: no number in words, no capitals, no "the"."""
    return _PLAIN.fullmatch(name) is not None and _SPECIAL.isdisjoint(name.split(" "))


def name_words(name: str | Sequence[str]) -> tuple[str, ...]:
    """The words that names are compared by; an article in front stays (see :func:`without_article`)."""
    if isinstance(name, str):
        if _PLAIN.fullmatch(name) is not None:
            words = tuple(name.split(" "))
            if _SPECIAL.isdisjoint(words):
                return words
        else:
            words = raw_words(name)
    else:
        words = tuple(name)
        if _SPECIAL.isdisjoint(words) and "".join(words).isalpha():
            return words
    last = len(words) - 1
    kept = [word for at, word in enumerate(words) if word and (word != "the" or at == last)]
    return tuple(_numbered(kept))


def without_article(words: tuple[str, ...]) -> tuple[str, ...]:
    """The words after the articles in front, if any word is left. A letter before a number is none: of "A4" and "B4"
    neither is "the four"."""
    at = 0
    while at < len(words) - 1 and words[at] in ARTICLES and not (len(words[at]) == 1 and is_identifier(words[at + 1])):
        at += 1
    return words[at:]


def owner(words: Sequence[str]) -> str:
    """Whose a name is by the article in front; empty: none tells."""
    articles = itertools.takewhile(ARTICLES.__contains__, words[:-1])
    return next((OWNERS[word] for word in articles if word in OWNERS), "")


def _numbered(words: list[str]) -> list[str]:
    found: list[str] = []
    at = 0
    while at < len(words):
        word = words[at]
        if word in ORDINALS:
            value = english_ordinals.ordinal([word])
            found.append(f"{int(value or 0)}th")
            at += 1
        elif word[0].isdigit() or word in NUMBER_WORDS:
            numeral, at = _number(words, at)
            found.append(numeral)
        elif word in ("number", "nr") and at + 1 < len(words) and _is_number(words[at + 1]):
            at += 1
        elif word == "point" and found and found[-1].isdigit() and at + 1 < len(words) and _digit(words[at + 1]):
            at += 1
            decimals = ""
            while at < len(words) and (digit := _digit(words[at])):
                decimals += digit
                at += 1
            found[-1] += f".{decimals}"
        else:
            found.append(word)
            at += 1
    return _joined(found)


def _is_number(word: str) -> bool:
    return word[0].isdigit() or word in NUMBER_WORDS or word in ORDINALS


def _digit(word: str) -> str:
    if word.isdigit() and word.isascii():
        return word
    return "0" if word in english_words.ZERO else str(english_words.DIGITS.get(word, ""))


def _number(words: list[str], at: int) -> tuple[str, int]:
    """The number that begins here, in digits, and the place after it."""
    word = words[at]
    ordinal = _ORDINAL_NUMERAL.fullmatch(word)
    if ordinal is not None:
        return f"{ordinal[1].lstrip('0') or '0'}th", at + 1
    end = at + 1
    while end < len(words) and (words[end] in NUMBER_WORDS or words[end] == "and" or words[end].isdigit()):
        end += 1
    if word in english_words.TENS and at + 1 < len(words) and words[at + 1] in ORDINALS:
        value = english_ordinals.ordinal(words[at : at + 2])
        if value is not None:
            return f"{int(value)}th", at + 2
    if end > at + 1 or not word[0].isdigit():
        # Only the number's own words: "bay three g" is not three thousand million.
        run = words[at:end]
        found = english_parts.cardinal(run, 0)
        if found is not None and found[1] > (1 if word[0].isdigit() else 0) and found[0] < 1e15:
            return str(int(found[0])), at + found[1]
    if word.isdecimal():
        return word.lstrip("0") or "0", at + 1
    whole, point, decimals = word.partition(".")
    if point and not decimals.strip("0"):
        return whole.lstrip("0") or "0", at + 1
    return word, at + 1


def _joined(words: list[str]) -> list[str]:
    """Digits said one by one are one number: "room one two three", "gate zero seven".

    Two digits are not: "bay one two" may be somebody who thought again.
    """
    found: list[str] = []
    at = 0
    while at < len(words):
        end = at
        while end < len(words) and len(words[end]) == 1 and words[end].isdigit():
            end += 1
        if end - at >= 3 or (end - at == 2 and words[at] == "0"):
            found.append("".join(words[at:end]).lstrip("0") or "0")
            at = end
        else:
            found.append(words[at])
            at += 1
    return found


def heard_otherwise(words: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """The same words with one or two of them taken for a number or letter that sounds alike; the first for a letter
    before a number alone ("bee three")."""
    coded = len(words) > 1 and _is_number(words[1]) and words[0] not in _NUMBER_ALIKES
    places = [place for place, word in enumerate(words) if word in ALIKES and (place or coded)][-4:]
    for count in (1, 2):
        for chosen in itertools.combinations(places, count):
            yield name_words([ALIKES[word] if place in chosen else word for place, word in enumerate(words)])


def singular(words: tuple[str, ...], endings: Sequence[tuple[str, str]] | None = None) -> Iterator[tuple[str, ...]]:
    """The same words with the last as one of what it names, by how a language makes more of it: "boxes", "batteries",
    "knives". Some of them are none.

    Args:
        words: a name.
        endings: of more of a thing, and of one of it; None: the English ones.
    """
    *before, last = words
    for ending, one in thing_words("en").plurals if endings is None else endings:
        stem = last.removesuffix(ending)
        if (stem != last or not ending) and (len(stem) > 1 or not stem) and stem + one:
            yield (*before, stem + one)


@lru_cache(maxsize=64)
def accented_names(known: frozenset[str]) -> Mapping[str, str]:
    """Words with accents, by the same without."""
    return {plain: word for word in sorted(known) if (plain := without_accents(word)) not in known}
