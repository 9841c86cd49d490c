"""Waiting for goals to end: in the time of the machine, or by moving a clock that stands still."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Sequence

from intent_engine.execution.clock import Clock, SteppedClock
from intent_engine.execution.given import check_timeout
from intent_engine.execution.goal import Goal
from intent_engine.execution.handlers import check_waiter

__all__ = ["Waiting"]


class Waiting:
    """For any thread.

    Args:
        clock: of the executor.
        ended: is told under the executor's lock whenever a goal has ended.
        idle: whether nothing is being carried out and nothing waits.
    """

    def __init__(self, clock: Clock, ended: threading.Condition, idle: Callable[[], bool]) -> None:
        self._clock = clock
        self._stepped = clock if isinstance(clock, SteppedClock) else None
        self._ended = ended
        self._idle = idle

    def renew(self, ended: threading.Condition) -> None:
        """The books have a new lock: in a child that was forked."""
        self._ended = ended

    def wait(self, goals: Sequence[Goal] | None, timeout: float | None) -> bool:
        """Whether the goals (None: all) have ended within ``timeout`` s.

        Raises:
            TypeError: the timeout is no number.
            ValueError: it is not one that can be waited for.
            RuntimeError: a handler waits without a timeout for what ends only after it.
        """
        check_timeout(timeout)
        check_waiter(goals, timeout)
        deadline = None if timeout is None else self._clock.now() + timeout
        if self._stepped is not None:
            return self._moved(self._stepped, goals, deadline)
        with self._ended:
            while not self._over(goals):
                if self._clock.wait_until(self._ended, deadline) and not self._over(goals):
                    return False
        return True

    def wait_for(self, goal: Goal, timeout: float | None) -> None:
        """Wait for one goal.

        Raises:
            TimeoutError: it has not ended in time.
        """
        if not self.wait([goal], timeout) and not goal.done:
            raise TimeoutError(f"{goal!r} has not ended")

    def _moved(self, clock: SteppedClock, goals: Sequence[Goal] | None, deadline: float | None) -> bool:
        while not self._over(goals):
            if not clock.step_once(math.inf if deadline is None else deadline):
                if deadline is not None:
                    clock.run_until_idle(deadline)
                return self._over(goals)
        return True

    def _over(self, goals: Sequence[Goal] | None) -> bool:
        return self._idle() if goals is None else all(goal.done for goal in goals)
