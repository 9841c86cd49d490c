"""What becomes of a motion that is to be done faster, or slower: just as far, within the limits of the robot."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from intent_engine.actions import Action, Move, Turn
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.limits import Limits
from intent_engine.execution.runs import Ending

__all__ = ["ALONE", "COMING_TO_REST", "SpeedChange", "changed"]

_STANDS = "the robot does not move, so there is nothing to do at another speed; say it while it moves"
_BY_ITSELF = "how fast {} is done is not known here; only a drive or a turn can be done at another speed"
ALONE = Ending(
    GoalState.REJECTED,
    Reason.NOTHING_MOVES,
    "what it is said with would be over when its turn comes; say it by itself, while the robot moves",
)
"""The end of a change of speed that is one of several commands."""
COMING_TO_REST = Ending(GoalState.REJECTED, Reason.NOTHING_MOVES, "the robot is coming to rest at the end of its way")
"""The end of one that came too late."""


@dataclass(frozen=True, slots=True)
class SpeedChange:
    """A motion at its new speed."""

    action: Move | Turn
    speed: float
    """m/s or rad/s, signed."""
    told: str
    """The speed before and now, in words."""


def changed(running: Action | None, drives: bool, factor: float, limits: Limits) -> SpeedChange | Ending:
    """What is done now, at ``factor`` times its speed.

    A speed beyond the limit is cut down to it, whatever becomes of a command that asks for one: nobody has said a
    number. A motion that would take longer than the robot may move is left as it is, since it is to come just as far.

    Args:
        running: what is done now; None: nothing.
        drives: whether the velocity loop does it.
        factor: positive.
        limits: of the robot.

    Returns:
        The motion, or why it is left as it is.
    """
    if running is None:
        return Ending(GoalState.REJECTED, Reason.NOTHING_MOVES, _STANDS)
    if not (drives and isinstance(running, Move | Turn)):
        return Ending(GoalState.REJECTED, Reason.CAPABILITY, _BY_ITSELF.format(running.type))
    if isinstance(running, Move):
        present, amount, unit, bound = running.linear_velocity, running.distance, "m/s", limits.linear_velocity
    else:
        present, amount, unit, bound = running.angular_velocity, abs(running.angle), "rad/s", limits.angular_velocity
    speed = min(abs(present) * factor, bound)
    if factor > 1 and speed <= abs(present) * (1 + 1e-9):
        why = f"{abs(present):.4g} {unit} is the limit of this robot"
        return Ending(GoalState.REJECTED, Reason.LIMIT, f"it cannot go faster: {why}")
    if not math.isfinite(speed):  # of a robot without limits
        return Ending(GoalState.REJECTED, Reason.LIMIT, f"it cannot go faster: {factor:.4g} times as fast is no speed")
    duration = amount / speed if speed else math.inf
    if factor < 1 and not duration <= limits.duration * (1 + 1e-9):
        why = f"it would take {duration:.4g} s, and this robot's limit is {limits.duration:.4g} s"
        return Ending(GoalState.REJECTED, Reason.LIMIT, f"it cannot go slower: {why}")
    if not math.isfinite(duration):
        return Ending(GoalState.REJECTED, Reason.LIMIT, "it cannot go slower: it would never be there")
    signed = math.copysign(speed, present)
    action: Move | Turn
    if isinstance(running, Move):
        action = replace(running, linear_velocity=signed, duration=duration)
    else:
        action = replace(running, angular_velocity=signed, duration=duration)
    cut = ", the limit of this robot" if speed < abs(present) * factor else ""
    return SpeedChange(action, signed, f"from {abs(present):.4g} to {speed:.4g} {unit}{cut}")
