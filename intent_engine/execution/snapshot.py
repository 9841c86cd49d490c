"""How an executor stands, at one moment."""

from __future__ import annotations

from dataclasses import dataclass

from intent_engine.execution.goal import Goal
from intent_engine.execution.robots.robot import Pose

__all__ = ["Snapshot"]


@dataclass(frozen=True, slots=True)
class Snapshot:
    """How the executor stands."""

    goal: Goal | None
    """What is being carried out."""
    queued: int
    held: bool
    paused: bool
    estopped: bool
    closed: bool
    velocity: tuple[float, float]
    """m/s and rad/s, as last written"""
    pose: Pose | None
    hangs: bool = False
    """The robot has not come back from a call: nothing but a stop is done until it has."""
