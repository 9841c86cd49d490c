"""What becomes of a goal is entered in it and told: its state, its end, and how far it has come."""

from __future__ import annotations

import logging
import math
from collections.abc import Callable
from dataclasses import replace

from intent_engine.execution.events import Dispatcher, EventKind
from intent_engine.execution.failsafe import Failsafe
from intent_engine.execution.goal import Feedback, Goal, GoalState, Reason, move_goal
from intent_engine.execution.raised import pass_on_interrupt
from intent_engine.execution.runs import Ending, Run
from intent_engine.values import is_number

__all__ = ["Progress"]

log = logging.getLogger(__name__)


class Progress:
    """Of all goals of an executor, under its lock; of those that are turned away, without it.

    Args:
        events: hear of everything.
        failsafe: knows where the robot is.
        ended: wakes those who wait for the end of a goal.
    """

    def __init__(self, events: Dispatcher, failsafe: Failsafe, ended: Callable[[], None]) -> None:
        self._events = events
        self._failsafe = failsafe
        self._ended = ended
        self._mute: Run | None = None
        """The last one of which it was said that it tells nothing."""

    def made(self, goal: Goal) -> None:
        """There is a goal."""
        self._events.tell(EventKind.GOAL, goal)

    def move(self, goal: Goal, state: GoalState, now: float, reason: Reason = Reason.NONE, detail: str = "") -> None:
        """A goal goes from one state to another."""
        move_goal(goal, state, now, reason, detail)
        self._events.tell(EventKind.GOAL, goal)

    def end(self, goal: Goal, ending: Ending, now: float, run: Run | None = None) -> None:
        """A goal ends; ``run`` carried it out."""
        if run is not None:
            try:
                goal.feedback = replace(self._feedback(run, now), time_left=0.0)
            except BaseException as error:
                log.exception("no last feedback of goal %d", goal.id)
                pass_on_interrupt(error)
        self.move(goal, ending.state, now, ending.reason, ending.detail)
        self._ended()

    def feedback(self, run: Run, now: float) -> None:
        """How far it has come."""
        try:
            feedback = self._feedback(run, now)
        except BaseException as error:
            if self._mute is not run:
                log.exception("no feedback of goal %d; this is said once", run.goal.id)
            self._mute = run
            pass_on_interrupt(error)
            return
        run.goal.feedback = feedback
        self._events.tell(EventKind.FEEDBACK, run.goal, feedback=feedback)

    def _feedback(self, run: Run, now: float) -> Feedback:
        feedback = run.feedback(now)
        return replace(feedback, progress=_share(feedback.progress), pose=self._failsafe.pose())


def _share(progress: object) -> float | None:
    """What a robot or a handler says of its progress: 0 to 1, or None, as for what is no number."""
    number = float(progress) if is_number(progress) else math.nan  # type: ignore[arg-type]
    return min(max(number, 0.0), 1.0) if math.isfinite(number) else None
