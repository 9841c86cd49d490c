"""What goes wrong with a velocity loop in a process of its own, and what a goal is told of it."""

from __future__ import annotations

from intent_engine.errors import RobotError
from intent_engine.execution.goal import Reason

__all__ = ["WITHOUT", "VelocityLoopError", "WatchdogError", "ended_by", "not_started"]

WITHOUT = "To drive without it, give the executor no loop"


class VelocityLoopError(RobotError):
    """The process that owns the velocity died or fell silent."""

    goal_reason = Reason.VELOCITY_LOOP


class WatchdogError(RobotError):
    """The process stopped the robot, because this program was silent for too long."""

    goal_reason = Reason.WATCHDOG


def not_started(sink: str) -> str:
    """Why there is no process, in words; ``sink``: what it was to drive."""
    return f"the velocity process did not start ({sink}); what it said is on standard error. {WITHOUT}"


def ended_by(code: int) -> str:
    """How a process ended, in words."""
    return f"signal {-code}" if code < 0 else f"exit code {code}"
