"""A motion is done faster, or slower, at once: just as far, within the limits of the robot."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from intent_engine.actions import Action, ChangeSpeed, Move, Turn
from intent_engine.execution.admission import Terms, forbidden
from intent_engine.execution.failsafe import reason_of
from intent_engine.execution.goal import Goal, GoalState, Guard, Reason
from intent_engine.execution.intake import Intake
from intent_engine.execution.limits import Limits
from intent_engine.execution.progress import Progress
from intent_engine.execution.raised import pass_on_interrupt, told
from intent_engine.execution.runs import Ending, MotionRun, Run

__all__ = ["SpeedChange", "SpeedChanger", "changed"]

_STANDS = "the robot does not move, so there is nothing to do at another speed; say it while it moves"
_BY_ITSELF = "how fast {} is done is not known here; only a drive or a turn can be done at another speed"
_ALONE = Ending(
    GoalState.REJECTED,
    Reason.NOTHING_MOVES,
    "what it is said with would be over when its turn comes; say it by itself, while the robot moves",
)
"""The end of a change of speed that is one of several commands."""
_COMING_TO_REST = Ending(GoalState.REJECTED, Reason.NOTHING_MOVES, "the robot is coming to rest at the end of its way")
"""The end of one that came too late."""


@dataclass(frozen=True, slots=True)
class SpeedChange:
    """A motion at its new speed."""

    action: Move | Turn
    speed: float
    """m/s or rad/s, signed."""
    told: str
    """The speed before and now, in words."""


def changed(running: Action | None, drives: bool, factor: float, limits: Limits) -> SpeedChange | Ending:
    """What is done now, at ``factor`` times its speed.

    A speed beyond the limit is cut down to it, whatever becomes of a command that asks for one: nobody has said a
    number. A motion that would take longer than the robot may move is left as it is, since it is to come just as far.

    Args:
        running: what is done now; None: nothing.
        drives: whether the velocity loop does it.
        factor: positive.
        limits: of the robot.

    Returns:
        The motion, or why it is left as it is.
    """
    if running is None:
        return Ending(GoalState.REJECTED, Reason.NOTHING_MOVES, _STANDS)
    if not (drives and isinstance(running, Move | Turn)):
        return Ending(GoalState.REJECTED, Reason.CAPABILITY, _BY_ITSELF.format(running.type))
    if isinstance(running, Move):
        present, amount, unit, bound = running.linear_velocity, running.distance, "m/s", limits.linear_velocity
    else:
        present, amount, unit, bound = running.angular_velocity, abs(running.angle), "rad/s", limits.angular_velocity
    speed = min(abs(present) * factor, bound)
    if factor > 1 and speed <= abs(present) * (1 + 1e-9):
        why = f"{abs(present):.4g} {unit} is the limit of this robot"
        return Ending(GoalState.REJECTED, Reason.LIMIT, f"it cannot go faster: {why}")
    if not math.isfinite(speed):  # of a robot without limits
        return Ending(GoalState.REJECTED, Reason.LIMIT, f"it cannot go faster: {factor:.4g} times as fast is no speed")
    duration = amount / speed if speed else math.inf
    if factor < 1 and not duration <= limits.duration * (1 + 1e-9):
        why = f"it would take {duration:.4g} s, and this robot's limit is {limits.duration:.4g} s"
        return Ending(GoalState.REJECTED, Reason.LIMIT, f"it cannot go slower: {why}")
    if not math.isfinite(duration):
        return Ending(GoalState.REJECTED, Reason.LIMIT, "it cannot go slower: it would never be there")
    signed = math.copysign(speed, present)
    action: Move | Turn
    if isinstance(running, Move):
        action = replace(running, linear_velocity=signed, duration=duration)
    else:
        action = replace(running, angular_velocity=signed, duration=duration)
    cut = ", the limit of this robot" if speed < abs(present) * factor else ""
    return SpeedChange(action, signed, f"from {abs(present):.4g} to {speed:.4g} {unit}{cut}")


class SpeedChanger:
    """Changes the speed of what is being done, under the executor's lock.

    Args:
        intake: says what is refused.
        progress: enters what becomes of the goals.
        limits: of the robot.
        run: what is carried out; None: nothing.
        failed: is told what the robot raised.
    """

    def __init__(
        self,
        intake: Intake,
        progress: Progress,
        limits: Limits,
        run: Callable[[], Run | None],
        failed: Callable[[Run | None, BaseException, float], None],
    ) -> None:
        self._intake = intake
        self._progress = progress
        self._limits = limits
        self._run = run
        self._failed = failed

    def change(self, goals: list[Goal], terms: list[Terms], now: float, since: object) -> None:
        """Do what is being done faster, or slower, at once: nothing makes way for it, and it never waits its turn.
        ``since``: the last stop when it was asked for."""
        if not all(isinstance(goal.action, ChangeSpeed) for goal in goals):
            alone = [_ALONE if isinstance(each.action, ChangeSpeed) else None for each in goals]
            refusals = [self._intake.refusal(each, now, since) or why for each, why in zip(goals, alone, strict=True)]
            self._intake.refuse(goals, refusals, now)
            return
        for goal, its in zip(goals, terms, strict=True):
            self._change_once(goal, its.guard, now, since)

    def _change_once(self, goal: Goal, guard: Guard | None, now: float, since: object) -> None:
        assert isinstance(goal.action, ChangeSpeed)
        refused = self._intake.refusal(goal, now, since)
        if refused is None and (forbids := forbidden(goal, guard)) is not None:
            refused = replace(forbids, state=GoalState.REJECTED)
        if goal.done:
            return  # whoever was asked has stopped the robot
        run = self._run()
        doing, drives = run.goal.action if run is not None else None, isinstance(run, MotionRun)
        change = refused or changed(doing, drives, goal.action.factor, self._limits)
        ending = self._at_speed(run, change, now) if isinstance(change, SpeedChange) else change
        if ending.state is not GoalState.REJECTED:
            for state in (GoalState.ACCEPTED, GoalState.EXECUTING):
                self._progress.move(goal, state, now)
        self._progress.end(goal, ending, now)

    def _at_speed(self, run: Run | None, change: SpeedChange, now: float) -> Ending:
        assert isinstance(run, MotionRun)
        try:
            if not run.change_speed(change.speed, now):
                return _COMING_TO_REST
        except BaseException as error:
            pass_on_interrupt(error)
            self._failed(run, error, now)
            return Ending(GoalState.ABORTED, reason_of(error), told(error))
        run.goal.action = change.action
        return Ending(GoalState.SUCCEEDED, detail=change.told)
