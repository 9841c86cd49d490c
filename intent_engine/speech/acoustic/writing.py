"""How Whisper writes what the grammar knows as plain words: "that's", not "thats". A sentence is only as likely as it
looks, so it is asked about in the model's own writing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from intent_engine.language.normalize import TITLES, elided, without_accents
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.ordinals_spelled import ordinals_in_figures
from intent_engine.language.numbers.spelled import in_digits
from intent_engine.language.numbers.units import units
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import ARTICLES

__all__ = ["WORDS_KEPT", "Names", "Writer", "spellings", "written"]

WORDS_KEPT = 20_000
"""Words of which is kept how a model writes them: those of a large map. What is heard in months must not add up."""

TWO_FIGURES = 2
"""Figures of a number to which an "a" may belong as a letter."""

_WRITTEN = {
    "i": "I",
    "id": "I'd",
    "im": "I'm",
    "ive": "I've",
    "lets": "let's",
    "thats": "that's",
    "its": "it's",
    "whats": "what's",
    "wheres": "where's",
    "theres": "there's",
    "youre": "you're",
    "youll": "you'll",
    "oclock": "o'clock",
}
"""English words that lose a sign when they are normalised."""
_TITLES = {meant: f"{title.capitalize()}." for title, (meant,) in TITLES.items() if title != "prof"}
"""How titles are written before names."""


def written(words: Sequence[str], language: str | None, *, sentence: bool = True) -> str:
    """Words as one text, with the signs and capitals of a sentence.

    Args:
        words: normalised.
        language: of the words.
        sentence: whether they begin one.
    """
    english = language in (None, "en")
    text = " ".join(_WRITTEN.get(word, word) for word in words) if english else elided(" ".join(words), language)
    return text[:1].upper() + text[1:] if sentence else text


def spellings(words: Sequence[str], language: str | None, names: Names | None = None) -> list[tuple[str, ...]]:
    """Words as they may be spelled: numbers in words, and in digits, "60%", in English "20th" and "B3", and in other
    languages "45°"; names small and plain, and with a capital; in English "José", and "Jose"; a wake word without a
    comma after it, and with one.

    Args:
        words: normalised.
        language: of the words.
        names: how words are written that are not small and plain; None: all are.
    """
    counted = [in_digits(words, language)]
    if language in (None, "en") and (ordinals := ordinals_in_figures(words)) != tuple(words):
        counted.append(in_digits(ordinals))
    numbers = dict.fromkeys((tuple(words), *(one for way in counted for one in _with_signs(way, language))))
    named = [tuple(map(names.large, spelled)) for spelled in numbers] if names is not None else []
    coded = [_with_codes(spelled) for spelled in numbers] if language in (None, "en") else []
    found = dict.fromkeys((*numbers, *named, *coded))
    if language in (None, "en") and not all(map(str.isascii, words)):
        found |= dict.fromkeys([tuple(map(without_accents, spelled)) for spelled in found])
    if names is not None and (count := names.calls.at(words, 0)):
        found |= dict.fromkeys([(*one[: count - 1], f"{one[count - 1]},", *one[count:]) for one in found])
    return list(found)


def _with_signs(words: Sequence[str], language: str | None) -> list[tuple[str, ...]]:
    """Words with "60%" for 60 percent; and in other languages than English, which is written "45 degrees", with the
    comma of a number, and with "45°" besides."""
    if language in (None, "en"):
        return [_signed(words, {"percent": "%"})]
    plain = [word.replace(".", ",") if is_numeral(word) else word for word in words]
    table = units(language)
    names = {} if table is None else {word: key for (word, *more), key in table.names.items() if not more}
    percents = {word: "%" for word, key in names.items() if key == "percent"}
    degrees = {word: "°" for word, key in names.items() if key == "deg"}
    return [_signed(plain, percents), _signed(plain, percents | degrees)]


def _with_codes(words: Sequence[str]) -> tuple[str, ...]:
    """Words with every letter that stands beside a number in figures written together with it: "B3", "12A"; but "make
    a 180". Of eight commands with such a code by synthetic voices seven are 2 to 5 nats likelier so for tiny.en, and
    seven 0 to 6 for Moonshine."""
    found: list[str] = []
    for word in words:
        last = found[-1] if found else ""
        joins = word.isdigit() and _is_letter(last) and (last not in ARTICLES or len(word) <= TWO_FIGURES)
        if joins or (last.isdigit() and _is_letter(word)):
            found[-1] = (last + word).upper()
        else:
            found.append(word)
    return tuple(found)


def _is_letter(word: str) -> bool:
    return len(word) == 1 and word.isalpha()


def _signed(words: Sequence[str], signs: Mapping[str, str]) -> tuple[str, ...]:
    """Words with signs at the numbers before them in place of some."""
    found: list[str] = []
    for word in words:
        if word in signs and found and found[-1][-1:].isdigit():
            found[-1] += signs[word]
        else:
            found.append(word)
    return tuple(found)


class Names:
    """Words that are not written small and plain: as the grammar has them, such as a model has only with a capital, by
    its pieces ("Marco" is one to Whisper, "marco" two), letters by themselves ("sample B"), and "Dr.".

    Of 28 commands with a name of the second kind by synthetic voices ("tell Julia ...", "play the Beatles") all are 1
    to 10 nats likelier so, for tiny.en and for Moonshine; "hotel" is 2 to 5 less likely.

    Args:
        tokenizer: of the model.
        known: words with a capital or an apostrophe, by the same small and plain.
        calls: by which the robot is called, with a comma: "Robot, turn left".
    """

    def __init__(self, tokenizer: Any, known: Mapping[str, str] | None = None, calls: PhraseSet | None = None) -> None:
        self.calls = calls if calls is not None else PhraseSet(())
        self._tokenizer = tokenizer
        self._known = {**(known or {}), **_TITLES}
        self._made = lru_cache(WORDS_KEPT)(self._as_written)

    def large(self, word: str) -> str:
        """A word as it may be written; the same, if only so."""
        return self._known.get(word) or self._made(word)

    def _as_written(self, word: str) -> str:
        return word.capitalize() if self._is_name(word) else word

    def _is_name(self, word: str) -> bool:
        if not word.isalpha() or word in _WRITTEN:
            return False
        if len(word) == 1:
            return word not in ARTICLES
        small, large = (len(self._tokenizer.encode(" " + one)) for one in (word, word.capitalize()))
        return large < small


@dataclass(frozen=True, slots=True)
class Writer:
    """How one model writes one language, in its pieces."""

    tokenizer: Any
    """Of the model, as faster-whisper's."""
    language: str | None
    names: Names | None = None
    """Words that it may write with a capital; None: none."""

    def encode(self, text: str) -> tuple[int, ...]:
        """The pieces of a text that stands at the beginning of another, or behind a word."""
        return tuple(self.tokenizer.encode(" " + text))

    def pieces(self, words: Sequence[str], capital: bool = True) -> tuple[int, ...]:
        """The pieces of normalised words, as of a sentence, or as of the middle of one."""
        return self.encode(written(words, self.language, sentence=capital))

    def spellings(self, words: Sequence[str]) -> list[tuple[str, ...]]:
        """As :func:`spellings`."""
        return spellings(words, self.language, self.names)
