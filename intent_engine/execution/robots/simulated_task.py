"""What a simulated robot does by itself: a navigation, a pick or a place, each with the time of its end."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Protocol

from intent_engine.execution.clock import Clock
from intent_engine.execution.robots.kinematics import arc
from intent_engine.execution.robots.robot import Pose, Task, TaskState

__all__ = ["Leg", "SimulatedTask", "route"]


@dataclass(frozen=True, slots=True)
class Leg:
    """One part of a navigation: a turn on the spot or a straight line."""

    start: float
    end: float
    begin: Pose
    linear: float
    angular: float

    def pose(self, time: float) -> Pose:
        t = min(max(time, self.start), self.end) - self.start
        return arc(self.begin, self.linear, self.angular, t)


class _Doer(Protocol):
    """The robot that does a task: brings it up to date before its state is told."""

    @property
    def clock(self) -> Clock: ...

    def update(self) -> None: ...


class SimulatedTask:
    """A task that ends at a known time, if nothing ends it before."""

    def __init__(self, robot: _Doer, kind: str, start: float, end: float) -> None:
        self.kind = kind
        self.start = start
        self.end = end
        self.finish: Callable[[], str] = lambda: ""
        """Does what the task does at its end; returns why it failed, or nothing."""
        self.legs: tuple[Leg, ...] = ()
        self._robot = robot
        self._state = TaskState.RUNNING
        self._reason = ""
        self._callbacks: list[Callable[[Task], None]] = []
        self._lock = threading.Lock()

    @property
    def state(self) -> TaskState:
        self._robot.update()
        return self._state

    @property
    def reason(self) -> str:
        return self._reason

    @property
    def progress(self) -> float | None:
        if self._state is not TaskState.RUNNING:
            return 1.0 if self._state is TaskState.SUCCEEDED else None
        if self.end <= self.start:
            return 1.0
        return min(max((self._robot.clock.now() - self.start) / (self.end - self.start), 0.0), 1.0)

    def add_done_callback(self, callback: Callable[[Task], None]) -> None:
        with self._lock:
            if self._state is TaskState.RUNNING:
                self._callbacks.append(callback)
                return
        callback(self)

    def end_as(self, state: TaskState, reason: str = "") -> list[Callable[[Task], None]]:
        """Leave RUNNING; returns who wants to know."""
        with self._lock:
            self._state, self._reason = state, reason
            callbacks, self._callbacks = self._callbacks, []
        return callbacks


def route(pose: Pose, goal: Pose, time: float, speed: float, turn: float) -> Iterator[Leg]:
    """Turn to the goal, drive straight, turn to its heading.

    Args:
        pose: where it begins.
        goal: where it ends.
        time: s on the robot's clock, when it begins.
        speed, turn: m/s and rad/s.
    """
    dx, dy = goal.x - pose.x, goal.y - pose.y
    distance = math.hypot(dx, dy)
    headings = [(math.atan2(dy, dx), distance)] if distance > 1e-9 else []
    for heading, length in [*headings, (goal.yaw, 0.0)]:
        angle = math.remainder(heading - pose.yaw, math.tau)
        if abs(angle) > 1e-12:
            rate = math.copysign(turn, angle)
            yield Leg(time, time + abs(angle) / turn, pose, 0.0, rate)
            time += abs(angle) / turn
            pose = Pose(pose.x, pose.y, heading, pose.frame)
        if length:
            duration = length / speed
            yield Leg(time, time + duration, pose, speed, 0.0)
            time += duration
            pose = Pose(goal.x, goal.y, heading, pose.frame)
