"""The words that may follow a place of a grammar, as a tree of a model's pieces."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from intent_engine.language.networks.approximate import UtteranceSearch
from intent_engine.language.numbers.spelled import number_words
from intent_engine.speech.acoustic.writing import WORDS_KEPT, Writer

__all__ = ["MANY_WORDS", "Pieces", "WordPieces"]

LONG_FILLER = 5
"""Letters of a word that may be said anywhere ("robot", "please"), from which the sound tells it from a mishearing."""
MANY_WORDS = 1500
"""Words that may follow, beyond which only those like what was heard are asked about: names of a very large map."""
MAX_TRIES = 4000
"""Places of the grammar whose words are kept in pieces."""


@dataclass(slots=True)
class Pieces:
    """Words as a tree of pieces: which pieces may come next, and which words end here."""

    after: dict[int, Pieces] = field(default_factory=dict)
    words: list[str] = field(default_factory=list)
    numbers: bool = False
    """Whether a number in digits may come as well."""


class WordPieces:
    """The words of one grammar in one model's pieces; those of a place are made once, when they are first asked for.

    Args:
        search: of the grammar, which knows the words after each of its states.
        writer: how the model writes the grammar's language.
    """

    def __init__(self, search: UtteranceSearch, writer: Writer) -> None:
        self._search = search
        self._writer = writer
        self._spelled = lru_cache(WORDS_KEPT)(self._in_pieces)
        self._tries: dict[tuple[Any, bool], Pieces] = {}

    def following(self, state: Any, first: bool, heard: Sequence[str]) -> Pieces:
        """The words that may follow a state of the grammar.

        Args:
            state: of the grammar.
            first: whether the next word is the first of a sentence, which is written with a capital.
            heard: the words heard freely; where too many may follow, only those like some of these do.
        """
        pieces = self._tries.get((state, first))
        if pieces is not None:
            return pieces
        _, likely, sounds = self._search.words_after(state)
        words = set(likely)
        many = len(words) > MANY_WORDS
        if many:
            words = {word for span in _spans(heard) for _, word in self._search.like(state, span)}
        # A short sound that fits anywhere ("so") would explain whatever was misheard.
        words.update(word for word in sounds if word[:1].isalnum() and (len(word) >= LONG_FILLER or not likely))
        numbers = number_words(self._writer.language)  # of a language of which none are known, any word may be one
        pieces = Pieces(numbers=not (numbers and numbers.isdisjoint(likely)))
        for word in words:
            for spelled in self._spelled(word, first):
                at = pieces
                for number in spelled:
                    at = at.after.setdefault(number, Pieces())
                at.words.append(word)
        if not many:
            if len(self._tries) >= MAX_TRIES:
                self._tries.clear()
            self._tries[state, first] = pieces
        return pieces

    def _in_pieces(self, word: str, first: bool) -> tuple[tuple[int, ...], ...]:
        """A word as it is written, with a capital at the beginning; and with one if it is a name."""
        names = self._writer.names
        named = word if names is None else names.large(word)
        return tuple(dict.fromkeys(self._writer.pieces([one], first) for one in (word, named)))


def _spans(heard: Sequence[str]) -> set[str]:
    """The words heard, and what up to four of them are together."""
    return {
        "".join(heard[begin:end])
        for begin in range(len(heard))
        for end in range(begin + 1, min(begin + 4, len(heard)) + 1)
    }
