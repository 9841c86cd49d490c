"""The life of an executor: its thread, or its place on a virtual clock, and its end, also with the process."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import partial

from intent_engine.execution import shutdown
from intent_engine.execution.books import Books
from intent_engine.execution.clock import Clock, SteppedClock
from intent_engine.execution.events import Dispatcher, EventKind
from intent_engine.execution.failsafe import Failsafe
from intent_engine.execution.gate import Gate
from intent_engine.execution.goal import Reason
from intent_engine.execution.intake import Intake
from intent_engine.execution.pulse import Pulse
from intent_engine.execution.robots.robot import Robot
from intent_engine.execution.runs import VelocityLoop
from intent_engine.execution.waiting import Waiting

__all__ = ["Life"]


class Life:
    """Made -> :meth:`begin` -> :meth:`close`, or :meth:`disown` in a child that was forked.

    Args:
        robot: is stopped at the end.
        loop: is closed then, if it can be.
        gate: is shut before the last zeros.
        failsafe: writes them.
        books: enter the last stop.
        events: their threads end.
        intake: refuses what comes later.
        waiting: for goals, under the lock of the books.
        zeros: how many end a life.
    """

    def __init__(
        self,
        robot: Robot,
        loop: VelocityLoop,
        gate: Gate,
        failsafe: Failsafe,
        books: Books,
        events: Dispatcher,
        intake: Intake,
        waiting: Waiting,
        zeros: int,
    ) -> None:
        self.robot = robot
        self._loop = loop
        self._gate = gate
        self._failsafe = failsafe
        self._books = books
        self._events = events
        self._intake = intake
        self._waiting = waiting
        self._zeros = zeros
        self._closing = threading.Lock()
        """Taken by who closes, for good."""
        self._thread: threading.Thread | None = None
        self._leave_clock: Callable[[], None] = lambda: None

    def begin(self, clock: Clock, pulse: Pulse, sigterm: bool) -> None:
        """Do what is due, by a clock that is moved or in a thread. ``sigterm``: stop the robot when the process is
        asked to end, if nobody else listens to that."""
        if isinstance(clock, SteppedClock):
            clock.attach(pulse)
            self._leave_clock = partial(clock.detach, pulse)
        else:
            self._thread = threading.Thread(target=pulse.run, name="executor", daemon=True)
            self._thread.start()
        shutdown.register(self, sigterm)

    def close(self) -> None:
        """Stop, end the thread, write the last zeros. Idempotent."""
        if not self._closing.acquire(blocking=False):
            return
        self._intake.closed = True
        try:
            self._books.stop(Reason.CLOSED, EventKind.STOP)
            self._events.flush()
            self._books.enter_late()
        finally:  # also where Ctrl-C, or a robot's sys.exit(), breaks that off
            if self._thread is not None and self._thread is not threading.current_thread():
                self._thread.join(1.0)
            self._leave_clock()
            try:
                self.last_zeros()
                shutdown.unregister(self)
            finally:
                if hasattr(self._loop, "close"):
                    self._loop.close()
                self._events.close()

    def last_zeros(self) -> None:
        """Zero, as often as the rates say, without lock or thread: for the end of the process."""
        self._gate.shut()
        for _ in range(self._zeros):
            self._failsafe.stop_robot()

    def disown(self) -> None:
        """In a child that was forked: the robot is the parent's, and what is submitted here is rejected."""
        self._gate.shut()
        self._intake.closed = True
        self._closing.acquire(blocking=False)
        self._books.renew()
        self._waiting.renew(self._books.ended)
        self._events.disown()
