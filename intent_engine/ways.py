"""Which way actions go: what a robot must never take for its opposite."""

from __future__ import annotations

from collections.abc import Iterable

from intent_engine.actions import Action, Move, Turn

__all__ = ["opposite_ways", "ways"]


def ways(actions: Iterable[Action]) -> tuple[int, ...]:
    """Which way each action goes: 1 forward, 2 left, -1 and -2 the other way, 0 for what has none."""
    return tuple(map(_way, actions))


def opposite_ways(actions: Iterable[Action], others: Iterable[Action]) -> bool:
    """Whether actions drive and turn as others do, but one of them the other way."""
    going, theirs = ways(actions), ways(others)
    return going != theirs and tuple(map(abs, going)) == tuple(map(abs, theirs))


def _way(action: Action) -> int:
    if isinstance(action, Move):
        return 1 if action.linear_velocity > 0 else -1
    if isinstance(action, Turn):
        return 2 if action.angular_velocity > 0 else -2
    return 0
