"""The goals of one utterance are taken, or refused, together: half of what was said is never done."""

from __future__ import annotations

from intent_engine.actions import Stop
from intent_engine.execution.admission import Admission
from intent_engine.execution.failsafe import HANGS, Failsafe
from intent_engine.execution.goal import Goal, GoalState, Reason
from intent_engine.execution.policy import Policy
from intent_engine.execution.progress import Progress
from intent_engine.execution.runs import Ending
from intent_engine.execution.stops import Stops

__all__ = ["Intake"]


class Intake:
    """Says why goals are refused, under the executor's lock where it does not say otherwise.

    Args:
        admission: knows what the robot can and may do.
        failsafe: knows whether velocities can be written.
        stops: knows what was asked for before a stop.
        progress: enters the end of those that are refused.
        queue_limit: how many goals may wait.
    """

    def __init__(
        self, admission: Admission, failsafe: Failsafe, stops: Stops, progress: Progress, queue_limit: int
    ) -> None:
        self._admission = admission
        self._failsafe = failsafe
        self._stops = stops
        self._progress = progress
        self._queue_limit = queue_limit
        self.estopped = self.closed = False
        """Set from any thread, before the stop that goes with it."""

    def announced(self, goals: list[Goal], now: float) -> list[Goal]:
        """Tell of new goals. A stop that comes first has been done already, whatever may be wrong with the rest.

        Returns:
            Those that are still to be taken.
        """
        for goal in goals:
            self._progress.made(goal)
        first = goals[0]
        if not isinstance(first.action, Stop):
            return goals
        for state in (GoalState.ACCEPTED, GoalState.EXECUTING):
            self._progress.move(first, state, now)
        self._progress.end(first, Ending(GoalState.SUCCEEDED), now)
        return goals[1:]

    def turn_away(self, goals: list[Goal], now: float) -> None:
        """Reject goals without the lock, which a robot has that hangs in a call."""
        for goal in self.announced(goals, now):
            self._progress.end(goal, Ending(GoalState.REJECTED, Reason.ROBOT_ERROR, HANGS), now)

    def refusal(self, goal: Goal, now: float, since: object) -> Ending | None:
        """Why it is not done; ``since``: the last stop when it was asked for."""
        if self.closed:
            return Ending(GoalState.REJECTED, Reason.CLOSED, "the executor is closed")
        if self.estopped:
            return Ending(GoalState.REJECTED, Reason.ESTOP, "emergency stop; reset() lets the robot move again")
        if self._stops.came_after(since):
            return Ending(GoalState.REJECTED, Reason.STOP, "a stop came after it was asked for")
        if self._stops.came_after_words(goal.times.spoken):
            return Ending(GoalState.REJECTED, Reason.STOP, "it was said before the last stop; say it again")
        if (lost := self._stops.leases.refusal(goal)) is not None:
            return lost
        if self._failsafe.fault and self._admission.drives(goal.action):
            return Ending(GoalState.REJECTED, Reason.VELOCITY_LOOP, f"{self._failsafe.fault}; reset() starts it again")
        return self._admission.expired(goal, now) or self._admission.impossible(goal)

    def no_room(self, count: int, waiting: int, idle: bool, policy: Policy) -> Ending | None:
        """Why so many more goals are not taken, where ``waiting`` wait already."""
        if policy is Policy.REFUSE and not idle:
            return Ending(GoalState.REJECTED, Reason.BUSY, "something else is being done")
        if count + (waiting if policy in (Policy.QUEUE, Policy.FOLLOW) else 0) > self._queue_limit:
            return Ending(GoalState.REJECTED, Reason.BUSY, f"more than {self._queue_limit} goals would wait")
        return None

    def refuse(self, goals: list[Goal], refusals: list[Ending | None], now: float) -> bool:
        """Reject them all, if there is a refusal of one; whether there was."""
        refused = next((ending for ending in refusals if ending is not None), None)
        if refused is not None:
            whole = f"another step of the same command was refused: {refused.detail or refused.reason.value}"
            for goal, ending in zip(goals, refusals, strict=True):
                self._progress.end(goal, ending or Ending(GoalState.REJECTED, Reason.EARLIER_FAILED, whole), now)
        return refused is not None
