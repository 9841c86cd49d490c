"""The utterances of a grammar that sound most like some words: a search over the automaton, best first.

Each word of the grammar may stand for one to four words heard ("cappuccino" for "cap as you know"), may have been
missed, and each word heard may be noise. What that costs is counted in letters that differ, in spelling and sound.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from functools import lru_cache
from typing import Any, Protocol, TypeAlias

from intent_engine.language.likeness import sound

__all__ = ["FreeWord", "Graph", "nearest_utterances"]

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
"""Words that may follow, beyond which only those like the words heard are tried."""
CLOSE_WORDS = 24
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


@lru_cache(maxsize=200_000)
def _differ(word: str, heard: str) -> float:
    """Letters by which a word differs from what was heard, half of it by sound."""
    from rapidfuzz.distance import Levenshtein

    if word == heard:
        return 0.0
    spelled = Levenshtein.distance(word, heard)
    key, other = sound(word), _sound_of(heard)
    heard_apart = Levenshtein.distance(key, other) * max(len(word), 1) / max(len(key), 1)
    return 0.55 * spelled + 0.45 * float(heard_apart)


@lru_cache(maxsize=65_536)
def _sound_of(text: str) -> str:
    return sound(text)


def nearest_utterances(
    graph: Graph, heard: Sequence[str], most: int = 12, weighty: Collection[str] = ()
) -> list[tuple[tuple[str, ...], float]]:
    """Whole utterances nearest to the words heard.

    Args:
        graph: the grammar.
        heard: normalised words, numbers as words.
        most: how many to give.
        weighty: words that are hardly noise: "when", "not".

    Returns:
        (words, cost in letters) pairs, nearest first. Words of free slots are :class:`FreeWord`.
    """
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
    following: dict[Any, list[str]] = {}
    audible: dict[Any, list[str]] = {}
    close: dict[tuple[Any, str], list[str]] = {}

    def words_after(state: Any) -> list[str]:
        found = following.get(state)
        if found is None:
            words = graph.next_words(state, sounds=False)
            found = following[state] = [word for word in words if word and word[0].isalnum()]
        return found

    def heard_after(state: Any) -> list[str]:
        found = audible.get(state)
        if found is None:
            # A sound that fits anywhere would explain every word that was misheard, so it must be heard as it is.
            as_heard = said_anywhere.intersection(graph.next_words(state))
            found = audible[state] = list({*words_after(state), *graph.known_words(state), *as_heard})
        return found

    def candidates(state: Any, span: str) -> list[str]:
        words = heard_after(state)
        if len(words) <= MANY_WORDS:
            return words
        found = close.get((state, span))
        if found is None:
            from rapidfuzz import fuzz, process

            best = process.extract(span, words, scorer=fuzz.ratio, limit=CLOSE_WORDS, score_cutoff=40)
            found = close[(state, span)] = [word for word, _, _ in best]
        return found

    states: _States = {}
    for place in range(count + 1):
        states = {}
        _go(graph, states, pending[place])
        for _ in range(2):
            _go(graph, states, _missed_words(states, words_after))
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
                if span is None:
                    continue
                onward = pending[end]
                for word in candidates(state, span):
                    slack = len(word) - len(span)
                    if slack > 3 + len(span) // 2 or -slack > 3 + len(word) // 2:
                        continue
                    apart = _differ(word, span)
                    if apart > 0.7 * max(len(word), len(span)) + 0.5:
                        continue
                    onward.extend((cost + apart, said, state, word) for cost, said in ways)
    best: dict[tuple[str, ...], float] = {}
    for state, ways in states.items():
        if graph.accepting(state):
            for cost, said in ways:
                if said and cost < best.get(said, float("inf")):
                    best[said] = cost
    return heapq.nsmallest(most, best.items(), key=lambda row: (row[1], row[0]))


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


def _missed_words(states: _States, words_after: Callable[[Any], list[str]]) -> Iterator[_Move]:
    """Moves by a word of the grammar that was said, but not heard."""
    for state, ways in heapq.nsmallest(WIDTH // 2, states.items(), key=lambda item: item[1][0]):
        words = words_after(state)
        if len(words) > MANY_WORDS:
            continue
        cost, said = ways[0]
        for word in words:
            if len(word) <= 6:
                yield cost + MISSED_WORD + MISSED * len(word), said, state, word


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
