"""The goals that wait their turn, in order."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass

from intent_engine.execution.admission import Terms
from intent_engine.execution.goal import Goal, GoalState, Reason
from intent_engine.execution.motion import Travel
from intent_engine.execution.progress import Progress
from intent_engine.execution.runs import Ending

__all__ = ["GoalQueue", "Queued"]


@dataclass(frozen=True, slots=True, eq=False)
class Queued:
    """A goal that waits its turn."""

    goal: Goal
    terms: Terms
    covered: Travel | None
    """How far the goal that it amends has come; None: it amends none."""
    since: object
    """The last stop when it was asked for."""


class GoalQueue:
    """Under the executor's lock; ``progress`` enters the end of those that never begin."""

    def __init__(self, progress: Progress) -> None:
        self._progress = progress
        self._waiting: deque[Queued] = deque()

    def __len__(self) -> int:
        return len(self._waiting)

    def __iter__(self) -> Iterator[Goal]:
        return (each.goal for each in self._waiting)

    @property
    def first(self) -> Queued:
        return self._waiting[0]

    @property
    def last(self) -> Goal | None:
        return self._waiting[-1].goal if self._waiting else None

    def add(self, waiting: Queued) -> None:
        self._waiting.append(waiting)

    def pop(self) -> None:
        """The first one's turn has come."""
        self._waiting.popleft()

    def remove(self, goal: Goal) -> bool:
        """Whether it waited."""
        waiting = next((each for each in self._waiting if each.goal is goal), None)
        if waiting is not None:
            self._waiting.remove(waiting)
        return waiting is not None

    def clear(self, reason: Reason, now: float) -> None:
        """None of them begins any more."""
        while self._waiting:
            self._progress.end(self._waiting.popleft().goal, Ending(GoalState.CANCELED, reason), now)

    def end_after(self, goal: Goal, reason: Reason, now: float) -> None:
        """What was said in one breath with a goal, and after it, does not begin any more."""
        # Goals are numbered in the order in which they wait.
        said = [each for each in self._waiting if each.goal.utterance == goal.utterance]
        for later in [each for each in said if each.goal.id > goal.id]:
            self._waiting.remove(later)
            self._progress.end(later.goal, Ending(GoalState.CANCELED, reason), now)
