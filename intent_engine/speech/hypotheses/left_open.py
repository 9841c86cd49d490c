"""Words that were heard, with which a command means something else, and that a sentence has not: "or", "at most"."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.spelled import number_words

__all__ = ["open_range", "open_word"]


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
    return sorted(shared.intersection(leaving_open))[:1]


def open_range(
    words: Sequence[str], heard: Sequence[Sequence[str]], ranging: Collection[str], language: str | None = None
) -> Sequence[str]:
    """The words between two numbers that several models all heard, where a sentence has fewer: "two to four" is no "two
    o four", and "thirty to forty two times" may be no "thirty two". Empty: it has as many.

    Args:
        words: of the sentence.
        heard: the words that each model heard.
        ranging: what says "to" in the language.
        language: two letters; None: English.
    """
    own = len(list(_ranges(words, ranging, language)))
    found = [list(_ranges(one, ranging, language)) for one in heard]
    return found[0][own] if found and all(len(one) > own for one in found) else ()


def _ranges(words: Sequence[str], ranging: Collection[str], language: str | None) -> Iterator[Sequence[str]]:
    numbers = number_words(language)
    for at in range(1, len(words) - 1):
        one, to, other = words[at - 1 : at + 2]
        if to in ranging and all(word in numbers or is_numeral(word) for word in (one, other)):
            yield one, to, other
