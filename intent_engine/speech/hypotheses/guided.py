"""The sentences of a grammar that the model itself finds likeliest, searched piece by piece along the automaton.

Words that were heard wrongly lead to the wrong sentences: "real water stop" is like "get water", not like "robot stop".
Here the grammar says which words may come next and the model says how likely each of them is, given the sound.

A decoder takes no such advice, but it can be made to begin with given pieces, and tells how likely every piece is at
each place: along those it was given, and along those that it then adds freely. So a few calls, each for a handful of
beginnings at once, tell nearly all that the search asks.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from intent_engine.language.networks.approximate import UtteranceSearch
from intent_engine.language.numbers.spelled import in_words
from intent_engine.speech.acoustic.writing import Writer
from intent_engine.speech.hypotheses.frontier import Frontier, Path, value_of
from intent_engine.speech.hypotheses.word_pieces import Pieces, WordPieces

__all__ = ["DEEP", "USUAL", "Effort", "GuidedSearch", "NextPieces"]

AHEAD = 3
"""Pieces that the model adds freely to the longest beginning that it is asked about."""
UNLIKELY = -9.0
"""Log probability of a piece that is not looked at any more,"""
UNLIKELY_DIGITS = -7.0
"""of digits, of which there are so many,"""
UNLIKELY_COMMA = -2.0
"""and of a comma, which may be left out."""
FOUND = 12
"""Sentences given."""
BLANKS = "[\u0120\u2581]"
"""How tokenizers write the blank before a word."""


@dataclass(frozen=True, slots=True)
class Effort:
    """How much a search may cost."""

    calls: int
    """Calls of the model,"""
    batch: int
    """and beginnings that it is asked about in one."""
    steps: int
    """Beginnings looked at."""


USUAL = Effort(calls=6, batch=4, steps=600)
DEEP = Effort(calls=20, batch=8, steps=3000)
"""Long sentences of which much was misheard are found by this alone; it takes five times as long."""

NextPieces: TypeAlias = Callable[
    [Sequence[tuple[int, ...]], int], Iterable[tuple[tuple[int, ...], npt.NDArray[np.float32]]]
]
"""What the model says of some beginnings: asked with the beginnings and the pieces that a sentence may have, it gives
(beginning, log probability of every next piece), also of beginnings that begin with these."""
_Row: TypeAlias = dict[int, float]
"""The pieces that are likely enough, with their log probabilities: a few hundred of fifty thousand."""


class GuidedSearch:
    """Searches one grammar with one model's pieces.

    Args:
        search: of the grammar, which knows the words after each of its states.
        writer: how the model writes the grammar's language.
        end: the piece that stands for the end of a sentence; None: the full stop.
    """

    def __init__(self, search: UtteranceSearch, writer: Writer, end: int | None = None) -> None:
        self._graph = search.graph
        self._writer = writer
        tokenizer = writer.tokenizer
        self._pieces = WordPieces(search, writer)
        (self._point,) = tokenizer.encode(".")
        self._stop = self._point if end is None else end
        (self._comma,) = tokenizer.encode(",")
        vocabulary: dict[str, int] = tokenizer.tokenizer.get_vocab()
        plain = {number: re.sub(BLANKS, " ", piece) for piece, number in vocabulary.items()}
        # A model with single digits writes the blank before a number apart.
        digits = {
            number: piece
            for number, piece in plain.items()
            if piece == " " or (piece.lstrip(" ").isascii() and piece.lstrip(" ").isdigit())
        }
        self._first_digits = {number: piece.strip() for number, piece in digits.items() if piece[0] == " "}
        self._more_digits = {number: piece for number, piece in digits.items() if piece[0] != " "}

    def likeliest(
        self,
        ask: NextPieces,
        heard: Sequence[str],
        free: str,
        free_score: float,
        drafts: Sequence[str] = (),
        effort: Effort = USUAL,
    ) -> list[tuple[tuple[str, ...], float]]:
        """Sentences of the grammar that explain the sound best.

        Args:
            ask: the model.
            heard: the words heard freely, normalised.
            free: the same as the model wrote them.
            free_score: their log probability.
            drafts: sentences of the grammar that may be meant; they cost no further call.
            effort: how much it may cost.

        Returns:
            (words, log probability with a full stop) pairs, likeliest first, at most :data:`FOUND`.
        """
        pieces = self._writer.encode(free.strip())
        seeds = [pieces, *map(self._writer.encode, drafts)]
        length = max(map(len, seeds)) + 2
        rows = {beginning: self._likely(row) for beginning, row in ask(list(dict.fromkeys(seeds)), length)}
        frontier = Frontier(free_score, len(pieces))
        frontier.push(Path(0.0, state=self._graph.start(), large=not free.strip()[:1].islower()))
        steps = 0
        for call in range(effort.calls):
            waiting: list[Path] = []
            while steps < effort.steps and (path := frontier.pop()) is not None:
                row = rows.get(path.tokens)
                if row is None:
                    waiting.append(path)
                    continue
                steps += 1
                for further in self._further(path, row, heard, frontier.found):
                    frontier.push(further)
            waiting = [path for path in waiting if not frontier.behind(path)]
            if not waiting or call == effort.calls - 1:
                break
            asked = frontier.choose(waiting, effort.batch)
            length = max(length, AHEAD + max(map(len, asked)))
            for beginning, chances in ask(asked, length):
                if beginning not in rows:
                    rows[beginning] = self._likely(chances)
            for path in waiting:
                frontier.put_back(path)
        return sorted(frontier.found.items(), key=value_of, reverse=True)[:FOUND]

    def _likely(self, row: npt.NDArray[np.float32]) -> _Row:
        """A row without what is not looked at; with the signs between words, however unlikely."""
        numbers = np.flatnonzero(row > UNLIKELY)
        likely = dict(zip(numbers.tolist(), row[numbers].tolist(), strict=True))
        likely.update((number, float(row[number])) for number in (self._stop, self._point, self._comma))
        return likely

    def _further(
        self, path: Path, row: _Row, heard: Sequence[str], found: dict[tuple[str, ...], float]
    ) -> Iterable[Path]:
        """A beginning with one piece more, in every way that the grammar has; whole sentences go to ``found``."""
        if path.digits is not None:
            for number in self._more_digits.keys() & row.keys():
                if row[number] > UNLIKELY_DIGITS:
                    yield self._on(path, row, number, digits=path.digits + self._more_digits[number])
            if path.digits and "." not in path.digits:
                yield self._on(path, row, self._point, digits=path.digits + ".")
            if path.digits and not path.digits.endswith("."):
                spelled = in_words([path.digits], self._writer.language)
                yield from self._after(path, row, spelled, heard, found)
        elif path.inside is not None:
            yield from self._into(path, row, path.inside, path.words, path.state)
            for word in path.inside.words:
                yield from self._after(path, row, [word], heard, found)
        else:
            yield from self._between(path, row, path.words, path.state, heard, found)

    def _after(
        self, path: Path, row: _Row, said: Sequence[str], heard: Sequence[str], found: dict[tuple[str, ...], float]
    ) -> Iterable[Path]:
        """What may follow the words that a path ends with, if the grammar has them there."""
        state = path.state
        for word in said:
            state = self._graph.step(state, word)
            if state is None:
                return
        yield from self._between(path, row, (*path.words, *said), state, heard, found)

    def _between(
        self,
        path: Path,
        row: _Row,
        words: tuple[str, ...],
        state: Any,
        heard: Sequence[str],
        found: dict[tuple[str, ...], float],
    ) -> Iterable[Path]:
        """Between two words: the sentence is over, or the next word begins."""
        if words and self._graph.accepting(state):
            score = path.score + row[self._stop]
            found[words] = max(score, found.get(words, -math.inf))
        pieces = self._pieces.following(state, path.large, heard)
        yield from self._into(path, row, pieces, words, state)
        if pieces.numbers:
            for number in self._first_digits.keys() & row.keys():
                if row[number] > UNLIKELY_DIGITS:
                    yield self._on(path, row, number, words=words, state=state, digits=self._first_digits[number])
        if path.tokens and path.tokens[-1] != self._comma and row[self._comma] > UNLIKELY_COMMA:
            yield self._on(path, row, self._comma, words=words, state=state)

    def _into(self, path: Path, row: _Row, pieces: Pieces, words: tuple[str, ...], state: Any) -> Iterable[Path]:
        """One piece further into a word."""
        for number in pieces.after.keys() & row.keys():
            yield self._on(path, row, number, words=words, state=state, inside=pieces.after[number])

    def _on(
        self,
        path: Path,
        row: _Row,
        number: int,
        *,
        words: tuple[str, ...] | None = None,
        state: Any = None,
        inside: Pieces | None = None,
        digits: str | None = None,
    ) -> Path:
        return Path(
            path.score + row[number],
            (*path.tokens, number),
            path.words if words is None else words,
            path.state if state is None else state,
            inside,
            digits,
        )
