"""Gives commands to an executor in a thread of their own: a robot that hangs in a call makes nobody deaf to a stop."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Future, wait
from contextvars import copy_context
from typing import Any

from intent_engine.actions import Action
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import Goal
from intent_engine.speech.beside import Beside

__all__ = ["Hands"]


class Hands:
    """What makes a robot begin something, or go on. For one thread.

    Args:
        executor: is given the commands.
        stepped: whether time stands still meanwhile: nothing hangs then.
    """

    PATIENCE = 2.0
    """s that a command is waited for: longer than an executor waits for a robot that hangs already."""
    END = 1.0
    """s that the end of the process waits for a robot that hangs."""

    def __init__(self, executor: Executor, *, stepped: bool) -> None:
        self._executor = executor
        self._worker = None if stepped else Beside("commands", patience=self.END)
        self._under_way: Future[None] | None = None

    def submit(self, actions: Sequence[Action], **terms: Any) -> list[Goal] | None:
        """As :meth:`Executor.submit`. None: the robot hangs in the call that this has made."""
        made: list[list[Goal]] = []
        return made[0] if self._did(lambda: made.append(self._executor.submit(actions, **terms))) else None

    def release(self) -> bool:
        """As :meth:`Executor.release`. False: the robot hangs in the call that this has made."""
        return self._did(self._executor.release)

    def _did(self, work: Callable[[], None]) -> bool:
        """Whether it was done in time."""
        if self._worker is None or not (self._under_way is None or self._under_way.done()):
            work()  # of a robot that hangs, the executor says so itself, and soon
            return True
        # In the same context: what a handler asks for is its own.
        asked = self._under_way = self._worker.submit(copy_context().run, work)
        wait([asked], self.PATIENCE)
        if asked.done():
            asked.result()  # raises what it raised
        return asked.done()
