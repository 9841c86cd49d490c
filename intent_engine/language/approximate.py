"""The utterances of a grammar that sound most like some words: a search over the automaton, best first.

Each word of the grammar may stand for one to four words heard ("cappuccino" for "cap as you know"), may have been
missed, and each word heard may be noise. What that costs is counted in letters that differ, in spelling and sound.
"""

from __future__ import annotations

import heapq
from collections.abc import Collection, Sequence
from functools import lru_cache
from typing import Any, Protocol

from intent_engine.language.likeness import sound

__all__ = ["Graph", "nearest_utterances"]

MAX_SPAN = 4
"""Words heard that one word of the grammar may stand for."""
MISSED = 0.7
"""Cost of a letter of a word that was said but not heard."""
EXTRA = 0.9
"""Cost of a letter of a word that was heard but not said."""
WIDTH = 48
"""Partial sentences kept for each number of words heard."""
PER_STATE = 3
"""Ways kept to reach one state of the grammar."""
MANY_WORDS = 400
"""Words that may follow, beyond which only those like the words heard are tried."""
CLOSE_WORDS = 24
MAX_HEARD = 40


class Graph(Protocol):
    """What the search asks of a grammar."""

    def start(self) -> Any: ...

    def step(self, state: Any, word: str) -> Any | None: ...

    def next_words(self, state: Any) -> Collection[str]: ...

    def accepting(self, state: Any) -> bool: ...


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


def nearest_utterances(graph: Graph, heard: Sequence[str], most: int = 12) -> list[tuple[tuple[str, ...], float]]:
    """Whole utterances nearest to the words heard.

    Args:
        graph: the grammar.
        heard: normalised words, numbers as words.
        most: how many to give.

    Returns:
        (words, cost in letters) pairs, nearest first.
    """
    heard = list(heard[:MAX_HEARD])
    count = len(heard)
    spans = {
        (begin, end): "".join(heard[begin:end])
        for begin in range(count)
        for end in range(begin + 1, min(begin + MAX_SPAN, count) + 1)
    }
    # frontier[i]: state -> the cheapest ways to it with i words heard used up
    frontier: list[dict[Any, list[tuple[float, tuple[str, ...]]]]] = [{} for _ in range(count + 1)]
    frontier[0][graph.start()] = [(0.0, ())]
    following: dict[Any, list[str]] = {}
    close: dict[tuple[Any, str], list[str]] = {}

    def words_after(state: Any) -> list[str]:
        found = following.get(state)
        if found is None:
            found = following[state] = [word for word in graph.next_words(state) if word and word[0].isalnum()]
        return found

    def candidates(state: Any, span: str) -> list[str]:
        words = words_after(state)
        if len(words) <= MANY_WORDS:
            return words
        found = close.get((state, span))
        if found is None:
            from rapidfuzz import fuzz, process

            best = process.extract(span, words, scorer=fuzz.ratio, limit=CLOSE_WORDS, score_cutoff=40)
            found = close[(state, span)] = [word for word, _, _ in best]
        return found

    for place in range(count + 1):
        _missed_words(graph, frontier[place], words_after)
        kept = _best_states(frontier[place])
        frontier[place] = dict(kept)
        if place == count:
            break
        for state, ways in kept:
            _push(frontier[place + 1], state, [(cost + EXTRA * len(heard[place]), said) for cost, said in ways])
            for end in range(place + 1, min(place + MAX_SPAN, count) + 1):
                span = spans[(place, end)]
                for word in candidates(state, span):
                    slack = len(word) - len(span)
                    if slack > 3 + len(span) // 2 or -slack > 3 + len(word) // 2:
                        continue
                    apart = _differ(word, span)
                    if apart > 0.7 * max(len(word), len(span)) + 0.5:
                        continue
                    onward = graph.step(state, word)
                    if onward is not None:
                        _push(frontier[end], onward, [(cost + apart, (*said, word)) for cost, said in ways])
    best: dict[tuple[str, ...], float] = {}
    for state, ways in frontier[count].items():
        if graph.accepting(state):
            for cost, said in ways:
                if said and cost < best.get(said, float("inf")):
                    best[said] = cost
    return heapq.nsmallest(most, best.items(), key=lambda row: (row[1], row[0]))


def _missed_words(graph: Graph, states: dict[Any, list[tuple[float, tuple[str, ...]]]], words_after: Any) -> None:
    """Let one or two words of the grammar be missed: said, but not heard."""
    for _ in range(2):
        for state, ways in _best_states(states)[: WIDTH // 2]:
            words = words_after(state)
            if len(words) > MANY_WORDS:
                continue
            for word in words:
                if len(word) > 6:
                    continue
                onward = graph.step(state, word)
                if onward is not None:
                    _push(states, onward, [(cost + 0.6 + MISSED * len(word), (*said, word)) for cost, said in ways[:1]])


def _push(
    states: dict[Any, list[tuple[float, tuple[str, ...]]]], state: Any, ways: list[tuple[float, tuple[str, ...]]]
) -> None:
    known = states.setdefault(state, [])
    for way in ways:
        if len(known) >= PER_STATE and way[0] >= known[-1][0]:
            continue
        same = next((other for other in known if other[1] == way[1]), None)
        if same is not None:
            if same[0] <= way[0]:
                continue
            known.remove(same)
        known.append(way)
        known.sort()
        del known[PER_STATE:]


def _best_states(
    states: dict[Any, list[tuple[float, tuple[str, ...]]]],
) -> list[tuple[Any, list[tuple[float, tuple[str, ...]]]]]:
    return heapq.nsmallest(WIDTH, states.items(), key=lambda item: item[1][0])
