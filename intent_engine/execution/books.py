"""The lock under which an executor keeps its books, and the stop that waits for it only so long.

A robot that hangs holds the lock up. A stop then acts past it: velocities are shut off and the robot is stopped at
once, and what has ended is entered as soon as the lock is free, before anything else is done under it. Whoever has the
lock until then begins nothing. Everybody else is told that it hangs.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from intent_engine.execution.clock import Clock
from intent_engine.execution.events import EventKind
from intent_engine.execution.failsafe import Failsafe
from intent_engine.execution.gate import Gate
from intent_engine.execution.goal import Reason
from intent_engine.execution.stops import StopCall, Stops

__all__ = ["Books"]


class Books:
    """Who may enter something, and when somebody looks at it again. From any thread.

    Args:
        clock: gives the time.
        gate: which a stop shuts first.
        failsafe: stops a robot whose lock cannot be had.
        enter: ends what a stop ends, under the lock: why, what is told of it, and the time.
    """

    PATIENCE = 0.005
    """s that a stop, or a hold, waits for the lock, before it stops the robot past it."""
    LATER = 0.5
    """s that a stop then waits for the lock, to end the goals before it returns."""
    ANSWER = 1.0
    """s that all else waits for it: a robot's calls start things and return."""
    HANGING = 0.05
    """s that all of them wait for the lock of a robot that is known to hang."""
    CLOSING = 1.0
    """s that closing waits for it besides."""

    def __init__(
        self, clock: Clock, gate: Gate, failsafe: Failsafe, enter: Callable[[Reason, EventKind, float], None]
    ) -> None:
        self._clock = clock
        self._gate = gate
        self._failsafe = failsafe
        self._enter = enter
        self.renew()
        self.stops = Stops()
        self.hangs = False
        """Whether the lock could not be had when it was last asked for."""
        self._late: list[StopCall] = []
        """Stops that could not take the lock: they are still to be entered."""
        self._poked = False

    def renew(self) -> None:
        """Begin with a lock that nobody has: in a child that was forked, where a thread of the parent has the old one
        for ever."""
        self.lock = threading.RLock()
        self.wake = threading.Condition(self.lock)
        """Something is due earlier than was thought."""
        self.ended = threading.Condition(self.lock)
        """A goal has ended."""

    @property
    def due(self) -> bool:
        """Whether somebody is to look at once."""
        return self._poked or bool(self._late)

    def looked(self) -> None:
        """Somebody looks now."""
        self._poked = False

    def poke(self) -> None:
        """Look again soon. Takes no lock that a robot's thread could be waiting for."""
        self._poked = True
        if self.lock.acquire(blocking=False):
            try:
                self.wake.notify_all()
            finally:
                self.lock.release()

    def tell_ended(self) -> None:
        """A goal has ended. Nobody waits for one that was turned away because somebody else has the lock."""
        if self.lock.acquire(blocking=False):
            try:
                self.ended.notify_all()
            finally:
                self.lock.release()

    @contextmanager
    def locked(self) -> Iterator[float]:
        """The lock, and the time; a stop that is still to be entered comes before all else."""
        with self.lock:
            self.hangs = False
            now = self._clock.now()
            if self._late:
                self._end_what_they_end(self._late[-1], now)
            yield now

    @contextmanager
    def asked(self) -> Iterator[float | None]:
        """The same for who must not wait for ever: None, and no lock, if a robot hangs that has it."""
        if not self._had(self.ANSWER):
            yield None
            return
        with self._given_back() as now:
            yield now

    @contextmanager
    def resting(self) -> Iterator[float | None]:
        """The same for what brings a robot to rest: one that hangs is stopped."""
        with self.asked() as now:
            if now is None:
                self.stop(Reason.ROBOT_ERROR, EventKind.STOP)
            yield now

    @contextmanager
    def held(self) -> Iterator[float | None]:
        """The same for a hold, with velocities shut off before it; a robot that hangs is stopped before it is had, and
        its hold is a stop."""
        hold = object()
        self._gate.keep_shut(hold)
        try:
            locked = self.lock.acquire(timeout=self.PATIENCE)
            if not locked:
                self._failsafe.stop_past()  # see stop
                locked = self._had(self.LATER)
            if not locked:
                self.stop(Reason.ROBOT_ERROR, EventKind.STOP)
                yield None
                return
            with self._given_back() as now:
                yield now
        finally:
            self._gate.entered(hold)

    @contextmanager
    def _given_back(self) -> Iterator[float]:
        """The same with a lock that is had already, and given back at the end."""
        try:
            with self.locked() as now:
                yield now
        finally:
            self.lock.release()

    def _had(self, patience: float) -> bool:
        """Whether the lock could be had within so many s. That it could not is told once."""
        if self.lock.acquire(timeout=self.HANGING if self.hangs else patience):
            return True
        if not self.hangs:
            self.hangs = True
            self._failsafe.hangs()
        return False

    def stop(self, reason: Reason, kind: EventKind, said: float | None = None) -> StopCall:
        """Velocities are shut off, the robot is stopped, and what that ends is entered: now, or when the lock is
        free. ``said``: s on the clock, when its words ended; None: it was not spoken."""
        self._gate.shut()
        now = self._clock.now()
        stop = StopCall(reason, kind, now if said is None else min(said, now))
        self._gate.keep_shut(stop)
        self.stops.asked(stop)
        locked = False
        try:
            locked = self.lock.acquire(timeout=self.PATIENCE)
            if not locked:
                # The robot hangs in a call that another thread made, or the machine has no time for that thread. The
                # robot's stop may be called at any time; the shut gate writes another zero after a call that hangs.
                self._failsafe.stop_past()
                locked = self.lock.acquire(timeout=self.LATER)
        finally:
            if not locked:  # or Ctrl-C came meanwhile
                self._late.append(stop)
                self.poke()
        if locked:
            try:
                self._end_what_they_end(stop, self._clock.now())
                self.wake.notify_all()
            finally:
                self.lock.release()
        return stop

    def enter_late(self) -> None:
        """Enter what is still to be entered, if the lock can be had soon; the executor's thread does it otherwise."""
        if self._late and self.lock.acquire(timeout=self.CLOSING):
            with self._given_back():
                pass

    def _end_what_they_end(self, stop: StopCall, now: float) -> None:
        """Enter a stop, under the lock. Those that came too late before it end nothing that it does not."""
        late = [self._late.pop(0) for _ in range(len(self._late))]  # another may be added meanwhile
        try:
            self._enter(stop.reason, stop.kind, now)
        finally:
            self.stops.entered((*late, stop))
            for each in (*late, stop):
                self._gate.entered(each)
