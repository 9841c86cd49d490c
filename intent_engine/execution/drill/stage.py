"""What trials have in common: a motion that this robot may do, and patience."""

from __future__ import annotations

import time
from collections.abc import Callable

from intent_engine.actions import Action, Move, Turn
from intent_engine.execution.robots.robot import Capability
from intent_engine.execution.robots.robot_file import RobotFile

__all__ = ["long_motion", "until"]


def long_motion(file: RobotFile, seconds: float = 30.0) -> Action:
    """A long motion that this robot's limits allow."""
    limits = file.limits
    if Capability.MOVE in file.capabilities or Capability.TURN not in file.capabilities:
        speed = min(0.5, limits.linear_velocity)
        duration = min(seconds, limits.duration, limits.distance / speed)
        return Move(speed, speed * duration, duration)
    speed = min(0.5, limits.angular_velocity)
    duration = min(seconds, limits.duration, limits.angle / speed)
    return Turn(speed * duration, speed, duration)


def until(condition: Callable[[], bool], seconds: float = 10.0) -> bool:
    """Whether it comes true in time."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.001)
    return True
