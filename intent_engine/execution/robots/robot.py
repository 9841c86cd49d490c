"""What a robot must be able to do to be driven by the executor.

A life cycle that can be recited: made -> used from one or more threads -> ``close()``, which is
idempotent and leaves zero velocity.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import Protocol, runtime_checkable

__all__ = ["Capability", "Pose", "Robot", "Task", "TaskState"]


class Capability(StrEnum):
    """What a robot may offer. An action that needs a missing one is refused with its name."""

    MOVE = "move"
    TURN = "turn"
    NAVIGATE = "navigate"
    PICK = "pick"
    PLACE = "place"


@dataclass(frozen=True, slots=True)
class Pose:
    """Where a robot is, or shall be."""

    x: float
    """m"""
    y: float
    """m"""
    yaw: float
    """rad, positive to the left"""
    frame: str = "map"


class TaskState(StrEnum):
    """How a long task of the robot (navigate, pick, place) stands."""

    RUNNING = "running"
    SUCCEEDED = "succeeded"
    CANCELED = "canceled"
    FAILED = "failed"


@runtime_checkable
class Task(Protocol):
    """A handle on a long task that the robot does by itself."""

    @property
    def state(self) -> TaskState: ...

    @property
    def reason(self) -> str:
        """Why it failed or was cancelled; empty otherwise."""
        ...

    @property
    def progress(self) -> float | None:
        """0 to 1, or None where the robot cannot tell."""
        ...

    def add_done_callback(self, callback: Callable[[Task], None]) -> None:
        """Call once when the task leaves RUNNING (at once if it has); from any thread."""
        ...


class Robot(Protocol):
    """The few methods that the executor needs. All are quick: they start things and return."""

    @property
    def capabilities(self) -> frozenset[Capability]: ...

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        """Drive at ``linear`` m/s and ``angular`` rad/s, for at most ``valid_for`` s unless renewed."""
        ...

    def stop(self) -> None:
        """Zero velocity and end every task, now. Never raises, may be called from any thread at any time."""
        ...

    def navigate(self, goal: Pose) -> Task: ...

    def pick(self, object_name: str) -> Task: ...

    def place(self, object_name: str | None, location: str | None) -> Task: ...

    def cancel(self, task: Task) -> None:
        """Ask for the task to end; its state says when it has."""
        ...

    def pose(self) -> Pose | None:
        """Where the robot believes it is; None if it cannot tell."""
        ...

    def close(self) -> None:
        """Zero velocity, then let go of what is held open. Idempotent."""
        ...
