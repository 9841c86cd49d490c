"""A robot that remembers every velocity, on a clock that nobody waits for."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.executor import Executor
from intent_engine.execution.limits import Limits
from intent_engine.execution.robots.robot import Pose
from intent_engine.execution.robots.simulated import SimulatedRobot

MAP = {"kitchen": Pose(5.0, 2.0, 0.0), "dock": Pose(10.0, 0.0, -1.57)}


@dataclass(frozen=True)
class Write:
    time: float
    linear: float
    angular: float
    by_stop: bool = False
    """The robot's own stop, which may be sudden."""


class RecordingRobot(SimulatedRobot):
    """The simulated robot, with a list of what was written to it; ``stop`` counts as a zero."""

    def __init__(self, *args, **kwargs) -> None:
        super().__init__(*args, **kwargs)
        self.written: list[Write] = []

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        self.written.append(Write(self.clock.now(), linear, angular))
        super().velocity(linear, angular, valid_for)

    def stop(self) -> None:
        self.written.append(Write(self.clock.now(), 0.0, 0.0, by_stop=True))
        super().stop()


class FailingRobot(RecordingRobot):
    """Raises in the velocity write it is told to fail at, when it navigates, or in a stop (after having stopped)."""

    fail_in: int | None = None
    fails_to: str | None = None

    def navigate(self, goal):
        self._fail("navigate")
        return super().navigate(goal)

    def stop(self) -> None:
        super().stop()
        self._fail("stop")

    def _fail(self, what: str) -> None:
        if self.fails_to == what:
            self.fails_to = None
            raise OSError("the bus is off")

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        if self.fail_in is not None and (linear or angular):
            self.fail_in -= 1
            if self.fail_in < 0:
                self.fail_in = None
                raise OSError("the motor driver is gone")
        super().velocity(linear, angular, valid_for)


class Stage:
    """A virtual clock, a recording robot and an executor, wired."""

    def __init__(self, limits: Limits | None = None, **options) -> None:
        self.clock = VirtualClock()
        robot_options = {name: options.pop(name) for name in ("objects", "slip", "delay", "seed") if name in options}
        self.robot = RecordingRobot(self.clock, locations=MAP, **robot_options)
        self.events: list = []
        self.executor = Executor(self.robot, limits, on_event=self.events.append, handle_sigterm=False, **options)


def until(condition: Callable[[], bool]) -> None:
    """Wait for something that must happen; the limit is only there to end a broken test."""
    end = time.monotonic() + 30.0
    while not condition():
        assert time.monotonic() < end, "it never happened"
        time.sleep(0.002)
