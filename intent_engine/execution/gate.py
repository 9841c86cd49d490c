"""The gate through which every velocity goes to the robot."""

from __future__ import annotations

import itertools

from intent_engine.execution.robots.robot import Robot

__all__ = ["Gate"]


class Gate:
    """Lets zeros through always, and other velocities only while it is open.

    ``shut`` takes no lock and may be called at any time, also from a signal handler: it changes a number. A write
    that was on its way into the robot while the gate was shut is followed by a stop, whoever made it.
    """

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        # next() of a counter is one step of the interpreter: no two threads get the same number.
        self._numbers = itertools.count(1)
        self._generation = 0
        self._opened = -1

    def shut(self) -> None:
        """No velocity but zero goes through from now on."""
        self._generation = next(self._numbers)

    def open(self) -> None:
        """Let velocities through. Called by the executor, under its lock, when it begins something new."""
        self._opened = self._generation

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        if not linear and not angular:
            self._robot.velocity(0.0, 0.0, valid_for)
            return
        if self._opened != self._generation:
            return
        self._robot.velocity(linear, angular, valid_for)
        if self._opened != self._generation:
            self._robot.stop()

    def stop(self) -> None:
        self._robot.stop()
