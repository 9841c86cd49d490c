"""The ways in which a goal is carried out: a motion, a task of the robot, a stop. (A handler: handlers.py.)

A run is begun, stepped and ended by the executor, under its lock. It never decides what comes next.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Protocol

from intent_engine.errors import RobotError
from intent_engine.execution.goal import Feedback, Goal, GoalState, Reason
from intent_engine.execution.motion import Ended, Keep, Motion, Travel
from intent_engine.execution.robots.robot import Robot, Task, TaskState
from intent_engine.values import named

__all__ = [
    "Ending",
    "MotionRun",
    "Run",
    "StopRun",
    "TaskRun",
    "VelocityLoop",
]


@dataclass(frozen=True, slots=True)
class Ending:
    """How a run came to its end."""

    state: GoalState
    reason: Reason = Reason.NONE
    detail: str = ""


class VelocityLoop(Protocol):
    """What writes velocities: a :class:`~.motion.Follower` here, or a process of its own."""

    @property
    def moving(self) -> bool: ...
    @property
    def written(self) -> tuple[float, float]: ...
    def start(self, motion: Motion, now: float) -> float: ...
    def brake(self, now: float) -> Travel: ...
    def halt(self, now: float, write: bool = True) -> Travel: ...
    def silence(self) -> None: ...
    def travel(self, now: float) -> Travel: ...
    def due(self) -> float | None: ...
    def step(self, now: float) -> Ended | None: ...


class Run(Protocol):
    """One goal being carried out."""

    goal: Goal
    needs_rest: bool
    """Whether the wheels must stand still before it begins."""

    def begin(self, now: float) -> None: ...
    def step(self, now: float) -> Ending | None: ...
    def due(self, now: float) -> float | None: ...
    def suspend(self, now: float, at_once: bool) -> None:
        """Rest, ready to go on; ``at_once``: the robot has been stopped already."""
        ...

    def resume(self, now: float) -> None: ...
    def give_up(self, now: float) -> bool:
        """Make way for another goal. True: it has; False: it takes a while, and ``step`` says when."""
        ...

    def feedback(self, now: float) -> Feedback: ...


class MotionRun:
    """A move or turn on the velocity loop."""

    needs_rest = False
    AWAY = 2.0
    """s without a look at the motion, after which it is not gone on with: the program was stopped by its terminal or a
    debugger, or its clock has jumped, and nobody expects the robot to move when it wakes."""

    def __init__(self, goal: Goal, motion: Motion | None, loop: VelocityLoop, before: Travel | None = None) -> None:
        """``before``: what the goal that this one amends has covered of it."""
        self.goal = goal
        self._before = before or Travel()
        """What was covered before the last pause."""
        self._motion = motion.rest(self._before) if motion is not None and before is not None else motion
        self._whole = motion
        self._loop = loop
        self._pausing = self._left = False
        self._deadline = self._looked_at = 0.0

    def begin(self, now: float) -> None:
        self._looked_at = now
        if self._motion is not None:
            planned = self._loop.start(self._motion, now)
            self._deadline = planned + max(1.0, 0.1 * (planned - now))
        elif self._loop.moving:
            self._loop.brake(now)  # the goal that this one amends has come as far already

    def step(self, now: float) -> Ending | None:
        if self._motion is None:
            return Ending(GoalState.SUCCEEDED)
        away, self._looked_at = now - self._looked_at, now
        under_way = self._loop.moving and not self._pausing
        if under_way and away > self.AWAY:  # before anything more is written
            why = f"nobody looked after the motion for {away:.1f} s, and so it is not gone on with"
            return self._break_off(Reason.WATCHDOG, why, now)
        ended = self._loop.step(now)
        if ended is not None:
            if not self._pausing:
                self._before = _sum(self._before, ended.travel)
                self._motion = None
                return Ending(GoalState.SUCCEEDED)
            self._pausing = False
            self._stand(ended.travel)
            return Ending(GoalState.SUCCEEDED) if self._motion is None else None
        if under_way and now > self._deadline:
            return self._break_off(Reason.TIMEOUT, "the motion did not end when it should have", now)
        return None

    def due(self, now: float) -> float | None:
        return None if self._motion is not None else now

    def suspend(self, now: float, at_once: bool) -> None:
        if self._motion is None:
            return
        if at_once:
            self._pausing = False
            self._stand(self._loop.halt(now, write=False))
        elif self._loop.moving and not self._pausing:
            travel = self._loop.brake(now)
            if travel.braking:
                return
            self._before = _sum(self._before, travel)
            self._motion = self._whole.rest(self._before) if self._whole is not None else None
            self._pausing = True

    def resume(self, now: float) -> None:
        if self._pausing:
            # Resumed while still braking: what the brake covered is counted, and the rest begins at that speed.
            self._pausing = False
            self._stand(self._loop.travel(now))
        self.begin(now)

    def change_speed(self, speed: float, now: float) -> bool:
        """Cover what is left at another speed (signed), from the present one or, at rest, as soon as it goes on.

        Just as far is meant, so a motion that keeps its duration keeps its distance from now on.

        Returns:
            False if nothing is left but the last ramp; then nothing changes.
        """
        if self._whole is None or self._motion is None:
            return False
        under_way = self._loop.moving and not self._pausing
        travel = self._loop.travel(now) if under_way else Travel()
        whole = replace(self._whole, speed=speed, keep=Keep.DISTANCE)
        before = _sum(self._before, travel)
        rest = whole.rest(before)
        if travel.braking or rest is None:
            return False
        self._whole, self._before, self._motion = whole, before, rest
        if under_way:
            self.begin(now)
        return True

    def give_up(self, now: float) -> bool:
        return True

    def leave(self, travel: Travel) -> None:
        """The wheels are no longer this goal's; ``travel`` is the last that it covered."""
        if not self._left:
            self._left, self._before = True, _sum(self._before, travel)

    def feedback(self, now: float) -> Feedback:
        whole = self._whole
        if whole is None:
            return Feedback(1.0, 0.0, 0.0)
        travel = self.covered(now)
        if self._motion is None:
            return Feedback(1.0, 0.0, travel.amount)
        share = abs(travel.amount) / whole.amount
        return Feedback(min(share, 1.0), travel.time_left if self._loop.moving else None, travel.amount)

    def covered(self, now: float) -> Travel:
        """How far the goal has come, pauses and the goal that it amends included."""
        here = self._loop.travel(now) if self._loop.moving and not self._left else Travel()
        return _sum(self._before, here)

    def _break_off(self, reason: Reason, why: str, now: float) -> Ending:
        """Zero, and the end of the goal: whoever ends it otherwise leaves the loop driving."""
        self.leave(self._loop.halt(now))
        return Ending(GoalState.ABORTED, reason, why)

    def _stand(self, travel: Travel) -> None:
        self._before = _sum(self._before, travel)
        self._motion = self._whole.rest(self._before) if self._whole is not None else None


class TaskRun:
    """A navigation, pick or place, which the robot does by itself."""

    needs_rest = True
    CANCEL_TIMEOUT = 2.0
    """s to wait for a robot that does not confirm a cancellation, before going on."""
    POLL = 0.05
    """s between looks at the task, for robots whose callback comes late or never."""

    def __init__(
        self, goal: Goal, robot: Robot, begin: Callable[[], Task], poke: Callable[[Task], None], timeout: float
    ) -> None:
        self.goal = goal
        self._robot = robot
        self._begin = begin
        self._poke = poke
        self._timeout = timeout
        self._task: Task | None = None
        self._deadline = 0.0
        self._giving_up = False
        self._suspended = False
        self._timed_out = False
        self._look_at = 0.0

    def begin(self, now: float) -> None:
        self._deadline = now + self._timeout
        self._look_at = now + self.POLL
        task = self._begin()
        if not (hasattr(task, "state") and hasattr(task, "add_done_callback")):
            raise RobotError(
                f"{self.goal.action.type}() of a robot returns a Task, by which it is followed, not {task!r:.80}"
            )
        self._task = task
        self._task.add_done_callback(self._poke)

    def step(self, now: float) -> Ending | None:
        task = self._task
        if task is None or self._suspended:
            return None
        self._look_at = now + self.POLL
        state = named(TaskState, "the state of a task", task.state)
        if state is TaskState.RUNNING:
            if now < self._deadline:
                return None
            if not (self._giving_up or self._timed_out):
                self._timed_out = True
                self._deadline = now + self.CANCEL_TIMEOUT
                self._robot.cancel(task)
                return None
            # It does not confirm: stop the robot itself, whatever that ends.
            self._robot.stop()
        if self._timed_out:
            return Ending(GoalState.ABORTED, Reason.TIMEOUT, f"not done within {self._timeout:g} s")
        if self._giving_up:
            return Ending(GoalState.CANCELED)
        if state is TaskState.SUCCEEDED:
            return Ending(GoalState.SUCCEEDED, detail=task.reason)
        if state is TaskState.CANCELED:
            return Ending(GoalState.CANCELED, Reason.CANCELED, task.reason or "the robot cancelled it")
        return Ending(GoalState.ABORTED, Reason.ROBOT_ERROR, task.reason or "the robot did not say why")

    def due(self, now: float) -> float | None:
        return None if self._task is None or self._suspended else min(self._deadline, self._look_at)

    def suspend(self, now: float, at_once: bool) -> None:
        task = self._task
        ends = self._giving_up or self._timed_out
        if task is None or ends or task.state == TaskState.SUCCEEDED:
            return  # it is done, or is to end, and must not be given again
        self._suspended = True
        if not at_once:
            self._robot.cancel(task)
        self._task = None

    def resume(self, now: float) -> None:
        # Robots cannot hold a task: it is given again. Navigation goes on from where the robot stands.
        if self._suspended:
            self._suspended = False
            self.begin(now)

    def give_up(self, now: float) -> bool:
        if self._task is None:
            return True
        self._giving_up = True
        self._deadline = now + self.CANCEL_TIMEOUT
        self._robot.cancel(self._task)
        return self._task.state is not TaskState.RUNNING

    def feedback(self, now: float) -> Feedback:
        return Feedback(self._task.progress if self._task is not None else None, None)


class StopRun:
    """A stop inside a spoken sequence ("go forward, stop, turn left"); one that comes first is done by ``submit``."""

    needs_rest = False

    def __init__(self, goal: Goal, stop: Callable[[float], None]) -> None:
        self.goal = goal
        self._stop = stop

    def begin(self, now: float) -> None:
        self._stop(now)

    def step(self, now: float) -> Ending | None:
        return Ending(GoalState.SUCCEEDED)

    def due(self, now: float) -> float | None:
        return now

    def suspend(self, now: float, at_once: bool) -> None:
        pass

    def resume(self, now: float) -> None:
        pass

    def give_up(self, now: float) -> bool:
        return True

    def feedback(self, now: float) -> Feedback:
        return Feedback(None, None)


def _sum(first: Travel, second: Travel) -> Travel:
    return Travel(first.amount + second.amount, first.elapsed + second.elapsed, second.time_left)
