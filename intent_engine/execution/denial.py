"""Whether an action that shall not be done is the one that is."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from intent_engine.actions import Action, to_json
from intent_engine.execution.goal import Goal

__all__ = ["denies", "does"]


def does(goals: Iterable[Goal], denied: Iterable[Action]) -> bool:
    """Whether one of the goals is one of what shall not be done, was when it was asked for, or is a part of one: what
    the handler of "clean" submits."""
    done = [action for goal in goals for action in (goal.action, goal.asked, *goal.part_of)]
    return any(denies(one, action) for one in denied for action in done)


def denies(denied: Action, done: Action) -> bool:
    """Whether what is done is what was denied, in all that was said of it: "don't put the cup down" is any place, and
    "don't clean" any room."""
    return _within(to_json(denied), to_json(done))


def _within(denied: Mapping[str, Any], done: Mapping[str, Any]) -> bool:
    for name, value in denied.items():
        if isinstance(value, Mapping):  # the slots of an action of the user's own
            if not _within(value, done.get(name, {})):
                return False
        elif value is not None and done.get(name) != value:
            return False
    return True
