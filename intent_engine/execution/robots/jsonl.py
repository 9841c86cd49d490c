"""A robot behind a pipe: one JSON object a line, for any other process in any language.

What goes out::

    {"velocity": {"linear": 0.5, "angular": 0.0, "valid_for": 0.3}, "time": 12.34}
    {"stop": true, "time": 12.40}
    {"task": 1, "navigate": {"x": 5.0, "y": 2.0, "yaw": 0.0, "frame": "map"}, "time": 12.5}
    {"task": 2, "pick": {"object": "cup"}, "time": 20.1}
    {"task": 3, "place": {"object": null, "location": "table"}, "time": 25.0}
    {"cancel": 3, "time": 26.0}

What may come back, where a stream for replies was given::

    {"task": 1, "state": "succeeded"}            or "failed", "canceled", "running"
    {"task": 1, "state": "failed", "reason": "the way is blocked"}
    {"task": 1, "progress": 0.4}
    {"pose": {"x": 1.0, "y": 0.0, "yaw": 0.0}}

Times are seconds on this process's monotonic clock. The reader must drop a velocity after ``valid_for`` seconds by
itself: a pipe cannot tell a silent writer from a dead one.
"""

from __future__ import annotations

import itertools
import json
import logging
import math
import os
import select
import threading
import time
from collections.abc import Iterable
from typing import IO, Any

from intent_engine.errors import RobotError
from intent_engine.execution.robots.remote_task import RemoteTask
from intent_engine.execution.robots.robot import Capability, Pose, Task, TaskState

__all__ = ["JSONL_SINK", "JsonLinesRobot"]

log = logging.getLogger(__name__)

JSONL_SINK = "intent_engine.execution.robots.jsonl:JsonLinesRobot"
"""For ``Guardian(JSONL_SINK, {"out": file_descriptor}, pass_fds=(file_descriptor,))``."""

_STALLED = "the process behind the pipe is there, but does not read"
_ENDED = "the other process ended"


class JsonLinesRobot:
    """Writes each command as a line of JSON. Thread-safe; a line is written whole or not at all.

    A reader that stands still is lost like one that went away: a pipe is full when some hundred lines wait in it, and
    whoever wakes up to read them would drive by what was true half a minute ago. What is written then does not wait any
    more, so that a stop takes no time; once there is room again the robot is there again.

    Args:
        out: file descriptor to write to (1: standard output). Where others write to it too, as a guardian's process
            does, one that does not block is safer: the room that was seen may be gone.
        replies: lines that come back; None: nobody answers, and a task has succeeded when it is handed over.
        capabilities: what the process behind the pipe can do.
    """

    PATIENCE = 0.05
    """s that a write waits for a reader that has not read what was written before"""

    def __init__(
        self,
        out: int = 1,
        replies: IO[str] | None = None,
        capabilities: Iterable[Capability | str] = tuple(Capability),
    ) -> None:
        self._out = out
        self._capabilities = frozenset(Capability(name) for name in capabilities)
        self._lock = threading.Lock()
        self._numbers = itertools.count(1)
        self._given = 0
        """Number of the last task."""
        self._tasks: dict[int, RemoteTask] = {}
        """Those that are not known to have ended."""
        self._pose: Pose | None = None
        self._answers = replies is not None
        self._silent = False
        """No more replies come."""
        self._closed = False
        self._lost = ""
        if replies is not None:
            threading.Thread(target=self._listen, args=(replies,), name="jsonl-replies", daemon=True).start()

    @property
    def capabilities(self) -> frozenset[Capability]:
        return self._capabilities

    @property
    def lost(self) -> str:
        """Why the last line could not be written; empty: all is well."""
        return self._lost

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        if not (math.isfinite(linear) and math.isfinite(angular)):
            raise RobotError(f"velocity({linear}, {angular}): not numbers to drive by")
        self._write({"velocity": {"linear": linear, "angular": angular, "valid_for": valid_for}})

    def stop(self) -> None:
        # A pipe that nobody reads any more: there is nothing left that could be told to stop. It is said once.
        lost = self._lost
        try:
            self._write({"stop": True})
        except RobotError as error:
            if self._lost != lost or not lost:
                log.warning("no stop could be written: %s", error)
        for task in list(self._tasks.values()):
            task.end(TaskState.CANCELED, "stopped")

    def navigate(self, goal: Pose) -> Task:
        return self._begin("navigate", {"x": goal.x, "y": goal.y, "yaw": goal.yaw, "frame": goal.frame})

    def pick(self, object_name: str) -> Task:
        return self._begin("pick", {"object": object_name})

    def place(self, object_name: str | None, location: str | None) -> Task:
        return self._begin("place", {"object": object_name, "location": location})

    def cancel(self, task: Task) -> None:
        if isinstance(task, RemoteTask) and task.state is TaskState.RUNNING:
            self._write({"cancel": task.number})
            if not self._answers:
                task.end(TaskState.CANCELED, "cancelled")

    def pose(self) -> Pose | None:
        return self._pose

    def close(self) -> None:
        if not self._closed:
            self.stop()
            self._closed = True

    def _begin(self, kind: str, what: dict[str, Any]) -> Task:
        task = RemoteTask(next(self._numbers))
        self._given = max(self._given, task.number)
        self._tasks[task.number] = task
        task.add_done_callback(self._forget)
        if self._silent:  # looked at after the task is kept: the replies may end at any time
            task.end(TaskState.FAILED, _ENDED)
            return task
        try:
            self._write({"task": task.number, kind: what})
        except RobotError as error:
            task.end(TaskState.FAILED, str(error))
            raise
        if not self._answers:
            task.end(TaskState.SUCCEEDED, "handed over; the other process does not answer")
        return task

    def _forget(self, task: Task) -> None:
        if isinstance(task, RemoteTask):
            self._tasks.pop(task.number, None)

    def _write(self, message: dict[str, Any]) -> None:
        line = (json.dumps({**message, "time": round(time.monotonic(), 6)}) + "\n").encode()
        if len(line) > select.PIPE_BUF:
            # It would go out in pieces. Between two of them the guardian's process may write, or the reader stall: the
            # stop that comes next would stand in the midst of a line that nobody can read.
            raise RobotError(f"a line of {len(line)} bytes is too long; {select.PIPE_BUF} are written whole")
        if not self._lock.acquire(timeout=self.PATIENCE):
            raise RobotError(_STALLED)  # who holds it finds out whether that is so
        try:
            end = time.monotonic() + (0.0 if self._lost else self.PATIENCE)
            while line:
                # What is writable takes a line of this length whole, without waiting.
                if not select.select([], [self._out], [], max(end - time.monotonic(), 0.0))[1]:
                    raise BlockingIOError
                line = line[os.write(self._out, line) :]
            self._lost = ""
        except BlockingIOError:
            self._lost = _STALLED
            raise RobotError(self._lost) from None
        except BrokenPipeError as error:
            self._lost = f"the process behind the pipe is gone: {error}"
            raise RobotError(self._lost) from None
        except (OSError, ValueError) as error:
            self._lost = f"nothing can be written to the robot: {error}"
            raise RobotError(self._lost) from None
        finally:
            self._lock.release()

    def _listen(self, replies: IO[str]) -> None:
        try:
            for line in replies:
                try:
                    self._hear(json.loads(line))
                except (ValueError, TypeError, KeyError, AttributeError) as error:
                    log.warning("a reply that cannot be understood (%s): %.200r", error, line)
        except (OSError, ValueError) as error:  # ValueError: it is no text, or was closed under us
            log.warning("replies cannot be read: %s", error)
        self._silent = True
        for task in list(self._tasks.values()):
            task.end(TaskState.FAILED, _ENDED)

    def _hear(self, message: dict[str, Any]) -> None:
        if "pose" in message:
            pose = message["pose"]
            self._pose = Pose(float(pose["x"]), float(pose["y"]), float(pose["yaw"]), str(pose.get("frame", "map")))
        if "task" not in message:
            return
        number = int(message["task"])
        task = self._tasks.get(number)
        if task is None:
            if not 0 < number <= self._given:
                raise ValueError(f"there is no task {number}")
            return  # an answer that comes after a stop
        if "progress" in message:
            task.progress = float(message["progress"])
        state = TaskState(message.get("state", TaskState.RUNNING))
        if state is not TaskState.RUNNING:
            task.end(state, str(message.get("reason", "")))
