"""The beginnings of sentences that a guided search still follows, the most promising first."""

from __future__ import annotations

import bisect
import heapq
import itertools
import operator
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from intent_engine.speech.hypotheses.word_count import WORD, word_count
from intent_engine.speech.hypotheses.word_pieces import Pieces

__all__ = ["Frontier", "Path", "value_of"]

PIECE = 1.0
"""nats that a piece is expected to cost: so much may a longer beginning be behind and still be looked at first."""
DEEPER = 1.5
"""Of what is asked half stays near what is likeliest, and half goes deeper: there a piece may cost so many times what
those that were heard freely cost, besides."""
SHORT = 6
"""Pieces of what was heard freely, below which it may have been cut off."""
LONGER = 4
"""Pieces that a sentence may have more than these."""
PER_STATE = 2
"""Ways kept to each place of the grammar."""
BEAM = 10
"""Beginnings of the same number of pieces that are followed."""
BEHIND = 3.0
"""nats by which a beginning may be behind the best whole sentence."""
GIVEN_UP = 1.5
"""nats for each word, and four more, by which a beginning may be behind what was heard freely."""


@dataclass(frozen=True, slots=True)
class Path:
    """A beginning of a sentence."""

    score: float
    tokens: tuple[int, ...] = ()
    words: tuple[str, ...] = ()
    state: Any = None
    inside: Pieces | None = None
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


class Frontier:
    """The beginnings that are still followed in one search, the most promising first, and the sentences found."""

    def __init__(self, free_score: float, heard: int) -> None:
        self.found: dict[tuple[str, ...], float] = {}
        self._free_score = free_score
        self._heard = heard
        self._bonuses = (PIECE - DEEPER * free_score / max(heard, 1), PIECE)
        self._longest = max(heard, SHORT) + LONGER
        self._queue: list[tuple[float, int, Path]] = []
        self._order = itertools.count()
        self._kept: dict[tuple[Any, ...], list[float]] = {}
        self._beams: dict[int, list[float]] = {}

    def push(self, path: Path) -> None:
        """Follow a beginning, unless there are better ones to the same place, or it is hopeless."""
        if path.score < self._free_score - GIVEN_UP * (4 + len(path.words)) or len(path.tokens) > self._longest:
            return
        scores = self._kept.setdefault(path.place, [])
        if len(scores) >= PER_STATE and path.score <= scores[-1]:
            return
        _keep(scores, path.score, PER_STATE)
        _keep(self._beams.setdefault(len(path.tokens), []), path.value, BEAM)
        self.put_back(path)

    def put_back(self, path: Path) -> None:
        """Follow a beginning that was popped."""
        heapq.heappush(self._queue, (-self._promise(path, self._bonuses[0]), next(self._order), path))

    def _promise(self, path: Path, bonus: float) -> float:
        return path.score + bonus * min(len(path.tokens), self._heard)

    def choose(self, paths: Sequence[Path], most: int) -> list[tuple[int, ...]]:
        """Of beginnings that wait to be asked about, the most promising."""
        ways = [sorted(paths, key=lambda path: -self._promise(path, bonus)) for bonus in self._bonuses]
        return list(dict.fromkeys(path.tokens for turn in zip(*ways, strict=True) for path in turn))[:most]

    def pop(self) -> Path | None:
        """The most promising beginning; None if there is none."""
        while self._queue:
            path = heapq.heappop(self._queue)[2]
            if not self.behind(path):
                return path
        return None

    def behind(self, path: Path) -> bool:
        """Whether a whole sentence, or enough others of its length, are ahead of it by now."""
        if path.value < self._beams[len(path.tokens)][-1]:
            return True
        if not self.found:
            return False
        best = max(self.found.items(), key=value_of)
        # A beginning may still become as long as the sentence.
        return path.score + WORD * max(path.begun, word_count(best[0])) < value_of(best) - BEHIND


def _keep(best: list[float], value: float, most: int) -> None:
    """Put a value among the best, which are in falling order and no more than so many."""
    bisect.insort(best, value, key=operator.neg)
    del best[most:]


def value_of(found: tuple[tuple[str, ...], float]) -> float:
    """What a sentence that was found is compared by with others of other lengths."""
    words, score = found
    return score + WORD * word_count(words)
