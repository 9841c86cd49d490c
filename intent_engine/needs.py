"""What an intent asks of the states of the robot, and whether it is so: when words are understood, and once more when
what waited its turn begins."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass

__all__ = ["MOVING", "Needs", "states_of"]

MOVING = "moving"
"""The robot state in which any utterance that begins with a stop word stops it."""


_USUAL = frozenset({tuple, list, set, frozenset})
"""Types of which a quick look tells that they hold states."""


def states_of(given: object) -> Collection[str]:
    """The states that a program says a robot is in. A text is the one state of that name: each of its letters would be
    one, and what "docked" forbids would be done.

    Raises:
        TypeError: they are none.
    """
    if type(given) in _USUAL:
        return given  # type: ignore[return-value]
    if isinstance(given, str):
        return (given,)
    if isinstance(given, Mapping) or not isinstance(given, Collection):
        raise TypeError(f"states are names in a list or a set, as ['moving'], not {given!r:.80}")
    return given


@dataclass(frozen=True, slots=True)
class Needs:
    """``requires`` and ``excludes`` of an intent."""

    intent: str
    requires: frozenset[str] = frozenset()
    excludes: frozenset[str] = frozenset()

    def unmet(self, state: Collection[str]) -> str:
        """Why it cannot be done by a robot in these states; empty: it can."""
        if self.requires and (missing := self.requires.difference(state)):
            return f"{self.intent} needs the robot to be {' and '.join(sorted(missing))}"
        if self.excludes and (present := self.excludes.intersection(state)):
            return f"{self.intent} cannot be done while the robot is {' and '.join(sorted(present))}"
        return ""

    def joined(self, other: Needs) -> Needs:
        """What both ask, in the name of this one."""
        return Needs(self.intent, self.requires | other.requires, self.excludes | other.excludes)

    def guard(self, state: Callable[[], Collection[str]]) -> Callable[[], str] | None:
        """What tells, whenever it is called, why it cannot be done now; None: there is nothing to ask.

        "Moving" is what the robot was when the words were understood. What waits its turn waits for the end of just
        that, so it is not asked again.
        """
        rest = Needs(self.intent, self.requires - {MOVING}, self.excludes - {MOVING})
        return (lambda: rest.unmet(states_of(state()))) if rest.requires or rest.excludes else None
