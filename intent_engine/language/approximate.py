"""The utterances of a grammar that sound most like some words: a search over the automaton, best first.

Each word of the grammar may stand for one to four words heard ("cappuccino" for "cap as you know"), may have been
missed, and each word heard may be noise. What that costs is counted in letters that differ, in spelling and sound.
"""

from __future__ import annotations

import heapq
from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import Any, Protocol, TypeAlias

from intent_engine.language.likeness import sound

__all__ = ["FreeWord", "Graph", "UtteranceSearch"]

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
_Move: TypeAlias = tuple[float, tuple[str, ...], Any, str | None]
"""Cost afterwards, words said before, state before, and the word to go on with; None: stay, a word heard is noise."""


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
        self._place: dict[str, int] = {}
        self._words: list[str] = []
        self._sounds: list[str] = []
        self._like: dict[str, tuple[int, list[tuple[float, str]]]] = {}

    def learn(self, words: Iterable[str]) -> None:
        """Words that will be asked about."""
        for word in words:
            if word not in self._place:
                self._place[word] = len(self._words)
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

    def _compared(self, heard: str, begin: int) -> Iterator[tuple[float, str]]:
        """Words from a place of the list on that are like what was heard, half by their letters and half by sound."""
        from rapidfuzz.distance import Levenshtein
        from rapidfuzz.process import cdist

        words, sounds = self._words[begin:], self._sounds[begin:]
        spelled = cdist([heard], words, scorer=Levenshtein.distance)[0].tolist()
        sounded = cdist([sound(heard)], sounds, scorer=Levenshtein.distance)[0].tolist()
        for word, key, letters, heard_apart in zip(words, sounds, spelled, sounded, strict=True):
            if not letters:
                yield 0.0, word
                continue
            slack = len(word) - len(heard)
            if slack > 3 + len(heard) // 2 or -slack > 3 + len(word) // 2:
                continue
            apart = 0.55 * letters + 0.45 * heard_apart * max(len(word), 1) / max(len(key), 1)
            if apart <= 0.7 * max(len(word), len(heard)) + 0.5:
                yield apart, word


class UtteranceSearch:
    """Finds the utterances of one grammar that are like words heard. What it learns of the grammar it keeps."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self._likeness = Likeness()
        self._after: dict[Any, tuple[tuple[str, ...], frozenset[str], frozenset[str]]] = {}

    def words_after(self, state: Any) -> tuple[tuple[str, ...], frozenset[str], frozenset[str]]:
        """Words that may follow: those of sentences, these with the words known in free slots, and all with sounds."""
        found = self._after.get(state)
        if found is None:
            if len(self._after) > MAX_KEPT:
                self._after.clear()
            words = self.graph.next_words(state, sounds=False)
            proper = tuple(sorted(word for word in words if word and word[0].isalnum()))
            likely = frozenset((*proper, *self.graph.known_words(state)))
            found = self._after[state] = (proper, likely, likely.union(self.graph.next_words(state)))
            self._likeness.learn(sorted(likely))
        return found

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
        pending: list[list[_Move]] = [[] for _ in range(count + 1)]
        pending[0].append((0.0, (), graph.start(), None))
        states: _States = {}
        for place in range(count + 1):
            states = {}
            _go(graph, states, pending[place])
            for _ in range(2):
                _go(graph, states, self._missed_words(states))
            if place == count:
                break
            noise = EXTRA * len(heard[place]) * (WEIGHTY if heard[place] in weighty else 1.0)
            for state, ways in states.items():
                for cost, said in ways:
                    pending[place + 1].append((cost + noise, said, state, None))
                if graph.free(state):
                    taken = FreeWord(heard[place])
                    pending[place + 1].extend((cost + FREE, said, state, taken) for cost, said in ways)
                for end in range(place + 1, min(place + MAX_SPAN, count) + 1):
                    span = spans.get((place, end))
                    if span is not None:
                        onward = pending[end]
                        for apart, word in self.like(state, span):
                            onward.extend((cost + apart, said, state, word) for cost, said in ways)
        best: dict[tuple[str, ...], float] = {}
        for state, ways in states.items():
            if graph.accepting(state):
                for cost, said in ways:
                    if said and cost < best.get(said, float("inf")):
                        best[said] = cost
        return heapq.nsmallest(most, best.items(), key=lambda row: (row[1], row[0]))

    def _missed_words(self, states: _States) -> Iterator[_Move]:
        """Moves by a word of the grammar that was said, but not heard."""
        for state, ways in heapq.nsmallest(WIDTH // 2, states.items(), key=lambda item: item[1][0]):
            words, _, _ = self.words_after(state)
            if len(words) > MANY_WORDS:
                continue
            cost, said = ways[0]
            for word in words:
                if len(word) <= 6:
                    yield cost + MISSED_WORD + MISSED * len(word), said, state, word


def _go(graph: Graph, states: _States, moves: Iterable[_Move]) -> None:
    """Make the cheapest moves, until there are as many states as are kept.

    A step to a state that the automaton has not seen yet costs it a millisecond, so no step is taken for nothing.
    """
    queue = sorted(moves, key=_cost)
    limit = _dearest(states)
    taken = 0
    for cost, said, state, word in queue:
        if taken >= MOST_MOVES or cost >= limit:
            break
        reached = state if word is None else graph.step(state, word)
        if reached is None:
            continue
        taken += 1
        fresh = reached not in states
        _push(states, reached, (cost, said if word is None else (*said, word)))
        if fresh:
            limit = _dearest(states)
    for state, _ in sorted(states.items(), key=lambda item: item[1][0])[WIDTH:]:
        del states[state]


def _cost(move: _Move) -> float:
    return move[0]


def _dearest(states: _States) -> float:
    """Cost at which a further state would not be kept."""
    if len(states) < WIDTH:
        return float("inf")
    return heapq.nsmallest(WIDTH, (ways[0][0] for ways in states.values()))[-1]


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
