"""Actions, poses and interpretations in words, for the terminal."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from intent_engine.actions import Action, ChangeSpeed, Custom, Move, Navigate, Pick, Place, Stop, Turn
from intent_engine.interpretation import Interpretation, Status

if TYPE_CHECKING:
    from intent_engine.execution.robots.robot import Pose

__all__ = ["STYLES", "action_text", "interpretation_lines", "meaning_text", "pose_text", "slots_text"]

STYLES: Mapping[Status, str] = {
    Status.ACCEPTED: "green",
    Status.INCOMPLETE: "yellow",
    Status.AMBIGUOUS: "yellow",
    Status.REJECTED: "red",
}
"""The colour of each status, where the terminal has colours."""


def action_text(action: Action) -> str:
    """An action with its velocity, distance or angle, and duration."""
    match action:
        case Move():
            way = "forward" if action.linear_velocity >= 0 else "backward"
            return (
                f"move {way} {action.distance:.2f} m at {action.linear_velocity:+.2f} m/s for {action.duration:.2f} s"
            )
        case Turn():
            side = "left" if action.angle >= 0 else "right"
            degrees = abs(math.degrees(action.angle))
            return f"turn {side} {degrees:.1f}° at {action.angular_velocity:+.2f} rad/s for {action.duration:.2f} s"
        case Stop():
            return "stop"
        case Navigate():
            degrees = math.degrees(action.yaw)
            return f"navigate to {action.location} (x {action.x:.2f} m, y {action.y:.2f} m, facing {degrees:.0f}°)"
        case Pick():
            return f"pick {action.object}"
        case Place():
            where = f" at {action.location}" if action.location else " here"
            return f"place {action.object or 'what is held'}{where}"
        case ChangeSpeed():
            return f"change the speed to {action.factor:g} times the present one"
        case Custom():
            slots = slots_text(action.slots)
            return f"{action.name} {slots}".rstrip()


def meaning_text(intent: str | None, slots: Mapping[str, Any]) -> str:
    """An intent with its slots, or each of several."""
    steps = slots.get("steps")
    if isinstance(steps, list):
        return "; ".join(meaning_text(step["intent"], step["slots"]) for step in steps)
    return f"{intent} {slots_text(slots)}".rstrip()


def slots_text(slots: Mapping[str, Any]) -> str:
    """Slots as ``name=value``, floats to three places."""
    return " ".join(f"{name}={_value(value)}" for name, value in slots.items())


def _value(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.3f}".rstrip("0").rstrip(".")
    return str(value)


def pose_text(pose: Pose) -> str:
    """Where a robot is."""
    return f"x {pose.x:.2f} m, y {pose.y:.2f} m, facing {math.degrees(pose.yaw):.0f}°"


def interpretation_lines(found: Interpretation) -> Iterator[tuple[str, str | None]]:
    """What was understood, line by line, each with its style."""
    head = found.status.value
    if found.status is Status.ACCEPTED:
        head += f": {meaning_text(found.intent, found.slots)} (confidence {found.confidence:.2f})"
    elif found.reason:
        head += f": {found.reason}"
    yield head, STYLES[found.status]
    if found.status is Status.ACCEPTED and found.reason:
        yield f"  note: {found.reason}", "dim"
    if found.alternatives:
        word = {Status.AMBIGUOUS: "either", Status.INCOMPLETE: "may go on with"}.get(found.status, "nearest")
        yield f"  {word}: {', '.join(found.alternatives)}", "dim"
    for action in found.actions:
        yield f"  -> {action_text(action)}", None
