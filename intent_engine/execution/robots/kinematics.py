"""Where a differential drive comes to: poses in closed form, for constant speeds and for constant accelerations."""

from __future__ import annotations

import math

from intent_engine.execution.robots.robot import Pose

__all__ = ["arc", "drive"]


def arc(pose: Pose, linear: float, angular: float, t: float) -> Pose:
    """Constant speeds for ``t`` s: a point, a line or an arc."""
    if angular == 0.0:
        return Pose(
            pose.x + linear * t * math.cos(pose.yaw), pose.y + linear * t * math.sin(pose.yaw), pose.yaw, pose.frame
        )
    yaw = pose.yaw + angular * t
    # sin(b) - sin(a) = 2 cos(mean) sin(half): exact where the arc is nearly a line, too.
    half = angular * t / 2.0
    chord = linear * t * (math.sin(half) / half if half else 1.0)
    return Pose(pose.x + chord * math.cos(pose.yaw + half), pose.y + chord * math.sin(pose.yaw + half), yaw, pose.frame)


def drive(pose: Pose, linear: float, linear_rate: float, angular: float, angular_rate: float, t: float) -> Pose:
    """Constant accelerations for ``t`` s: in closed form, but for a ramp on a curve (a Fresnel integral)."""
    if angular == 0.0 and angular_rate == 0.0:
        way = linear * t + 0.5 * linear_rate * t * t
        return Pose(pose.x + way * math.cos(pose.yaw), pose.y + way * math.sin(pose.yaw), pose.yaw, pose.frame)
    if linear_rate == 0.0 and angular_rate == 0.0:
        return arc(pose, linear, angular, t)
    yaw = pose.yaw + angular * t + 0.5 * angular_rate * t * t
    if linear == 0.0 and linear_rate == 0.0:
        return Pose(pose.x, pose.y, yaw, pose.frame)
    # Simpson's rule; its error falls with the fourth power of the step, here below 1e-9 m.
    steps = 2 * max(4, math.ceil(t / 0.02))
    h = t / steps
    x = y = 0.0
    for index in range(steps + 1):
        at = index * h
        weight = 1 if index in (0, steps) else 4 if index % 2 else 2
        heading = pose.yaw + angular * at + 0.5 * angular_rate * at * at
        speed = linear + linear_rate * at
        x += weight * speed * math.cos(heading)
        y += weight * speed * math.sin(heading)
    return Pose(pose.x + x * h / 3.0, pose.y + y * h / 3.0, yaw, pose.frame)
