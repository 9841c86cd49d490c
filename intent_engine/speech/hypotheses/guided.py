"""The sentences of a grammar that the model itself finds likeliest, searched piece by piece along the automaton.

Words that were heard wrongly lead to the wrong sentences: "real water stop" is like "get water", not like "robot stop".
Here the grammar says which words may come next and the model says how likely each of them is, given the sound.

A decoder takes no such advice, but it can be made to begin with given pieces, and tells how likely every piece is at
each place: along those it was given, and along those that it then adds freely. So a few calls, each for a handful of
beginnings at once, tell nearly all that the search asks.
"""

from __future__ import annotations

import bisect
import heapq
import itertools
import math
import operator
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from intent_engine.language.approximate import UtteranceSearch
from intent_engine.language.numbers.english import NUMBER_WORDS
from intent_engine.language.numbers.spelled import in_words, number_words
from intent_engine.speech.acoustic.writing import Writer

__all__ = ["DEEP", "USUAL", "WORD", "Effort", "GuidedSearch", "NextPieces", "word_count"]

AHEAD = 3
"""Pieces that the model adds freely to the longest beginning that it is asked about."""
PIECE = 1.0
"""nats that a piece is expected to cost: so much may a longer beginning be behind and still be looked at first."""
DEEPER = 1.5
"""Of what is asked half stays near what is likeliest, and half goes deeper: there a piece may cost so many times what
those that were heard freely cost, besides."""
SHORT = 6
"""Pieces of what was heard freely, below which it may have been cut off."""
LONGER = 4
"""Pieces that a sentence may have more than these."""
WORD = 2.0
"""nats that a word more may cost: without it "right" would be likelier than a "return to the starting point" of which
only half was heard well."""
PER_STATE = 2
"""Ways kept to each place of the grammar."""
BEAM = 10
"""Beginnings of the same number of pieces that are followed."""
BEHIND = 3.0
"""nats by which a beginning may be behind the best whole sentence."""
GIVEN_UP = 1.5
"""nats for each word, and four more, by which a beginning may be behind what was heard freely."""
UNLIKELY = -9.0
"""Log probability of a piece that is not looked at any more,"""
UNLIKELY_DIGITS = -7.0
"""of digits, of which there are so many,"""
UNLIKELY_COMMA = -2.0
"""and of a comma, which may be left out."""
FOUND = 12
"""Sentences given."""
LONG_FILLER = 5
"""Letters of a word that may be said anywhere ("robot", "please"), from which the sound tells it from a mishearing."""
MANY_WORDS = 1500
"""Words that may follow, beyond which only those like what was heard are asked about: names of a very large map."""
BLANKS = "[\u0120\u2581]"
"""How tokenizers write the blank before a word."""
MAX_TRIES = 4000
"""Places of the grammar whose words are kept in pieces."""


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


@dataclass(slots=True)
class _Pieces:
    """Words as a tree of pieces: which pieces may come next, and which words end here."""

    after: dict[int, _Pieces] = field(default_factory=dict)
    words: list[str] = field(default_factory=list)
    numbers: bool = False
    """Whether a number in digits may come as well."""


@dataclass(frozen=True, slots=True)
class _Path:
    """A beginning of a sentence."""

    score: float
    tokens: tuple[int, ...] = ()
    words: tuple[str, ...] = ()
    state: Any = None
    inside: _Pieces | None = None
    """Within a word: the pieces that it may go on with."""
    digits: str | None = None
    """Within a number in digits: those so far; none yet where a model writes the blank before a number apart."""
    large: bool = False
    """Whether the next word begins with a capital."""

    @property
    def begun(self) -> int:
        """Words, with that which is being said."""
        return word_count(self.words) + (self.inside is not None or self.digits is not None)

    @property
    def value(self) -> float:
        """What it is compared by with others of other lengths."""
        return self.score + WORD * self.begun

    @property
    def place(self) -> tuple[Any, ...]:
        """What may follow hangs on this alone."""
        return (self.state, id(self.inside), self.digits)


class _Frontier:
    """The beginnings that are still followed in one search, the most promising first, and the sentences found."""

    def __init__(self, free_score: float, heard: int) -> None:
        self.found: dict[tuple[str, ...], float] = {}
        self._free_score = free_score
        self._heard = heard
        self._bonuses = (PIECE - DEEPER * free_score / max(heard, 1), PIECE)
        self._longest = max(heard, SHORT) + LONGER
        self._queue: list[tuple[float, int, _Path]] = []
        self._order = itertools.count()
        self._kept: dict[tuple[Any, ...], list[float]] = {}
        self._beams: dict[int, list[float]] = {}

    def push(self, path: _Path) -> None:
        """Follow a beginning, unless there are better ones to the same place, or it is hopeless."""
        if path.score < self._free_score - GIVEN_UP * (4 + len(path.words)) or len(path.tokens) > self._longest:
            return
        scores = self._kept.setdefault(path.place, [])
        if len(scores) >= PER_STATE and path.score <= scores[-1]:
            return
        _keep(scores, path.score, PER_STATE)
        _keep(self._beams.setdefault(len(path.tokens), []), path.value, BEAM)
        self.put_back(path)

    def put_back(self, path: _Path) -> None:
        """Follow a beginning that was popped."""
        heapq.heappush(self._queue, (-self._promise(path, self._bonuses[0]), next(self._order), path))

    def _promise(self, path: _Path, bonus: float) -> float:
        return path.score + bonus * min(len(path.tokens), self._heard)

    def choose(self, paths: Sequence[_Path], most: int) -> list[tuple[int, ...]]:
        """Of beginnings that wait to be asked about, the most promising."""
        ways = [sorted(paths, key=lambda path: -self._promise(path, bonus)) for bonus in self._bonuses]
        return list(dict.fromkeys(path.tokens for turn in zip(*ways, strict=True) for path in turn))[:most]

    def pop(self) -> _Path | None:
        """The most promising beginning; None if there is none."""
        while self._queue:
            path = heapq.heappop(self._queue)[2]
            if not self.behind(path):
                return path
        return None

    def behind(self, path: _Path) -> bool:
        """Whether a whole sentence, or enough others of its length, are ahead of it by now."""
        if path.value < self._beams[len(path.tokens)][-1]:
            return True
        if not self.found:
            return False
        best = max(self.found.items(), key=_value)
        # A beginning may still become as long as the sentence.
        return path.score + WORD * max(path.begun, word_count(best[0])) < _value(best) - BEHIND


class GuidedSearch:
    """Searches one grammar with one model's pieces.

    Args:
        search: of the grammar, which knows the words after each of its states.
        writer: how the model writes the grammar's language.
        end: the piece that stands for the end of a sentence; None: the full stop.
    """

    def __init__(self, search: UtteranceSearch, writer: Writer, end: int | None = None) -> None:
        self._search = search
        self._graph = search.graph
        self._writer = writer
        tokenizer = writer.tokenizer
        self._encoded: dict[tuple[str, bool], tuple[tuple[int, ...], ...]] = {}
        self._tries: dict[tuple[Any, bool], _Pieces] = {}
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
        frontier = _Frontier(free_score, len(pieces))
        frontier.push(_Path(0.0, state=self._graph.start(), large=not free.strip()[:1].islower()))
        steps = 0
        for call in range(effort.calls):
            waiting: list[_Path] = []
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
        return sorted(frontier.found.items(), key=_value, reverse=True)[:FOUND]

    def _likely(self, row: npt.NDArray[np.float32]) -> _Row:
        """A row without what is not looked at; with the signs between words, however unlikely."""
        numbers = np.flatnonzero(row > UNLIKELY)
        likely = dict(zip(numbers.tolist(), row[numbers].tolist(), strict=True))
        likely.update((number, float(row[number])) for number in (self._stop, self._point, self._comma))
        return likely

    def _further(
        self, path: _Path, row: _Row, heard: Sequence[str], found: dict[tuple[str, ...], float]
    ) -> Iterable[_Path]:
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
        self, path: _Path, row: _Row, said: Sequence[str], heard: Sequence[str], found: dict[tuple[str, ...], float]
    ) -> Iterable[_Path]:
        """What may follow the words that a path ends with, if the grammar has them there."""
        state = path.state
        for word in said:
            state = self._graph.step(state, word)
            if state is None:
                return
        yield from self._between(path, row, (*path.words, *said), state, heard, found)

    def _between(
        self,
        path: _Path,
        row: _Row,
        words: tuple[str, ...],
        state: Any,
        heard: Sequence[str],
        found: dict[tuple[str, ...], float],
    ) -> Iterable[_Path]:
        """Between two words: the sentence is over, or the next word begins."""
        if words and self._graph.accepting(state):
            score = path.score + row[self._stop]
            found[words] = max(score, found.get(words, -math.inf))
        pieces = self._words_after(state, path.large, heard)
        yield from self._into(path, row, pieces, words, state)
        if pieces.numbers:
            for number in self._first_digits.keys() & row.keys():
                if row[number] > UNLIKELY_DIGITS:
                    yield self._on(path, row, number, words=words, state=state, digits=self._first_digits[number])
        if path.tokens and path.tokens[-1] != self._comma and row[self._comma] > UNLIKELY_COMMA:
            yield self._on(path, row, self._comma, words=words, state=state)

    def _into(self, path: _Path, row: _Row, pieces: _Pieces, words: tuple[str, ...], state: Any) -> Iterable[_Path]:
        """One piece further into a word."""
        for number in pieces.after.keys() & row.keys():
            yield self._on(path, row, number, words=words, state=state, inside=pieces.after[number])

    def _on(
        self,
        path: _Path,
        row: _Row,
        number: int,
        *,
        words: tuple[str, ...] | None = None,
        state: Any = None,
        inside: _Pieces | None = None,
        digits: str | None = None,
    ) -> _Path:
        return _Path(
            path.score + row[number],
            (*path.tokens, number),
            path.words if words is None else words,
            path.state if state is None else state,
            inside,
            digits,
        )

    def _words_after(self, state: Any, first: bool, heard: Sequence[str]) -> _Pieces:
        """The words that may follow, in pieces."""
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
        pieces = _Pieces(numbers=not (numbers and numbers.isdisjoint(likely)))
        for word in words:
            for spelled in self._in_pieces(word, first):
                at = pieces
                for number in spelled:
                    at = at.after.setdefault(number, _Pieces())
                at.words.append(word)
        if not many:
            if len(self._tries) >= MAX_TRIES:
                self._tries.clear()
            self._tries[state, first] = pieces
        return pieces

    def _in_pieces(self, word: str, first: bool) -> Iterable[tuple[int, ...]]:
        """A word as it is written, with a capital at the beginning; and with one if it is a name."""
        found = self._encoded.get((word, first))
        if found is None:
            names = self._writer.names
            named = word if names is None else names.large(word)
            pieces = (self._writer.pieces([one], first) for one in (word, named))
            found = self._encoded[word, first] = tuple(dict.fromkeys(pieces))
        return found


def _keep(best: list[float], value: float, most: int) -> None:
    """Put a value among the best, which are in falling order and no more than so many."""
    bisect.insort(best, value, key=operator.neg)
    del best[most:]


def _value(found: tuple[tuple[str, ...], float]) -> float:
    """What a sentence that was found is compared by with others of other lengths."""
    words, score = found
    return score + WORD * word_count(words)


@lru_cache(maxsize=4096)
def word_count(words: tuple[str, ...]) -> int:
    """Words, a number of several as one: "8120" is said in five, "a hundred" in as many as "eight hundred"."""
    number = [False] * (len(words) + 1)
    for place in reversed(range(len(words))):
        joins = words[place] == "a" or (words[place] == "and" and place > 0 and words[place - 1] in NUMBER_WORDS)
        number[place] = words[place] in NUMBER_WORDS or (joins and number[place + 1])
    return sum(1 for before, here in itertools.pairwise([False, *number[:-1]]) if not (before and here))


def _spans(heard: Sequence[str]) -> set[str]:
    """The words heard, and what up to four of them are together."""
    return {
        "".join(heard[begin:end])
        for begin in range(len(heard))
        for end in range(begin + 1, min(begin + 4, len(heard)) + 1)
    }
