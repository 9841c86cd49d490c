"""What an automaton walks through: sets of places that the same words lead to, and how each was come by."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, TypeAlias

from intent_engine.language.networks.network import State

__all__ = [
    "Entry", "Mark", "Member", "Passed", "Reached", "Stack", "Taken", "Trace", "Ways", "WordState", "traced"
]  # fmt: skip

Mark = tuple[Any, ...]
Trace = list[tuple[int, Mark]]
"""What a reading passed, in order: (number of words read before, mark)."""


class Stack:
    """The networks to return to, shared by all pairs that have the same way back."""

    __slots__ = ("apart", "call_mark", "calls", "parent", "target")

    def __init__(self, target: State | None, parent: Stack | None, call_mark: Any, apart: bool = False) -> None:
        self.target = target
        self.parent = parent
        self.call_mark = call_mark
        self.apart = apart
        self.calls: dict[tuple[int, bool], Stack] = {}


class Ways:
    """The members of a set that may be gone on from, by what they read, each with its stack and place in the set. A set
    has dozens of members and is asked about many words, of which each is read by a few."""

    __slots__ = ("arcs", "number", "numeral", "special", "wild")

    def __init__(self, members: Iterable[Member]) -> None:
        self.arcs: list[tuple[Mapping[str, tuple[State, ...]], Stack, int]] = []
        self.numeral: list[tuple[State, Stack, int]] = []
        self.number: list[tuple[State, Stack, int]] = []
        self.wild: list[tuple[State, Stack, int]] = []
        special: set[str] = set()
        for index, (place, stack) in enumerate(members):
            if place.arcs:
                self.arcs.append((place.arcs, stack, index))
            if place.numeral:
                self.numeral.append((place, stack, index))
            if place.number:
                self.number.append((place, stack, index))
            if place.begun or place.wild:
                self.wild.append((place, stack, index))
                special.update(place.allowed, place.begins, place.articles)
        self.special = special
        """Words of which free slots say something."""

    def reading(self, word: str) -> list[Entry]:
        """Where those members lead that have an arc for a word."""
        return [(target, stack, index, ()) for arcs, stack, index in self.arcs if word in arcs for target in arcs[word]]

    def names(self, word: str) -> bool:
        """Whether any member says something of this very word."""
        named = word in self.special or any(word in arcs for arcs, _, _ in self.arcs)
        return named or any(word in place.refused for place, _, _ in self.wild)


class WordState:
    """A set of pairs that the same words lead to. Opaque to callers; hashable by identity."""

    __slots__ = ("_ways", "accepts", "came_from", "members", "numerals", "steps", "wild")

    def __init__(self, members: tuple[Member, ...], accepts: tuple[int, ...]) -> None:
        self.members = members
        self.accepts = accepts
        """Places in ``members`` that end a sentence, most wanted first."""
        self.steps: dict[str, Taken | None] = {}
        self.came_from: tuple[Passed, ...] = ()
        """For a start state: what each member passed before the first word."""
        self.numerals = any(state.numeral for state, _ in members)
        self.wild = any(state.wild for state, _ in members)
        self._ways: Ways | None = None

    @property
    def ways(self) -> Ways:
        """The members by what they read; of most sets nobody asks."""
        if self._ways is None:
            self._ways = Ways(self.members)
        return self._ways


Member: TypeAlias = tuple[State, Stack]
Reached: TypeAlias = tuple[Member, tuple[Mark, ...]]
"""A member of a set with what is passed on the way to it."""
Passed: TypeAlias = tuple[int, tuple[Mark, ...]]
"""Of a member of a set: which member of the set before it came from, and what was passed on the way."""
Taken: TypeAlias = tuple[WordState, tuple[Passed, ...]]
"""A step: the set it leads to, and how each of its members was come by."""
Entry: TypeAlias = tuple[State, Stack, int, tuple[Mark, ...]]
"""A place that a word leads to: with its stack, the member it comes from, and what was passed."""


def traced(backwards: Iterable[tuple[int, tuple[Passed, ...]]], at: int) -> Trace:
    """What was passed on the way to a member of a set.

    Args:
        backwards: words read, and how each member of the set after them was come by, from the last set on.
        at: the place of the member in the last set.
    """
    trace: Trace = []
    for count, passed in backwards:
        at, marks = passed[at]
        if marks:
            trace.extend([(count, mark) for mark in marks[::-1]])
    trace.reverse()
    return trace
