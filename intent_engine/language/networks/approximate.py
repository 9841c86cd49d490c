"""The utterances of a grammar that sound most like some words: a search over the automaton, best first.

Each word of the grammar may stand for one to four words heard ("cappuccino" for "cap as you know"), may have been
missed, and each word heard may be noise. What that costs is counted in letters that differ, in spelling and sound.
"""

from __future__ import annotations

import bisect
import heapq
import math
import threading
from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

from intent_engine.language.words.likeness import sound

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

__all__ = ["FREE", "FreeWord", "Graph", "UtteranceSearch"]

MAX_SPAN = 4
"""Words heard that one word of the grammar may stand for."""
MISSED_WORD = 1.0
MISSED = 0.7
"""Cost of a word that was said but not heard, and of each letter of it."""
EXTRA = 0.9
"""Cost of a letter of a word that was heard but not said."""
WEIGHTY = 3.0
"""Times that a word costs more which would have changed what is meant, had it been said."""
FREE = 1.5
"""Cost of a word that a free slot takes as it was heard."""
WIDTH = 48
"""Partial sentences kept for each number of words heard,"""
WIDER = 96
"""and where it is looked wider, since what is found is not near: numbers crowd others out, which may begin with any of
a hundred words. "Going on towards the sitting room" was "going onward then ..."."""
NEAR = 0.2
"""Cost for each letter heard from which it is not, and"""
WIDER_WORDS = 12
"""words heard beyond which it is no single command."""
PER_STATE = 3
"""Ways kept to reach one state of the grammar."""
MANY_WORDS = 400
"""Words that may follow, beyond which none is taken for missed."""
CLOSE_WORDS = 24
"""Words that may stand for what was heard, the likest."""
MAX_KEPT = 20_000
"""States that are remembered, before all are forgotten."""
MAX_HEARD = 40
MAX_COMPARED = 256
"""Things heard of which it is remembered what is like them, before all are forgotten: those of ten utterances or so."""
MOST_MOVES = 3
"""Moves made towards one number of words heard for each partial sentence kept: the cheapest, and their like."""

_States: TypeAlias = dict[Any, list[tuple[float, tuple[str, ...]]]]
"""State -> the cheapest ways to it: cost, and words said."""
_Words: TypeAlias = "Sequence[tuple[float, str | None]]"
"""Words to go on with, each with its cost, the cheapest first; None: to stay. There is at least one."""
_Onward: TypeAlias = tuple[float, tuple[str, ...], Any, _Words]
"""Cost, words said and state before, and the words to go on with."""


class FreeWord(str):
    """A word that a free slot took as it was heard: it says nothing about whether the grammar was spoken."""

    __slots__ = ()


class Graph(Protocol):
    """What the search asks of a grammar."""

    def start(self) -> Any: ...

    def step(self, state: Any, word: str) -> Any | None: ...

    def next_words(self, state: Any, *, sounds: bool = True) -> Collection[str]: ...

    def accepting(self, state: Any) -> bool: ...

    def free(self, state: Any) -> bool: ...

    def known_words(self, state: Any) -> Collection[str]: ...


class Likeness:
    """How much words of a grammar differ from what was heard. The words that were asked about are kept, in one list, so
    that what is heard is compared to all of them at once."""

    def __init__(self) -> None:
        self._places: dict[str, int] = {}
        self._words: list[str] = []
        self._sounds: list[str] = []
        self._apart: dict[str, npt.NDArray[np.float64]] = {}

    def learn(self, words: Iterable[str]) -> None:
        """Words that will be asked about."""
        for word in words:
            if word not in self._places:
                self._places[word] = len(self._words)
                self._words.append(word)
                self._sounds.append(sound(word))

    def places(self, words: Iterable[str]) -> npt.NDArray[np.intp]:
        """Where some words stand in the list, ``(n,)``, in the order of the alphabet."""
        import numpy as np

        ordered = sorted(words)
        self.learn(ordered)
        return np.array([self._places[word] for word in ordered], np.intp)

    def likest(self, heard: str, places: npt.NDArray[np.intp]) -> list[tuple[float, str]]:
        """(letters that differ, word) of the words at some places that are like what was heard, the likest first; of
        words as like it the first in ``places``."""
        apart = self._apart.get(heard)
        if apart is None or len(apart) < len(self._words):
            self.hear([heard])
            apart = self._apart[heard]
        differ = apart[places]
        order = differ.argsort(kind="stable")[:CLOSE_WORDS]
        like = zip(differ[order].tolist(), places[order].tolist(), strict=True)
        return [(letters, self._words[place]) for letters, place in like if letters < math.inf]

    def __len__(self) -> int:
        """Things heard that words were compared to."""
        return len(self._apart)

    def forget(self) -> None:
        """Forget what was heard."""
        self._apart.clear()

    def hear(self, heard: Iterable[str]) -> None:
        """Compare what was heard to all words that it was not compared to yet."""
        import numpy as np

        known: dict[int, list[str]] = {}
        for one in dict.fromkeys(heard):
            known.setdefault(len(self._apart.get(one, ())), []).append(one)
        for count, some in known.items():
            if count < len(self._words):
                for one, apart in zip(some, self._compared(some, count), strict=True):
                    before = self._apart.get(one)
                    self._apart[one] = apart if before is None else np.concatenate((before, apart))

    def _compared(self, heard: Sequence[str], begin: int) -> npt.NDArray[np.float64]:
        """By how many letters words from a place of the list on, ``(words,)`` for each thing heard, differ from it,
        half by how they are written and half by sound; infinite: they are not like it."""
        import numpy as np
        from rapidfuzz.distance import Levenshtein
        from rapidfuzz.process import cdist

        words, sounds = self._words[begin:], self._sounds[begin:]
        letters = cdist(heard, words, scorer=Levenshtein.distance)
        keys = cdist([sound(one) for one in heard], sounds, scorer=Levenshtein.distance)
        lengths, key_lengths = (np.maximum([len(one) for one in some], 1) for some in (words, sounds))
        long = np.array([len(one) for one in heard])[:, np.newaxis]
        apart = 0.55 * letters + 0.45 * keys * lengths / key_lengths
        slack = lengths - long
        like = (slack <= 3 + long // 2) & (-slack <= 3 + lengths // 2)
        like &= apart <= 0.7 * np.maximum(lengths, long) + 0.5
        apart[~like] = math.inf
        apart[letters == 0] = 0.0
        found: npt.NDArray[np.float64] = apart
        return found


class UtteranceSearch:
    """Finds the utterances of one grammar that are like words heard. What it learns of the grammar it keeps.

    Args:
        graph: the grammar.
        vocabulary: words that it is known to have: what is heard is compared to all at once, and not to a few at a time
            as they are met.
    """

    def __init__(self, graph: Graph, vocabulary: Iterable[str] = ()) -> None:
        self.graph = graph
        self._likeness = Likeness()
        self._likeness.learn(sorted(vocabulary))
        self._after: dict[Any, tuple[tuple[str, ...], frozenset[str], frozenset[str]]] = {}
        self._alike: dict[frozenset[str], dict[str, list[tuple[float, str]]]] = {}
        """Of the words that may follow, those like what was heard. Many states have the same words after them."""
        self._listed: dict[frozenset[str], npt.NDArray[np.intp]] = {}
        """Where those words stand among all that what is heard is compared to."""
        self._alone = threading.Lock()
        self._missed: dict[Any, _Words] = {}
        """Words after a state that may have been said though they were not heard, the shortest first."""

    def words_after(self, state: Any) -> tuple[tuple[str, ...], frozenset[str], frozenset[str]]:
        """Words that may follow: those of sentences, these with the words known in free slots, and all with sounds."""
        found = self._after.get(state)
        if found is None:
            if len(self._after) > MAX_KEPT:
                for kept in (self._after, self._missed, self._alike, self._listed):
                    kept.clear()
            words = self.graph.next_words(state, sounds=False)
            proper = tuple(sorted(word for word in words if word and word[0].isalnum()))
            likely = frozenset((*proper, *self.graph.known_words(state)))
            found = self._after[state] = (proper, likely, likely.union(self.graph.next_words(state)))
            self._likeness.learn(sorted(likely))
        return found

    def single_words(self) -> tuple[str, ...]:
        """Words that are whole utterances."""
        start = self.graph.start()
        after = ((word, self.graph.step(start, word)) for word in self.words_after(start)[0])
        return tuple(word for word, state in after if state is not None and self.graph.accepting(state))

    def like(self, state: Any, span: str) -> list[tuple[float, str]]:
        """(letters that differ, word) of the words that may follow and are like what was heard, the likest first."""
        _, likely, all_words = self.words_after(state)
        # A sound that fits anywhere would explain every word that was misheard, so it must be heard as it is.
        if span in all_words and span not in likely:
            return [(0.0, span), *self._likest(likely, span)]
        return self._likest(likely, span)

    def _likest(self, likely: frozenset[str], span: str) -> list[tuple[float, str]]:
        alike = self._alike.setdefault(likely, {})
        found = alike.get(span)
        if found is None:
            listed = self._listed.get(likely)
            if listed is None:
                listed = self._listed[likely] = self._likeness.places(likely)
            found = alike[span] = self._likeness.likest(span, listed)
        return found

    def nearest(
        self,
        heard: Sequence[str],
        most: int = 12,
        weighty: Collection[str] = (),
        *,
        wider: bool = False,
        begin: Sequence[str] = (),
    ) -> list[tuple[tuple[str, ...], float]]:
        """Whole utterances nearest to the words heard. One thread at a time: of two models that ask at once, neither
        is answered sooner by searching beside the other.

        Args:
            heard: normalised words, numbers as words.
            most: how many to give.
            weighty: words that are hardly noise: "when", "not".
            wider: whether it is looked again, and wider, where nothing near is found.
            begin: words with which the utterances begin, and which cost nothing; what was heard follows them.

        Returns:
            (words, cost in letters) pairs, nearest first. Words of free slots are :class:`FreeWord`.
        """
        with self._alone:
            found = self._nearest(heard[:MAX_HEARD], most, weighty, WIDTH, begin)
            near = found and found[0][1] <= NEAR * sum(map(len, heard))
            if near or not wider or len(heard) > WIDER_WORDS:
                return found
            return self._nearest(heard, most, weighty, WIDER, begin)

    def _nearest(
        self, heard: Sequence[str], most: int, weighty: Collection[str], width: int, begin: Sequence[str]
    ) -> list[tuple[tuple[str, ...], float]]:
        graph = self.graph
        first = graph.start()
        for word in begin:
            first = graph.step(first, word)
            if first is None:
                return []
        count = len(heard)
        said_anywhere = set(heard)
        spans = {
            (begin, end): "".join(heard[begin:end])
            for begin in range(count)
            for end in range(begin + 1, min(begin + MAX_SPAN, count) + 1)
            if end == begin + 1 or not said_anywhere.intersection(weighty, heard[begin:end])
        }
        if len(self._likeness) > MAX_COMPARED:
            self._likeness.forget()
            self._alike.clear()
        self._likeness.hear(spans.values())
        # pending[i]: ways to go on that end with i words heard used up, none of them gone yet
        pending: list[list[_Onward]] = [[] for _ in range(count + 1)]
        states: _States = {first: [(0.0, tuple(begin))]}
        for place in range(count + 1):
            if place:
                states = {}
                _go(graph, states, pending[place], width)
            for _ in range(2):
                _go(graph, states, self._missed_words(states, width // 2), width)
            if place == count:
                break
            noise = EXTRA * len(heard[place]) * (WEIGHTY if heard[place] in weighty else 1.0)
            for state, ways in states.items():
                onward: list[tuple[int, _Words]] = [(place + 1, [(noise, None)])]
                if graph.free(state):
                    onward.append((place + 1, [(FREE, FreeWord(heard[place]))]))
                for end in range(place + 1, min(place + MAX_SPAN, count) + 1):
                    span = spans.get((place, end))
                    if span is not None and (like := self.like(state, span)):
                        onward.append((end, like))
                for end, words in onward:
                    pending[end].extend((cost, said, state, words) for cost, said in ways)
        best: dict[tuple[str, ...], float] = {}
        for state, ways in states.items():
            if graph.accepting(state):
                for cost, said in ways:
                    if said and cost < best.get(said, float("inf")):
                        best[said] = cost
        return heapq.nsmallest(most, best.items(), key=lambda row: (row[1], row[0]))

    def _missed_words(self, states: _States, most: int) -> Iterator[_Onward]:
        """Ways on from so many states by a word of the grammar that was said, but not heard."""
        for state, ways in heapq.nsmallest(most, states.items(), key=lambda item: item[1][0]):
            missed = self._missed.get(state)
            if missed is None:
                words, _, _ = self.words_after(state)
                short = [word for word in words if len(word) <= 6] if len(words) <= MANY_WORDS else []
                missed = [(MISSED_WORD + MISSED * len(word), word) for word in sorted(short, key=len)]
                self._missed[state] = missed
            if missed:
                cost, said = ways[0]
                yield cost, said, state, missed


def _go(graph: Graph, states: _States, onward: Iterable[_Onward], width: int) -> None:
    """Make the cheapest moves, until there are as many states as are kept.

    A step to a state that the automaton has not seen yet costs it a millisecond, so no step is taken for nothing; nor
    are words looked for that would cost too much.
    """
    # (cost, order, cost before, words said, state, words to go on with, which of them)
    queue = [(way[0] + way[3][0][0], order, *way, 0) for order, way in enumerate(onward)]
    heapq.heapify(queue)
    costs = sorted(ways[0][0] for ways in states.values())
    taken = 0
    while queue and taken < MOST_MOVES * width:
        cost, order, before, said, state, words, which = queue[0]
        if len(costs) >= width and cost >= costs[width - 1]:
            break
        if which + 1 < len(words):
            heapq.heapreplace(queue, (before + words[which + 1][0], order, before, said, state, words, which + 1))
        else:
            heapq.heappop(queue)
        word = words[which][1]
        reached = state if word is None else graph.step(state, word)
        if reached is None:
            continue
        taken += 1
        known = states.get(reached)
        if known is None:
            bisect.insort(costs, cost)
        elif cost < known[0][0]:
            costs.remove(known[0][0])
            bisect.insort(costs, cost)
        _push(states, reached, (cost, said if word is None else (*said, word)))
    for state, _ in sorted(states.items(), key=lambda item: item[1][0])[width:]:
        del states[state]


def _push(states: _States, state: Any, way: tuple[float, tuple[str, ...]]) -> None:
    """Keep a way to a state, if it is one of the cheapest."""
    known = states.setdefault(state, [])
    if len(known) >= PER_STATE and way[0] >= known[-1][0]:
        return
    same = next((other for other in known if other[1] == way[1]), None)
    if same is not None:
        if same[0] <= way[0]:
            return
        known.remove(same)
    known.append(way)
    known.sort()
    del known[PER_STATE:]
