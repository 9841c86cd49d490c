"""Sentences that differ in one word from one that was probably said: what else may have been said there.

A sentence that is like the words heard seems sure as long as nothing else was thought of: "put down the mug", of which
one model heard "put down the rug", is far ahead of all others, until somebody asks about "book".
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
import numpy.typing as npt

from intent_engine.language.networks.approximate import UtteranceSearch
from intent_engine.language.numbers.spelled import in_digits, number_words
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import ARTICLES
from intent_engine.speech.acoustic.rows import Rows, total
from intent_engine.speech.acoustic.writing import WORDS_KEPT, Writer, spellings
from intent_engine.speech.hypotheses.detours import Detours, leads
from intent_engine.speech.hypotheses.word_pieces import MANY_WORDS

__all__ = ["Rivals"]

AT_A_PLACE = 3
"""Words at most for one place of a sentence."""
NUMBERS = 5
"""Numbers at most for one number, of which nearly any is a sentence."""
DIGITS = "1234567890"
"""All that a number is written with, of those that have one word."""
FIRST_DIGITS = 3
"""First digits that a number may have, whose second is asked for, where a model writes them one by one."""
LEAST = 1e-6
"""Least probability that a number ends."""
MAX_KEPT = 4000
"""Places of the grammar whose words are kept."""


class Rivals:
    """Finds what else may have been said, with one model's pieces and one grammar.

    Args:
        search: of the grammar, which knows the words after each of its states.
        writer: how the model writes the grammar's language.
        corrections: phrases that take back what was said before them.
    """

    def __init__(self, search: UtteranceSearch, writer: Writer, corrections: PhraseSet | None = None) -> None:
        self._search = search
        self._corrections = corrections or PhraseSet(())
        self._writer = writer
        self._number_words = number_words(writer.language)
        self._detours = Detours(search)
        self._first_pieces = lru_cache(WORDS_KEPT)(self._begun_with)
        self._spelled = lru_cache(WORDS_KEPT)(self._number_in_pieces)
        self._digits = self._digit_pieces()
        self._kept: dict[tuple[Any, bool], tuple[list[str], npt.NDArray[np.int64]]] = {}

    def pieces(self, words: Sequence[str], capital: bool = True) -> tuple[int, ...]:
        """Of a sentence as the model writes it, or writes the middle of one."""
        return self._writer.pieces(words, capital)

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
        return {
            place: rows[begin] if begin is not None else None
            for place, begin in self._begins(words, rows, widely=widely).items()
        }

    def _begins(self, words: Sequence[str], rows: Rows, *, widely: bool) -> dict[int, tuple[int, ...] | None]:
        """For the places of a sentence the pieces before it, as the model was asked about them."""
        several = {
            place + more
            for place in range(len(words))
            if (count := self._number_from(words, place)) > 1
            for more in range(count)
        }
        return {
            place: next(
                (one for one in self._beginnings(words[:place], in_words=place in several) if one in rows), None
            )
            for place in range(len(words))
            if widely or place not in several
        }

    def _beginnings(self, words: Sequence[str], *, in_words: bool) -> list[tuple[int, ...]]:
        """The pieces of the words that a sentence begins with, however they are written, or with numbers in words."""
        if not words:
            return [()]
        spelled = [tuple(words)] if in_words else self._writer.spellings(words)
        return [self.pieces(one, capital) for one in spelled for capital in (True, False)]

    def beside(
        self, words: Sequence[str], rows: Rows, near: float, *, widely: bool = False, far: bool = False
    ) -> dict[tuple[str, ...], str]:
        """Sentences beside one, likeliest first, each with the word of it in whose place they have another; or with a
        word that it has not, or not with one that it has; or with a number of one word in place of one of several.

        Args:
            words: of a sentence of the grammar.
            rows: how likely the model finds every piece in its places.
            near: nats by which the first piece of another word may be less likely.
            widely: whether also with another word in a number of several, with a word more, and with one less.
            far: whether also with a few other words, as :mod:`~intent_engine.speech.hypotheses.detours` has them.
        """
        graph = self._search.graph
        found: list[tuple[float, tuple[str, ...], str]] = []
        begins, chances = self._begins(words, rows, widely=widely), _Chances(rows)
        for place, (word, state) in enumerate(zip(words, self._states(words), strict=False)):
            if state is None:
                continue
            begin = begins.get(place)
            others, pieces = self._words_after(state, word, place == 0)
            if begin is not None:
                row = rows[begin]
                said = max(float(row[piece]) for piece in self._first_pieces(word, place == 0))
                if number := words[place : place + self._number_from(words, place)]:
                    said = max(said, self._likelihood(number, begin, chances) + chances.total(begin))
                    found += [
                        (behind, (*words[:place], *onward), word)
                        for behind, other in self._other_numbers(others, number, begin, chances)
                        if behind <= near and leads(graph, state, onward := (other, *words[place + len(number) :]))
                    ]
                for behind, other in _likeliest(others, row[pieces] - said, near, word):
                    rest = tuple(words[place:])
                    if far:
                        ends = self._detours.ways(state, other, rest)
                    else:
                        ends = [end for end in self._onward(rest, other, widely=widely) if leads(graph, state, end)]
                    found += [(behind, (*words[:place], *end), word) for end in ends]
        return {sentence: word for _, sentence, word in sorted(found)}

    def _states(self, words: Sequence[str]) -> list[Any]:
        """The states of the grammar before each word of a sentence, as far as it knows them; None before those of a
        correction. What comes after one goes on from a beginning of what was said before it."""
        known, _ = self._walked(self._search.graph.start(), words)
        said = len(known) - 1
        length = self._corrections.at(words, said)
        for state in reversed(known) if length else ():
            after, whole = self._walked(state, words[said + length :])
            if whole:
                return [*known[:said], *[None] * length, *after]
        return known

    def _walked(self, state: Any, words: Sequence[str]) -> tuple[list[Any], bool]:
        """The states before some words and after each, as far as they go; and whether they go to the last."""
        states = [state]
        for word in words:
            state = self._search.graph.step(state, word)
            if state is None:
                return states, False
            states.append(state)
        return states, True

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

    def _begun_with(self, word: str, first: bool) -> list[int]:
        """The first pieces of a word, and of a number in digits, unless it begins as all numbers do."""
        capitals = (True, False) if first else (False,)
        spelled = self._writer.spellings([word])
        pieces = [self.pieces(one, capital)[0] for one in spelled for capital in capitals]
        return [piece for piece in pieces if piece not in self._digits[:1]] or pieces

    # -- numbers ------------------------------------------------------------------------------------

    def _number_from(self, words: Sequence[str], place: int) -> int:
        """Of how many words the number is that begins at a place; 0 if none begins there."""
        if place and words[place - 1] in self._number_words:
            return 0
        return sum(1 for _ in itertools.takewhile(self._number_words.__contains__, words[place:]))

    def digits(self, words: Sequence[str], rows: Rows) -> list[tuple[int, ...]]:
        """Beginnings of numbers in digits that a model has still to be asked about, which writes them digit by digit:
        its first piece is the same for all numbers.

        Args:
            words: of the sentence.
            rows: what it made of some beginnings.
        """
        if not self._digits:
            return []
        sign, *digits = self._digits
        wanted = []
        for place, begin in self._begins(words, rows, widely=True).items():
            if begin is None or not self._number_from(words, place):
                continue
            signed = (*begin, sign)
            if signed not in rows:
                wanted.append(signed)
            else:
                likely = sorted(digits, key=lambda digit: -rows[signed][digit])[:FIRST_DIGITS]
                wanted += [(*signed, digit) for digit in likely if (*signed, digit) not in rows]
        return wanted

    def _digit_pieces(self) -> list[int]:
        """The piece before every number in digits, and the digits; nothing where there is no such piece."""
        pieces = [self._writer.encode(digit) for digit in DIGITS]
        if any(len(one) != 2 or one[0] != pieces[0][0] for one in pieces):
            return []
        return [pieces[0][0], *(one[1] for one in pieces)]

    def _other_numbers(
        self, others: Iterable[str], number: Sequence[str], begin: tuple[int, ...], chances: _Chances
    ) -> list[tuple[float, str]]:
        """Numbers of one word that may stand for a whole number: (nats behind, word), the likeliest first."""
        said = self._likelihood(number, begin, chances)
        found = sorted(
            (said - self._likelihood([other], begin, chances), other)
            for other in self._number_words.intersection(others)
            if [other] != list(number)
        )
        values: dict[tuple[str, ...], tuple[float, str]] = {}
        for behind, other in found:
            # "Forty", and not "fourty" too.
            values.setdefault(in_digits([other], self._writer.language), (behind, other))
        return list(values.values())[:NUMBERS]

    def _likelihood(self, number: Sequence[str], begin: tuple[int, ...], chances: _Chances) -> float:
        """Of a number after some pieces, however it is spelled: by its first piece, or its first digits where a model
        writes them one by one and was asked about them."""
        likely = -math.inf
        for pieces in self._spelled(tuple(number)):
            one_by_one = pieces[0] in self._digits[:1]
            chance = chances.of(begin, pieces[:3] if one_by_one else pieces[:1])
            if one_by_one and (ended := begin + pieces) in chances.rows:
                chance += chances.none_of(ended, self._digits[1:])
            likely = max(likely, chance)
        return likely

    def _number_in_pieces(self, number: tuple[str, ...]) -> list[tuple[int, ...]]:
        """The pieces of a number inside a sentence, in all its spellings."""
        return [self.pieces(one, False) for one in spellings(number, self._writer.language)]

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


class _Chances:
    """Log probabilities of pieces, from rows that have them up to a constant in each.

    Args:
        rows: what a model made of some beginnings.
    """

    def __init__(self, rows: Rows) -> None:
        self.rows = rows
        self._totals: dict[tuple[int, ...], float] = {}

    def total(self, begin: tuple[int, ...]) -> float:
        """The constant of a row."""
        if begin not in self._totals:
            self._totals[begin] = total(self.rows[begin])
        return self._totals[begin]

    def of(self, begin: tuple[int, ...], pieces: tuple[int, ...]) -> float:
        """Of some pieces after others, as far as the model was asked."""
        chance = 0.0
        for place, piece in enumerate(pieces):
            before = begin + pieces[:place]
            if before not in self.rows:
                break
            chance += float(self.rows[before][piece]) - self.total(before)
        return chance

    def none_of(self, begin: tuple[int, ...], pieces: Sequence[int]) -> float:
        """Of anything but some pieces after others."""
        any_of = math.exp(total(self.rows[begin][list(pieces)]) - self.total(begin))
        return math.log(max(1.0 - any_of, LEAST))


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
