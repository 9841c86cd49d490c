"""A robot for tests: it remembers every command, and its tasks end when the test says so."""

from __future__ import annotations

import threading
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from intent_engine.execution.clock import Clock, MonotonicClock
from intent_engine.execution.robots.remote_task import RemoteTask
from intent_engine.execution.robots.robot import Capability, Pose, Task, TaskState

__all__ = ["Command", "RecordedTask", "RecordingRobot"]


@dataclass(frozen=True, slots=True)
class Command:
    """One call of a robot's method."""

    name: str
    """``velocity``, ``stop``, ``navigate``, ``pick``, ``place``, ``cancel`` or ``close``."""
    arguments: dict[str, Any] = field(default_factory=dict)
    """By the names of the method's parameters; m/s, rad/s and s."""
    time: float = 0.0
    """s, on the robot's clock."""


class RecordedTask(RemoteTask):
    """A task that runs until the test ends it: running -> succeeded, failed or canceled."""

    def __init__(self, command: Command) -> None:
        super().__init__()
        self.command = command

    def succeed(self) -> None:
        """It is done."""
        self.end(TaskState.SUCCEEDED, "")

    def fail(self, reason: str) -> None:
        """It could not be done."""
        self.end(TaskState.FAILED, reason)

    def cancel(self, reason: str = "") -> None:
        """It was given up."""
        self.end(TaskState.CANCELED, reason)


class RecordingRobot:
    """Does nothing, and remembers what it was told. Thread-safe.

    Args:
        clock: for the times of commands.
        capabilities: what it says that it can do.
        finish_tasks: whether navigate, pick and place have succeeded at once; else a test ends them
            (``robot.tasks[-1].succeed()``).
        pose: where it says that it is.
    """

    def __init__(
        self,
        clock: Clock | None = None,
        *,
        capabilities: Iterable[Capability] = tuple(Capability),
        finish_tasks: bool = True,
        pose: Pose | None = None,
    ) -> None:
        self.clock: Clock = clock or MonotonicClock()
        self.commands: list[Command] = []
        """In the order in which they came."""
        self.tasks: list[RecordedTask] = []
        self._capabilities = frozenset(capabilities)
        self._finish_tasks = finish_tasks
        self._pose = pose
        self._lock = threading.RLock()

    @property
    def capabilities(self) -> frozenset[Capability]:
        return self._capabilities

    @property
    def names(self) -> list[str]:
        """The names of the commands, in order."""
        return [command.name for command in self.commands]

    @property
    def velocities(self) -> list[tuple[float, float]]:
        """(linear m/s, angular rad/s) of every write, in order; ``stop`` and ``close`` are zeros."""
        return [
            (command.arguments["linear"], command.arguments["angular"]) if command.name == "velocity" else (0.0, 0.0)
            for command in list(self.commands)
            if command.name in ("velocity", "stop", "close")
        ]

    @property
    def at_rest(self) -> bool:
        """Whether the last write was zero and no task runs."""
        written = self.velocities
        running = any(task.state is TaskState.RUNNING for task in self.tasks)
        return not running and (not written or written[-1] == (0.0, 0.0))

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        self._record("velocity", linear=linear, angular=angular, valid_for=valid_for)

    def stop(self) -> None:
        self._record("stop")
        for task in list(self.tasks):
            task.cancel("stopped")

    def navigate(self, goal: Pose) -> Task:
        return self._begin("navigate", goal=goal)

    def pick(self, object_name: str) -> Task:
        return self._begin("pick", object_name=object_name)

    def place(self, object_name: str | None, location: str | None) -> Task:
        return self._begin("place", object_name=object_name, location=location)

    def cancel(self, task: Task) -> None:
        self._record("cancel", task=task)
        if isinstance(task, RecordedTask):
            task.cancel("canceled")

    def pose(self) -> Pose | None:
        return self._pose

    def close(self) -> None:
        self._record("close")

    def _record(self, name: str, **arguments: Any) -> Command:
        command = Command(name, arguments, self.clock.now())
        with self._lock:
            self.commands.append(command)
        return command

    def _begin(self, name: str, **arguments: Any) -> RecordedTask:
        task = RecordedTask(self._record(name, **arguments))
        with self._lock:
            self.tasks.append(task)
        if self._finish_tasks:
            task.succeed()
        return task
