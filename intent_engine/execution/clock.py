"""Time as the executor sees it: absolute deadlines on a clock that never jumps.

Three clocks share one protocol: the monotonic clock of the machine, a virtual clock that is moved by hand (or moves
itself to the next thing that is due, so that a file is played as fast as possible and always in the same way), and
whatever a robot's middleware brings (ROS time with ``use_sim_time``).
"""

from __future__ import annotations

import math
import threading
import time
from typing import Protocol, runtime_checkable

from intent_engine.values import is_number

__all__ = ["Clock", "MonotonicClock", "Stepped", "SteppedClock", "VirtualClock"]


class Clock(Protocol):
    """Seconds that only grow, and a wait that can be interrupted."""

    def now(self) -> float:
        """Seconds since some fixed moment."""
        ...

    def wait_until(self, condition: threading.Condition, deadline: float | None) -> bool:
        """Wait, with ``condition`` held by the caller, for a notification or for ``deadline`` (None: for ever).

        Returns:
            True if the deadline has come, False if something was notified before it.
        """
        ...


class MonotonicClock:
    """The machine's monotonic clock. On Linux all processes share it, so a deadline may cross a process boundary."""

    def now(self) -> float:
        return time.monotonic()

    def wait_until(self, condition: threading.Condition, deadline: float | None) -> bool:
        # A wait for a time that is computed here, from an absolute deadline, does not add up the errors of a chain of
        # sleeps; and a condition, unlike a sleep, hears a stop at once.
        if deadline is None:
            condition.wait()
            return False
        timeout = deadline - time.monotonic()
        if timeout <= 0:
            return True
        # threading cannot wait longer than this; the caller looks at the clock again anyway.
        condition.wait(min(timeout, threading.TIMEOUT_MAX))
        return time.monotonic() >= deadline


class Stepped(Protocol):
    """Something that a :class:`VirtualClock` moves: it says when it wants to be called, and is called then."""

    def due(self) -> float | None:
        """When :meth:`step` shall be called next; None when there is nothing to wait for."""
        ...

    def step(self) -> None:
        """Do what is due at the clock's present time. Must move :meth:`due` on, or the clock would stand still."""
        ...


@runtime_checkable
class SteppedClock(Protocol):
    """A clock that runs what is attached to it, instead of being waited on by threads."""

    def attach(self, stepped: Stepped) -> None: ...

    def detach(self, stepped: Stepped) -> None: ...

    def step_once(self, limit: float = math.inf) -> bool: ...

    def run_until_idle(self, limit: float | None = None) -> bool: ...


class VirtualClock:
    """A clock that stands still until it is moved, and on its way does everything that is due, in order of time.

    No thread sleeps: :meth:`advance` and :meth:`run_until_idle` call the steps of what is attached (an executor, a
    simulated robot) one after the other, each at exactly its own time, in the thread of the caller. Two runs give the
    same times to the last bit. What is due at the same time is done in the order of attachment.

    A program that plays a recording calls ``clock.advance_to(time_of_the_frame)`` before each frame: the robot moves
    up to that time, and no further.
    """

    MAX_STEPS_AT_ONE_TIME = 10_000
    """A step that never moves its due time is a bug; it is named instead of turning for ever."""

    def __init__(self, start: float = 0.0) -> None:
        self._now = _moment(start)
        self._lock = threading.RLock()
        self._attached: list[Stepped] = []

    def now(self) -> float:
        return self._now

    def attach(self, stepped: Stepped) -> None:
        with self._lock:
            if not any(other is stepped for other in self._attached):
                self._attached.append(stepped)

    def detach(self, stepped: Stepped) -> None:
        with self._lock:
            self._attached = [other for other in self._attached if other is not stepped]

    def advance(self, seconds: float) -> None:
        """Move on by ``seconds``."""
        self.advance_to(self._now + _moment(seconds))

    def advance_to(self, moment: float) -> None:
        """Move on to ``moment`` (never back), doing what is due on the way, what is due at ``moment`` included."""
        moment = _moment(moment)
        with self._lock:
            self._run(moment)
            self._now = max(self._now, moment)

    def run_until_idle(self, limit: float | None = None) -> bool:
        """Move from one due time to the next until nothing is due.

        Args:
            limit: go no further than this time (s on this clock).

        Returns:
            True if nothing is due any more, False if the limit came first.
        """
        with self._lock:
            self._run(math.inf if limit is None else limit)
            if self._next()[0] is None:
                return True
            if limit is not None:
                self._now = max(self._now, limit)
            return False

    def step_once(self, limit: float = math.inf) -> bool:
        """Go to the next due time and do that one step; False if nothing is due up to ``limit``."""
        with self._lock:
            due, stepped = self._next()
            if due is None or stepped is None or due > limit:
                return False
            self._now = max(self._now, due)
            stepped.step()
            return True

    def wait_until(self, condition: threading.Condition, deadline: float | None) -> bool:
        """Move to ``deadline`` instead of waiting; with none, do all that is due and return."""
        if deadline is None:
            self.run_until_idle()
            return False
        self.advance_to(max(deadline, self._now))
        return True

    def _next(self) -> tuple[float | None, Stepped | None]:
        first: float | None = None
        who: Stepped | None = None
        for stepped in self._attached:
            due = stepped.due()
            if due is not None and (first is None or due < first):
                first, who = due, stepped
        return first, who

    def _run(self, until: float) -> None:
        steps, at = 0, self._now
        while self.step_once(until):
            steps = steps + 1 if self._now == at else 0
            at = self._now
            if steps > self.MAX_STEPS_AT_ONE_TIME:
                raise RuntimeError(f"time stands still at {at}: {self._next()[1]!r} is due again and again")


def _moment(given: float) -> float:
    """A time that a program gave, or by how much it is to go on.

    Raises:
        TypeError: it is no number.
        ValueError: it is not finite.
    """
    if not is_number(given):
        raise TypeError(f"a clock is moved by a number of s, not by {given!r:.80}")
    if not math.isfinite(given):
        raise ValueError(f"a clock cannot be moved to {given}")
    return given
