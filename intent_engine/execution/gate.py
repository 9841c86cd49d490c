"""The gate through which every velocity goes to the robot."""

from __future__ import annotations

import itertools

from intent_engine.execution.robots.robot import Robot

__all__ = ["Gate"]


class Gate:
    """Lets zeros through always, and other velocities only while it is open.

    ``shut`` takes no lock and may be called at any time, also from a signal handler: it changes a number. A write
    that was on its way into the robot while the gate was shut is followed by a stop, whoever made it.

    A stop may have to wait for the executor's lock: ``keep_shut`` then keeps whoever has the lock from opening the gate
    again, until the stop is ``entered``.
    """

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        # next() of a counter is one step of the interpreter: no two threads get the same number.
        self._numbers = itertools.count(1)
        self._generation = 0
        self._opened = -1
        self._stops: set[object] = set()
        """Those that are on their way."""

    def shut(self) -> None:
        """No velocity but zero goes through from now on."""
        self._generation = next(self._numbers)

    def keep_shut(self, stop: object) -> None:
        """Shut, for a stop that is on its way: nothing opens the gate before that is entered. Takes no lock either."""
        self._stops.add(stop)
        self.shut()

    def entered(self, stop: object) -> None:
        """What the stop ends has ended; the gate stays shut until it is opened."""
        self._stops.discard(stop)

    def open(self) -> bool:
        """Let velocities through; False, and shut as before: a stop is on its way. Called by the executor, under its
        lock, when it begins something new."""
        # In this order: a stop that comes after the look at the stops changes the number.
        generation = self._generation
        if self._stops:
            return False
        self._opened = generation
        return True

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
