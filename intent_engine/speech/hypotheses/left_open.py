"""Words that were heard, with which a command means something else, and that a sentence has not: "or", "at most"."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence

from intent_engine.language.numbers.numerals import is_numeral, numeral_value
from intent_engine.language.numbers.spelled import number_words
from intent_engine.speech.hypotheses.evidence import letters_apart

__all__ = ["open_range", "open_word"]

LONG = 6
"""Letters of a word from which recognisers that do not know it write it as several: "or sato" for "risotto";"""
IN_PIECES = 0.5
"""and share of its letters by which these differ from it at most."""

_SIGN = re.compile(r"(?<![\d./-])(\d{1,9})\s?([-–/])\s?(\d{1,9})(?![\d/-])")


def open_word(words: Sequence[str], heard: Sequence[Sequence[str]], leaving_open: Collection[str]) -> Sequence[str]:
    """The word that several models all heard and a sentence has not, with which nobody knows what to do: with "open the
    door or close the door" nobody says "open the door and close the door". Empty: there is none.

    Args:
        words: of the sentence.
        heard: the words that each model heard.
        leaving_open: such words of the language.
    """
    if not heard:
        return ()
    shared = set.intersection(*map(set, heard)) - set(words)
    found = sorted(shared.intersection(leaving_open))
    return [word for word in found if not all(_is_piece(word, words, one) for one in heard)][:1]


def _is_piece(word: str, words: Sequence[str], heard: Sequence[str]) -> bool:
    """Whether a word that a model heard is, with the ones beside it, a long word of a sentence that it did not hear."""
    place = heard.index(word)
    unheard = [own for own in words if len(own) >= LONG and own not in heard]
    parts = [heard[begin:end] for begin in (max(place - 1, 0), place) for end in (place + 1, place + 2)]
    strange = [part for part in parts if len(part) > 1 and set(words).isdisjoint(part)]
    return any(
        letters_apart([own], part) <= IN_PIECES * max(len(own), len("".join(part)))
        for own in unheard
        for part in strange
    )


def open_range(
    words: Sequence[str],
    heard: Sequence[Sequence[str]],
    ranging: Collection[str],
    language: str | None = None,
    *,
    texts: Sequence[str] = (),
) -> Sequence[str]:
    """The words between two numbers that several models all heard, where a sentence has fewer: "two to four" is no "two
    o four", and "thirty to forty two times" may be no "thirty two". Empty: it has as many.

    Args:
        words: of the sentence.
        heard: the words that each model heard.
        ranging: what says "to" in the language.
        language: two letters; None: English.
        texts: the same as each wrote them, perhaps as "2-4".
    """
    own = len(list(_ranges(words, ranging, language)))
    written = [list(_written(text)) for text in texts] or [[] for _ in heard]
    found = [[*_ranges(one, ranging, language), *more] for one, more in zip(heard, written, strict=True)]
    return found[0][own] if found and all(len(one) > own for one in found) else ()


def _ranges(words: Sequence[str], ranging: Collection[str], language: str | None) -> Iterator[Sequence[str]]:
    numbers = number_words(language)
    for at in range(1, len(words) - 1):
        one, to, other = words[at - 1 : at + 2]
        if to in ranging and all(word in numbers or is_numeral(word) for word in (one, other)):
            yield one, to, other


def _written(text: str) -> Iterator[Sequence[str]]:
    """Ranges that are written with a sign: "2-4", and "4/6", which is no part of one."""
    for found in _SIGN.finditer(text):
        first, sign, last = found.groups()
        if int(first) < int(last) and (sign != "/" or numeral_value(f"{first}/{last}") is None):
            yield (found[0],)
