"""Other ways through a grammar from one place of a sentence to a later one: what was said may differ from the sentence
that seems likeliest in more than a word.

"Make me" may have been said in place of "an", "dark roast" between two words, and "forty" in place of "for two". In
long sentences a search piece by piece finds such a way late or never.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from typing import Any

from intent_engine.language.networks.approximate import UtteranceSearch
from intent_engine.language.words.thing_words import ARTICLES

__all__ = ["Detours", "leads"]

WORDS = 3
"""Words that a detour may have."""
LEFT_OUT = 3
"""Words of the sentence that it may leave out."""
BRANCHES = 40
"""Words that may follow one, beyond which a detour goes no further: numbers, and the names of a map."""
MOST = 4
"""Detours with the same first word, of those that lead to the end of a sentence."""


class Detours:
    """Finds them, in one grammar.

    Args:
        search: of the grammar, which knows the words after each of its states.
    """

    def __init__(self, search: UtteranceSearch) -> None:
        self._search = search

    def ways(self, state: Any, other: str, rest: Sequence[str]) -> list[tuple[str, ...]]:
        """Other ends of a sentence, of which nothing but a few words is changed.

        Args:
            state: of the grammar, after the words before the place.
            other: the first word of the detour, another than the sentence has.
            rest: the words of the sentence from the place on.

        Returns:
            Those that only leave out what is before that word in the sentence, then the shortest detours.
        """
        rest = tuple(rest)
        shorter = (rest[place:] for place in range(1, LEFT_OUT + 1) if rest[place : place + 1] == (other,))
        found = [end for end in shorter if leads(self._search.graph, state, end)]
        return [*found, *islice(self._detours(state, other, rest), MOST)]

    def _detours(self, state: Any, other: str, rest: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
        graph = self._search.graph
        for way, at in self._walks(state, other):
            for left_out in range(min(LEFT_OUT, len(rest)) + 1):
                if left_out and way[-1] == rest[left_out - 1]:
                    continue  # a shorter detour that comes back one word before says the same
                if left_out == 0 and len(way) == 1 and other in ARTICLES:
                    continue  # "two a box" is no other thing
                if leads(graph, at, rest[left_out:]):
                    yield (*way, *rest[left_out:])

    def _walks(self, state: Any, other: str) -> Iterator[tuple[tuple[str, ...], Any]]:
        """The words of detours and the states after them, the shortest first."""
        ways: list[tuple[tuple[str, ...], Any]] = []
        first = self._search.graph.step(state, other)
        if first is not None:
            ways = [((other,), first)]
        for count in range(1, WORDS + 1):
            yield from ways
            if count < WORDS:
                ways = [longer for way, at in ways for longer in self._longer(way, at)]

    def _longer(self, way: tuple[str, ...], state: Any) -> Iterator[tuple[tuple[str, ...], Any]]:
        words, _, _ = self._search.words_after(state)
        for word in words if len(words) <= BRANCHES else ():
            after = self._search.graph.step(state, word)
            if after is not None:
                yield (*way, word), after


def leads(graph: Any, state: Any, words: Sequence[str]) -> bool:
    """Whether words lead from a state of a grammar's automaton to the end of a sentence."""
    for word in words:
        state = graph.step(state, word)
        if state is None:
            return False
    return bool(graph.accepting(state))
