"""The path that a robot drove, as it remembers it, and as a picture needs it."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

from intent_engine.execution.robots.kinematics import arc
from intent_engine.execution.robots.robot import Pose

__all__ = ["TracePoint", "path_points"]


@dataclass(frozen=True, slots=True)
class TracePoint:
    """One point of the path that the robot drove."""

    time: float
    """s on the robot's clock"""
    pose: Pose
    linear: float
    """m/s from here on"""
    angular: float
    """rad/s from here on"""


def path_points(trace: Iterable[TracePoint], end: Pose) -> list[Pose]:
    """The path as poses that straight lines may join: curves are cut into pieces of at most 0.1 rad."""
    marks = list(trace)
    if not marks:
        return [end]
    points = [marks[0].pose]
    for mark, following in pairwise([*marks, None]):
        assert mark is not None
        goal = following.pose if following is not None else end
        turned = goal.yaw - mark.pose.yaw
        if mark.linear and mark.angular and abs(turned) > 0.1:
            length = turned / mark.angular
            steps = math.ceil(abs(turned) / 0.1)
            points += [arc(mark.pose, mark.linear, mark.angular, length * i / steps) for i in range(1, steps)]
        points.append(goal)
    return points
