"""The utterances of a grammar that sound most like some words: a search over the automaton, best first.

Each word of the grammar may stand for one to four words heard ("cappuccino" for "cap as you know"), may have been
missed, and each word heard may be noise. What that costs is counted in letters that differ, in spelling and sound.
"""

from __future__ import annotations

import bisect
import heapq
from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import Any, Protocol, TypeAlias

from intent_engine.language.likeness import sound

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
"""Partial sentences kept for each number of words heard."""
PER_STATE = 3
"""Ways kept to reach one state of the grammar."""
MANY_WORDS = 400
"""Words that may follow, beyond which none is taken for missed."""
CLOSE_WORDS = 24
"""Words that may stand for what was heard, the likest."""
MAX_KEPT = 20_000
"""States and things heard that are remembered, before all are forgotten."""
MAX_HEARD = 40
MOST_MOVES = 3 * WIDTH
"""Moves made towards one number of words heard: the cheapest, and their like."""

_States: TypeAlias = dict[Any, list[tuple[float, tuple[str, ...]]]]
"""State -> the cheapest ways to it: cost, and words said."""
_Onward: TypeAlias = "tuple[float, tuple[str, ...], Any, _Words]"
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
    that each thing heard is compared to all of them at once."""

    def __init__(self) -> None:
        self._known: set[str] = set()
        self._words: list[str] = []
        self._sounds: list[str] = []
        self._like: dict[str, tuple[int, list[tuple[float, str]]]] = {}

    def learn(self, words: Iterable[str]) -> None:
        """Words that will be asked about."""
        for word in words:
            if word not in self._known:
                self._known.add(word)
                self._words.append(word)
                self._sounds.append(sound(word))

    def like(self, heard: str) -> list[tuple[float, str]]:
        """(letters that differ, word) of the words like what was heard, the likest first."""
        count, found = self._like.get(heard, (0, []))
        if count < len(self._words):
            if len(self._like) > MAX_KEPT:
                self._like.clear()
            found = sorted([*found, *self._compared(heard, count)])
            self._like[heard] = (len(self._words), found)
        return found

    def _compared(self, heard: str, begin: int) -> list[tuple[float, str]]:
        """Words from a place of the list on that are like what was heard, half by their letters and half by sound."""
        import numpy as np
        from rapidfuzz.distance import Levenshtein
        from rapidfuzz.process import cdist

        words, sounds = self._words[begin:], self._sounds[begin:]
        letters = cdist([heard], words, scorer=Levenshtein.distance)[0]
        keys = cdist([sound(heard)], sounds, scorer=Levenshtein.distance)[0]
        lengths, key_lengths = (np.maximum([len(one) for one in some], 1) for some in (words, sounds))
        apart = 0.55 * letters + 0.45 * keys * lengths / key_lengths
        slack = lengths - len(heard)
        like = (slack <= 3 + len(heard) // 2) & (-slack <= 3 + lengths // 2)
        like &= apart <= 0.7 * np.maximum(lengths, len(heard)) + 0.5
        same = letters == 0
        (places,) = np.nonzero(like | same)
        return [(0.0 if same[place] else float(apart[place]), words[place]) for place in places.tolist()]


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
        self._missed: dict[Any, tuple[str, ...]] = {}
        """Words after a state that may have been said though they were not heard, the shortest first."""

    def words_after(self, state: Any) -> tuple[tuple[str, ...], frozenset[str], frozenset[str]]:
        """Words that may follow: those of sentences, these with the words known in free slots, and all with sounds."""
        found = self._after.get(state)
        if found is None:
            if len(self._after) > MAX_KEPT:
                self._after.clear()
                self._missed.clear()
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

    def like(self, state: Any, span: str) -> Iterator[tuple[float, str]]:
        """(letters that differ, word) of the words that may follow and are like what was heard."""
        _, likely, all_words = self.words_after(state)
        count = 0
        # A sound that fits anywhere would explain every word that was misheard, so it must be heard as it is.
        if span in all_words and span not in likely:
            yield 0.0, span
        for apart, word in self._likeness.like(span):
            if word in likely:
                yield apart, word
                count += 1
                if count == CLOSE_WORDS:
                    return

    def nearest(
        self, heard: Sequence[str], most: int = 12, weighty: Collection[str] = ()
    ) -> list[tuple[tuple[str, ...], float]]:
        """Whole utterances nearest to the words heard.

        Args:
            heard: normalised words, numbers as words.
            most: how many to give.
            weighty: words that are hardly noise: "when", "not".

        Returns:
            (words, cost in letters) pairs, nearest first. Words of free slots are :class:`FreeWord`.
        """
        graph = self.graph
        heard = list(heard[:MAX_HEARD])
        count = len(heard)
        said_anywhere = set(heard)
        spans = {
            (begin, end): "".join(heard[begin:end])
            for begin in range(count)
            for end in range(begin + 1, min(begin + MAX_SPAN, count) + 1)
            if end == begin + 1 or not said_anywhere.intersection(weighty, heard[begin:end])
        }
        # pending[i]: ways to go on that end with i words heard used up, none of them gone yet
        pending: list[list[_Onward]] = [[] for _ in range(count + 1)]
        states: _States = {graph.start(): [(0.0, ())]}
        for place in range(count + 1):
            if place:
                states = {}
                _go(graph, states, pending[place])
            for _ in range(2):
                _go(graph, states, self._missed_words(states))
            if place == count:
                break
            noise = EXTRA * len(heard[place]) * (WEIGHTY if heard[place] in weighty else 1.0)
            for state, ways in states.items():
                onward = [(place + 1, _Words([(noise, None)]))]
                if graph.free(state):
                    onward.append((place + 1, _Words([(FREE, FreeWord(heard[place]))])))
                for end in range(place + 1, min(place + MAX_SPAN, count) + 1):
                    span = spans.get((place, end))
                    if span is not None:
                        onward.append((end, _Words(self.like(state, span))))
                for end, words in onward:
                    pending[end].extend((cost, said, state, words) for cost, said in ways)
        best: dict[tuple[str, ...], float] = {}
        for state, ways in states.items():
            if graph.accepting(state):
                for cost, said in ways:
                    if said and cost < best.get(said, float("inf")):
                        best[said] = cost
        return heapq.nsmallest(most, best.items(), key=lambda row: (row[1], row[0]))

    def _missed_words(self, states: _States) -> Iterator[_Onward]:
        """Ways on by a word of the grammar that was said, but not heard."""
        for state, ways in heapq.nsmallest(WIDTH // 2, states.items(), key=lambda item: item[1][0]):
            missed = self._missed.get(state)
            if missed is None:
                words, _, _ = self.words_after(state)
                short = [word for word in words if len(word) <= 6] if len(words) <= MANY_WORDS else []
                missed = self._missed[state] = tuple(sorted(short, key=len))
            cost, said = ways[0]
            yield cost, said, state, _Words((MISSED_WORD + MISSED * len(word), word) for word in missed)


class _Words:
    """Words to go on with, the cheapest first, of which only those are made that are asked for."""

    __slots__ = ("_made", "_rest")

    def __init__(self, words: Iterable[tuple[float, str | None]]) -> None:
        self._rest = iter(words)
        self._made: list[tuple[float, str | None]] = []

    def get(self, place: int) -> tuple[float, str | None] | None:
        """(cost, word), where no word means to stay; None: there are no more. Asked one after the other."""
        if place == len(self._made):
            following = next(self._rest, None)
            if following is None:
                return None
            self._made.append(following)
        return self._made[place]


def _go(graph: Graph, states: _States, onward: Iterable[_Onward]) -> None:
    """Make the cheapest moves, until there are as many states as are kept.

    A step to a state that the automaton has not seen yet costs it a millisecond, so no step is taken for nothing; nor
    are words looked for that would cost too much.
    """
    # (cost, order, cost before, words said, state, words to go on with, which of them; -1: not looked at yet)
    queue = [(way[0], order, *way, -1) for order, way in enumerate(onward)]
    heapq.heapify(queue)
    costs = sorted(ways[0][0] for ways in states.values())
    taken = 0
    while queue and taken < MOST_MOVES:
        cost, order, before, said, state, words, which = heapq.heappop(queue)
        if len(costs) >= WIDTH and cost >= costs[WIDTH - 1]:
            break
        following = words.get(which + 1)
        if following is not None:
            heapq.heappush(queue, (before + following[0], order, before, said, state, words, which + 1))
        if which < 0:
            continue
        _, word = words.get(which)  # type: ignore[misc]  # it was there before
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
    for state, _ in sorted(states.items(), key=lambda item: item[1][0])[WIDTH:]:
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
