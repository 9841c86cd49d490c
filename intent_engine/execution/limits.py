"""What a robot may be told: limits, and whether a wish beyond them is refused or cut down to them.

NaN and infinity are refused by every limit set, the empty one included.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Any, NamedTuple

from intent_engine.actions import Action, Move, Navigate, Turn
from intent_engine.values import is_number, named

__all__ = ["IN_DEGREES", "Checked", "Limits", "OverLimit"]

IN_DEGREES = 20.0
"""rad/s; who writes more for how fast a robot may turn wrote degrees, and it would turn as fast as it was told."""


class OverLimit(StrEnum):
    """What happens to an action beyond a limit."""

    REFUSE = "refuse"
    """It is not done, and the goal says which limit it broke."""
    CLAMP = "clamp"
    """It is done within the limit, and the goal says what was changed."""


@dataclass(frozen=True, slots=True)
class Checked:
    """What :meth:`Limits.check` says."""

    action: Action
    """The action to do: as it was, or cut down."""
    refused: str = ""
    """Why it must not be done; empty if it may."""
    limit: str = ""
    """Name of the limit that refused it."""
    clamped: tuple[str, ...] = ()
    """One sentence for each value that was cut down."""


class _Asked(NamedTuple):
    """One value of what is asked for."""

    limit: str
    """Name of the limit that it has."""
    value: float
    unit: str


@dataclass(frozen=True, slots=True)
class Limits:
    """A robot's limits; infinite where there is none."""

    linear_velocity: float = math.inf
    """m/s, forward and backward"""
    angular_velocity: float = math.inf
    """rad/s, to either side"""
    linear_acceleration: float = math.inf
    """m/s^2, of the ramps up"""
    angular_acceleration: float = math.inf
    """rad/s^2, of the ramps up"""
    linear_deceleration: float | None = None
    """m/s^2, of the ramps down; None: as the acceleration"""
    angular_deceleration: float | None = None
    """rad/s^2, of the ramps down; None: as the acceleration"""
    distance: float = math.inf
    """m, longest single move"""
    angle: float = math.inf
    """rad, largest single turn"""
    duration: float = math.inf
    """s, longest single move or turn"""
    task_duration: float = 600.0
    """s, longest navigation, pick, place or handler; then it is cancelled"""
    over: OverLimit = OverLimit.REFUSE
    over_each: dict[str, OverLimit] = field(default_factory=dict, hash=False)
    """Limit name -> what to do beyond this one, where it differs from ``over``."""

    def __post_init__(self) -> None:
        for name in (*_NAMES, *_OPTIONAL):
            value: Any = getattr(self, name)
            if value is None and name in _OPTIONAL:
                continue
            if not is_number(value):
                raise TypeError(f"the limit {name} is a number in SI units, not {value!r}")
            if not value > 0:
                raise ValueError(f"the limit {name} must be positive, not {value}")
        if IN_DEGREES <= self.angular_velocity < math.inf:
            fast, turns = f"{self.angular_velocity:g}", f"{self.angular_velocity / math.tau:.1f}"
            message = f"the limit angular_velocity is in rad/s, and {fast} are {turns} turns a second"
            raise ValueError(f"{message}: {fast} degrees a second are math.radians({fast}); math.inf is no limit")
        # By name a choice reads as well, and compared as a text it would be the other one: to clamp, not to refuse.
        object.__setattr__(self, "over", named(OverLimit, "over", self.over))
        if not isinstance(self.over_each, Mapping):
            raise TypeError(
                f"over_each is a dictionary by limit, as {{'distance': 'clamp'}}, not {self.over_each!r:.80}"
            )
        if unknown := [name for name in self.over_each if name not in _BOUNDS]:
            raise ValueError(f"over_each is by limit: there is {', '.join(_BOUNDS)}, not {unknown[0]!r:.80}")
        each = {name: named(OverLimit, f"over_each[{name!r}]", over) for name, over in self.over_each.items()}
        object.__setattr__(self, "over_each", each)

    def check(self, action: Action) -> Checked:
        """What of ``action`` may be done. A velocity that is cut down keeps its distance and takes longer."""
        for name, value in _numbers(action):
            if not math.isfinite(value):
                return Checked(action, f"{action.type}: {name} is {value}, not a number to drive by", "finite")
        if wrong := _contradiction(action):
            return Checked(action, wrong, "duration")
        if isinstance(action, Move):
            return self._move(action)
        if isinstance(action, Turn):
            return self._turn(action)
        return Checked(action)

    def _move(self, move: Move) -> Checked:
        if move.distance > 0 and move.linear_velocity == 0:
            return Checked(move, f"move: {move.distance:g} m cannot be covered at 0 m/s", "linear_velocity")

        def within(speed: float, distance: float, duration: float) -> Move:
            velocity = math.copysign(speed, move.linear_velocity)
            return replace(move, linear_velocity=velocity, distance=distance, duration=duration)

        speed = _Asked("linear_velocity", abs(move.linear_velocity), "m/s")
        return self._motion(move, speed, _Asked("distance", move.distance, "m"), within)

    def _turn(self, turn: Turn) -> Checked:
        if turn.angle != 0 and turn.angular_velocity == 0:
            return Checked(turn, f"turn: {turn.angle:g} rad cannot be turned at 0 rad/s", "angular_velocity")

        def within(speed: float, angle: float, duration: float) -> Turn:
            sign = math.copysign(1.0, turn.angle)
            return replace(turn, angle=sign * angle, angular_velocity=sign * speed, duration=duration)

        speed = _Asked("angular_velocity", abs(turn.angular_velocity), "rad/s")
        return self._motion(turn, speed, _Asked("angle", abs(turn.angle), "rad"), within)

    def _motion(
        self, motion: Move | Turn, speed: _Asked, way: _Asked, within: Callable[[float, float, float], Move | Turn]
    ) -> Checked:
        """What of a move or turn may be done; ``within`` makes it anew of a speed, a way and a duration."""
        notes: list[str] = []
        for asked in (speed, way):
            refused = self._over(asked, notes)
            if refused:
                return Checked(motion, refused, asked.limit)
        fast, far = (min(asked.value, getattr(self, asked.limit)) for asked in (speed, way))
        duration = far / fast if fast else 0.0
        if not notes and math.isclose(duration, motion.duration, rel_tol=1e-9):
            duration = motion.duration
        refused = self._over(_Asked("duration", duration, "s"), notes)
        if refused:
            return Checked(motion, refused, "duration")
        if duration > self.duration:
            duration, far = self.duration, fast * self.duration
        if notes or duration != motion.duration:
            motion = within(fast, far, duration)
        return Checked(motion, clamped=tuple(notes))

    def _over(self, asked: _Asked, notes: list[str]) -> str:
        limit, value, unit = asked
        bound: float = getattr(self, limit)
        # A value that was computed from others may be a last bit above the limit it was made for.
        if value <= bound * (1 + 1e-9):
            return ""
        text = f"{limit.replace('_', ' ')} {value:.4g} {unit} is over this robot's limit of {bound:.4g} {unit}"
        if self.over_each.get(limit, self.over) is OverLimit.REFUSE:
            return text
        notes.append(f"{limit.replace('_', ' ')} cut from {value:.4g} to {bound:.4g} {unit}")
        return ""


_NAMES = (
    "linear_velocity",
    "angular_velocity",
    "linear_acceleration",
    "angular_acceleration",
    "distance",
    "angle",
    "duration",
    "task_duration",
)
_OPTIONAL = ("linear_deceleration", "angular_deceleration")
_BOUNDS = ("linear_velocity", "angular_velocity", "distance", "angle", "duration")
"""Limits of what is asked for, which can be refused or cut down."""
AS_ROUNDED = 0.01
"""Part of its duration, and s, by which an action's may differ from what its other numbers make: JSON is rounded."""


def _contradiction(action: Action) -> str:
    """Why the numbers of a motion cannot all be meant; empty: they can. To keep its duration would drive another way
    than the one that was looked at."""
    if isinstance(action, Move):
        amount, speed, unit = action.distance, abs(action.linear_velocity), "m"
    elif isinstance(action, Turn):
        amount, speed, unit = abs(action.angle), abs(action.angular_velocity), "rad"
    else:
        return ""
    takes = amount / speed if speed else action.duration
    if math.isclose(takes, action.duration, rel_tol=AS_ROUNDED, abs_tol=AS_ROUNDED):
        return ""
    return f"{action.type}: {amount:g} {unit} at {speed:g} {unit}/s take {takes:.4g} s, not {action.duration:g} s"


def _numbers(action: Any) -> list[tuple[str, float]]:
    # Actions refuse NaN when they are made; this is for what was made in some other way.
    if isinstance(action, Move):
        names: tuple[str, ...] = ("linear_velocity", "distance", "duration")
    elif isinstance(action, Turn):
        names = ("angle", "angular_velocity", "duration")
    elif isinstance(action, Navigate):
        names = ("x", "y", "yaw")
    else:
        return []
    return [(name, getattr(action, name)) for name in names]
