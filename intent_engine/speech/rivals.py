"""Sentences that differ in one word from one that was probably said: what else may have been said there.

A sentence that is like the words heard seems sure as long as nothing else was thought of: "put down the mug", of which
one model heard "put down the rug", is far ahead of all others, until somebody asks about "book".
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from intent_engine.language.approximate import UtteranceSearch
from intent_engine.language.free_text import ARTICLES
from intent_engine.language.numbers.english import NUMBER_WORDS
from intent_engine.speech.guided import MANY_WORDS
from intent_engine.speech.scoring import Rows
from intent_engine.speech.writing import spellings, written

__all__ = ["Rivals"]

AT_A_PLACE = 3
"""Words at most for one place of a sentence."""
MAX_KEPT = 4000
"""Places of the grammar whose words are kept."""


class Rivals:
    """Finds what else may have been said, with one model's pieces and one grammar.

    Args:
        search: of the grammar, which knows the words after each of its states.
        tokenizer: of the model, as faster-whisper's.
        language: of the grammar.
    """

    def __init__(self, search: UtteranceSearch, tokenizer: Any, language: str | None) -> None:
        self._search = search
        self._tokenizer = tokenizer
        self._language = language
        self._firsts: dict[tuple[str, bool], list[int]] = {}
        self._kept: dict[tuple[Any, bool], tuple[list[str], npt.NDArray[np.int64]]] = {}

    def pieces(self, words: Sequence[str], capital: bool = True) -> tuple[int, ...]:
        """Of a sentence as the model writes it, or writes the middle of one."""
        return tuple(self._tokenizer.encode(" " + written(words, self._language, sentence=capital)))

    def before(
        self, words: Sequence[str], rows: Rows, *, widely: bool = False
    ) -> dict[int, npt.NDArray[np.float32] | None]:
        """For the places of a sentence what a model made of them; None where it was not asked about one.

        Args:
            words: of the sentence.
            rows: what it made of some beginnings.
            widely: whether also for the words of numbers of several words. They are mostly written in digits, so that
                they are known only where the model was asked about the sentence in words.
        """
        places: dict[int, list[tuple[int, ...]]] = {}
        for number, run in itertools.groupby(range(len(words)), lambda place: words[place] in NUMBER_WORDS):
            run_places = list(run)
            several = number and len(run_places) > 1
            if widely or not several:
                places.update((place, self._beginnings(words[:place], in_words=several)) for place in run_places)
        return {place: next((rows[one] for one in some if one in rows), None) for place, some in places.items()}

    def _beginnings(self, words: Sequence[str], *, in_words: bool) -> list[tuple[int, ...]]:
        """The pieces of the words that a sentence begins with, however they are written, or with numbers in words."""
        if not words:
            return [()]
        spelled = [tuple(words)] if in_words else spellings(words, self._language)
        return [self.pieces(one, capital) for one in spelled for capital in (True, False)]

    def beside(
        self, words: Sequence[str], rows: Rows, near: float, *, widely: bool = False
    ) -> dict[tuple[str, ...], str]:
        """Sentences beside one, likeliest first, each with the word of it in whose place they have another; or with a
        word that it has not, or not with one that it has.

        Args:
            words: of a sentence of the grammar.
            rows: how likely the model finds every piece in its places.
            near: nats by which the first piece of another word may be less likely.
            widely: whether also with another word in a number of several, with a word more, and with one less.
        """
        graph = self._search.graph
        state = graph.start()
        found: list[tuple[float, tuple[str, ...], str]] = []
        before = self.before(words, rows, widely=widely)
        for place, word in enumerate(words):
            row = before.get(place)
            others, pieces = self._words_after(state, word, place == 0)
            if row is not None:
                said = max(float(row[piece]) for piece in self._first_pieces(word, place == 0))
                for behind, other in _likeliest(others, row[pieces] - said, near, word):
                    found += [
                        (behind, (*words[:place], *onward), word)
                        for onward in self._onward(tuple(words[place:]), other, widely=widely)
                        if self._leads(state, onward)
                    ]
            state = graph.step(state, word)
            if state is None:
                break
        return {sentence: word for _, sentence, word in sorted(found)}

    @staticmethod
    def _onward(words: tuple[str, ...], other: str, *, widely: bool) -> Iterator[tuple[str, ...]]:
        """Words with another in place of the first; or also with it before the first, unless it is an article, and
        without the first, if it is the second."""
        yield (other, *words[1:])
        if widely:
            if other not in ARTICLES:  # "two a box" is no other thing
                yield (other, *words)
            if words[1:2] == (other,):
                yield words[1:]

    def _leads(self, state: Any, words: Sequence[str]) -> bool:
        """Whether words lead from a state of the grammar to the end of a sentence."""
        graph = self._search.graph
        for word in words:
            state = graph.step(state, word)
            if state is None:
                return False
        return bool(graph.accepting(state))

    def _first_pieces(self, word: str, first: bool) -> list[int]:
        """Of a word, and of a number in digits."""
        found = self._firsts.get((word, first))
        if found is None:
            capitals = (True, False) if first else (False,)
            found = [self.pieces(one, capital)[0] for one in spellings([word], self._language) for capital in capitals]
            self._firsts[word, first] = found
        return found

    def _words_after(self, state: Any, said: str, first: bool) -> tuple[list[str], npt.NDArray[np.int64]]:
        """The words that may follow, each with a first piece; of very many those that are like the one said."""
        known = self._kept.get((state, first))
        if known is None:
            _, likely, _ = self._search.words_after(state)
            many = len(likely) > MANY_WORDS
            words = sorted({word for _, word in self._search.like(state, said)} if many else likely)
            pairs = [(word, piece) for word in words for piece in self._first_pieces(word, first)]
            known = [word for word, _ in pairs], np.array([piece for _, piece in pairs], dtype=np.int64)
            if not many:
                if len(self._kept) >= MAX_KEPT:
                    self._kept.clear()
                self._kept[state, first] = known
        return known


def _likeliest(words: Sequence[str], ahead: npt.NDArray[np.float32], near: float, said: str) -> list[tuple[float, str]]:
    """(nats behind, word) of the likeliest words but one.

    Args:
        words: of which each may be here several times.
        ahead: nats by which each is likelier than that one.
        near: nats by which one may be less likely.
        said: that one.
    """
    found: dict[str, float] = {}
    for at in np.argsort(-ahead, kind="stable").tolist():
        if -ahead[at] > near or len(found) == AT_A_PLACE:
            break
        if words[at] != said:
            found.setdefault(words[at], -float(ahead[at]))
    return [(behind, word) for word, behind in found.items()]
