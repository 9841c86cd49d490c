"""What may still be said after some words: nothing, only how it is to be done, or what is to be done.

"Go forward" may go on to "two meters", and whoever acts on it at once drives too far. "Go forward two meters" may go
on to "slowly", which changes the manner and not the way. The automaton knows which; an endpoint waits accordingly.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from enum import IntEnum

from intent_engine.language.grammar import QUANTITY_KINDS
from intent_engine.language.networks.network import Edge, Networks, State

__all__ = ["MANNER", "Continuation", "Continuations"]

MOST_ENDINGS, MOST_STEPS = 8, 256
"""Ends of sentences that are looked at, and places on the way to them."""
MANNER = frozenset({"speed", "angular_speed"})
"""Types of slots that say how something is done."""


class Continuation(IntEnum):
    """What a way to go on would add, at most. The order is that of their weight."""

    NOTHING = 0
    """The sentence is over."""
    WORDS = 1
    """Words that fill no slot, which may make another sentence of it: "turn" + "around"."""
    MORE = 2
    """More of a quantity that is whole already: "two meters" + "and a half"."""
    MANNER = 3
    """How: a speed."""
    CONTENT = 4
    """What: a distance, a name, an object."""


class Continuations:
    """Looks ahead in the networks of one grammar. Thread-safe.

    Args:
        networks: of the grammar.
        kinds: type of each slot by its name.
    """

    def __init__(self, networks: Networks, kinds: Mapping[str, str]) -> None:
        self._networks = networks
        self._kinds = kinds
        self._tails: dict[State, frozenset[Continuation]] = {}
        self._lock = networks.lock

    def ahead(self, ways: Iterable[tuple[State, Iterable[tuple[State, object, bool]]]]) -> frozenset[Continuation]:
        """What may be said after some words.

        Args:
            ways: where they have led to, from :meth:`Automaton.ways_on`.
        """
        with self._lock:
            return frozenset(one for place, calls in ways for one in self._after(place, calls))

    def endings(
        self, ways: Iterable[tuple[State, Sequence[tuple[State, object, bool]]]]
    ) -> frozenset[tuple[str, ...]] | None:
        """The words that a sentence may still end with, where they fill no slot: "section" after "show me the history",
        of which the sentence is over without it.

        Args:
            ways: where some words have led to, from :meth:`Automaton.ways_on`.

        Returns:
            Those of all ways; None: there are too many.
        """
        found: set[tuple[str, ...]] = set()
        with self._lock:
            # Places to go on from, with those that their networks return to, and the words on the way.
            waiting: list[tuple[State, tuple[tuple[State, bool], ...], tuple[str, ...]]] = [
                (place, tuple((returns, self._is_slot(mark)) for returns, mark, _ in calls), ())
                for place, calls in ways
            ]
            for _ in range(MOST_STEPS):
                if not waiting:
                    break
                place, calls, said = waiting.pop()
                if place.final and calls:
                    waiting.append((calls[0][0], calls[1:], said))
                elif place.final:
                    found.add(said)
                waiting += [(edge.target, calls, said) for edge in place.edges if edge.call is None]
                if any(slot for _, slot in calls):  # more words of it are another value
                    continue
                waiting += [(target, calls, (*said, word)) for word, after in place.arcs.items() for target in after]
                waiting += [
                    (self._networks[edge.call.network].start, ((edge.target, False), *calls), said)
                    for edge in place.edges
                    if edge.call is not None and not (edge.call.apart or self._is_slot(edge.call.mark))
                ]
        if waiting or len(found) > MOST_ENDINGS:
            return None
        return frozenset(found - {()})

    def _is_slot(self, mark: object) -> bool:
        return isinstance(mark, tuple) and mark[0] == "slot"

    def _after(self, place: State, calls: Iterable[tuple[State, object, bool]]) -> frozenset[Continuation]:
        """What the ways on from a place would add, through the networks that it was entered through."""
        found = self._tail(place)
        within: set[Continuation] = set()
        for returns, mark, fresh in calls:
            if isinstance(mark, tuple) and mark[0] == "slot":
                if fresh:
                    found = frozenset({self._kind(mark)})
                elif self._is_quantity(mark):
                    # Nobody rests in the middle of a quantity, so what would come after its other end is far off.
                    within |= {Continuation.MORE for one in found if one}
                    found = frozenset(one for one in found if not one)
                else:
                    found = frozenset(Continuation.CONTENT if one else one for one in found)
            found = _joined(found, self._tail(returns))
        return found | within

    def _is_quantity(self, mark: tuple[object, ...]) -> bool:
        return self._kinds.get(str(mark[2])) in QUANTITY_KINDS

    def _kind(self, mark: tuple[object, ...]) -> Continuation:
        return Continuation.MANNER if self._kinds.get(str(mark[2])) in MANNER else Continuation.CONTENT

    def _tail(self, place: State) -> frozenset[Continuation]:
        """What the ways from a place to the end of its network add."""
        known = self._tails.get(place)
        if known is not None:
            return known
        self._tails[place] = frozenset()  # a way that comes back to itself adds nothing new
        found: set[Continuation] = set()
        if place.final:
            found.add(Continuation.NOTHING)
        if place.expand is not None:  # a list of names that nobody has gone into yet
            found.add(Continuation.CONTENT)
        for targets in (*place.arcs.values(), place.numeral, place.number, place.wild, place.begun, place.led or ()):
            for target in targets:
                found |= _joined({Continuation.WORDS}, self._tail(target))
        for edge in place.edges:
            if edge.call is None or not edge.call.apart:
                found |= _joined(self._called(edge), self._tail(edge.target))
        self._tails[place] = frozenset(found)
        return self._tails[place]

    def _called(self, edge: Edge) -> Iterable[Continuation]:
        call = edge.call
        if call is None:
            return {Continuation.NOTHING}
        if isinstance(call.mark, tuple) and call.mark[0] == "slot":
            return {self._kind(call.mark)}
        return self._tail(self._networks[call.network].start)


def _joined(first: Iterable[Continuation], then: Iterable[Continuation]) -> frozenset[Continuation]:
    """What ways add that go the first way and then the second: the weightier of both."""
    after = tuple(then)
    return frozenset(max(one, other) for one in first for other in after)
