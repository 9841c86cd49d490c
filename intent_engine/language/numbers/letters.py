"""Letters that stand beside a number, and make a code with it: "bay *B* 3", "12 *A*"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.spelled import number_words

__all__ = ["is_letter_of_a_code"]


def is_letter_of_a_code(words: Sequence[str], place: int, language: str | None = "en") -> bool:
    """Whether a word is a letter with a number beside it.

    Args:
        words: of an utterance.
        place: of the word.
        language: of the numbers that are written as words; None: English.
    """
    word, numbers = words[place], number_words(language)
    if len(word) != 1 or not word.isalpha() or word in numbers:
        return False
    beside = (*words[max(place - 1, 0) : place], *words[place + 1 : place + 2])
    return any(one in numbers or is_numeral(one) for one in beside)
