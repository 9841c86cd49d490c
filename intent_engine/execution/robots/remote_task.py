"""A task that something outside this process does: another program behind a pipe, an action server."""

from __future__ import annotations

import threading
from collections.abc import Callable

from intent_engine.execution.robots.robot import Task, TaskState

__all__ = ["RemoteTask"]


class RemoteTask:
    """A :class:`Task` that is ended from whichever thread the news comes in. Thread-safe; it ends once."""

    def __init__(self, number: int = 0) -> None:
        self.number = number
        self.reason = ""
        self.progress: float | None = None
        self.state = TaskState.RUNNING
        self._callbacks: list[Callable[[Task], None]] = []
        self._lock = threading.Lock()

    def add_done_callback(self, callback: Callable[[Task], None]) -> None:
        with self._lock:
            if self.state is TaskState.RUNNING:
                self._callbacks.append(callback)
                return
        callback(self)

    def end(self, state: TaskState, reason: str) -> None:
        """Leave RUNNING, and tell who wants to know; nothing if it has ended before."""
        with self._lock:
            if self.state is not TaskState.RUNNING:
                return
            self.reason, self.state = reason, state
            if state is TaskState.SUCCEEDED:
                self.progress = 1.0
            callbacks, self._callbacks = self._callbacks, []
        for callback in callbacks:
            callback(self)
