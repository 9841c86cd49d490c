"""Speed over time in closed form: ramp up, cruise, ramp down.

A profile is computed once, as a few pieces of constant acceleration, and then asked for its position at any time.
Nothing is added up from tick to tick, so a tick that comes late, or not at all, costs nothing.
All values are along one axis: m, m/s and m/s^2 for driving, rad, rad/s and rad/s^2 for turning.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

__all__ = ["Profile", "brake", "for_distance", "for_duration"]


@dataclass(frozen=True, slots=True)
class _Piece:
    start: float
    """s since the beginning of the profile"""
    length: float
    """s"""
    position: float
    """where it begins"""
    speed: float
    """at its beginning"""
    acceleration: float


@dataclass(frozen=True, slots=True)
class Profile:
    """A motion along one axis that begins at position 0 and ends at rest."""

    pieces: tuple[_Piece, ...]
    duration: float
    """s"""
    distance: float
    """Position at the end; signed."""

    def position(self, elapsed: float) -> float:
        """Where the motion is ``elapsed`` s after its beginning."""
        if elapsed >= self.duration:
            return self.distance
        if elapsed <= 0:
            return 0.0
        piece = self._piece(elapsed)
        t = elapsed - piece.start
        return piece.position + piece.speed * t + 0.5 * piece.acceleration * t * t

    def speed(self, elapsed: float) -> float:
        """The speed ``elapsed`` s after the beginning; 0 from the end on."""
        if elapsed >= self.duration:
            return 0.0
        piece = self._piece(max(elapsed, 0.0))
        return piece.speed + piece.acceleration * (max(elapsed, 0.0) - piece.start)

    def braking(self, elapsed: float) -> bool:
        """Whether only the last ramp down is left."""
        last = self.pieces[-1]
        return last.acceleration * last.speed < 0.0 and elapsed >= last.start - 1e-9

    def mean_speed(self, begin: float, end: float) -> float:
        """The constant speed that covers between two times what the profile covers: what a tick writes."""
        if end <= begin:
            return self.speed(begin)
        first = self._piece(begin) if 0 <= begin < self.duration else None
        if first is not None and first.acceleration == 0.0 and end <= first.start + first.length:
            # The same number at every tick of the cruise; the difference of two positions would carry rounding.
            return first.speed
        return (self.position(end) - self.position(begin)) / (end - begin)

    def _piece(self, elapsed: float) -> _Piece:
        for piece in reversed(self.pieces):
            if piece.start <= elapsed:
                return piece
        return self.pieces[0]


class _Builder:
    """Puts a profile together, in the direction of the motion: speeds that are not negative.

    Args:
        initial: present speed, signed. What goes against ``direction`` is braked first.
        direction: any number with the sign of the motion.
        down: rate of the ramps down.
    """

    def __init__(self, initial: float, direction: float, down: float) -> None:
        self.pieces: list[_Piece] = []
        self.time = 0.0
        self.position = 0.0
        self.sign = math.copysign(1.0, direction)
        self.speed = initial * self.sign
        self._down = down
        if self.speed < 0.0:
            self.rest()

    def rest(self) -> None:
        """Brake."""
        self.ramp(0.0, self._down)

    def ramp(self, to: float, rate: float) -> None:
        """Change the speed to ``to`` at ``rate`` (positive; infinite: at once)."""
        change = to - self.speed
        if change != 0.0 and math.isfinite(rate):
            length = abs(change) / rate
            self._add(length, math.copysign(rate, change))
        self.speed = to

    def cruise(self, speed: float, length: float, up: float) -> None:
        """Come to ``speed``, hold it for ``length`` s, and brake."""
        self.ramp(speed, up if self.speed < speed else self._down)
        if length > 0.0:
            self._add(length, 0.0)
        self.rest()

    def _add(self, length: float, acceleration: float) -> None:
        self.pieces.append(_Piece(self.time, length, self.position, self.speed, acceleration))
        self.position += self.speed * length + 0.5 * acceleration * length * length
        self.time += length

    def profile(self, distance: float | None = None, duration: float | None = None) -> Profile:
        pieces = tuple(
            _Piece(p.start, p.length, self.sign * p.position, self.sign * p.speed, self.sign * p.acceleration)
            for p in self.pieces
        ) or (_Piece(0.0, 0.0, 0.0, 0.0, 0.0),)
        # The end is what was asked for, not what the additions above came to in their last bit.
        return Profile(
            pieces,
            self.time if duration is None else duration,
            self.sign * (self.position if distance is None else distance),
        )


def for_distance(
    distance: float,
    speed: float,
    acceleration: float = math.inf,
    deceleration: float | None = None,
    initial: float = 0.0,
) -> Profile:
    """Cover ``distance`` exactly, at ``speed`` between the ramps; it takes longer than without ramps.

    Args:
        distance: how far, not negative; the direction is the sign of ``speed``.
        speed: cruise speed, not zero.
        acceleration: of the ramp up, positive; infinite for none.
        deceleration: of the ramp down; None for the same.
        initial: present speed, signed. A motion in the other direction is braked first, and the way that this takes
            is made good. If braking alone takes more than ``distance``, the profile brakes and ends further on: a
            robot does not drive back because it was too fast.
    """
    down = acceleration if deceleration is None else deceleration
    build = _Builder(initial, speed, down)
    left = distance - build.position
    braking = _way(build.speed, down)
    if left <= braking:
        build.rest()
        return build.profile(distance=None if braking > left else distance)
    cruise = abs(speed)
    if build.speed < cruise:
        top = _top_for_distance(left, build.speed, acceleration, down)
        cruise = min(cruise, top)
        ramps = _way(cruise, acceleration) - _way(build.speed, acceleration) + _way(cruise, down)
    else:
        ramps = _way(build.speed, down)
    build.cruise(cruise, (left - ramps) / cruise, acceleration)
    return build.profile(distance=distance)


def for_duration(
    duration: float,
    speed: float,
    acceleration: float = math.inf,
    deceleration: float | None = None,
    initial: float = 0.0,
) -> Profile:
    """Be in motion for ``duration`` s, ramps included, at ``speed`` or as near to it as the ramps allow.

    Arguments are those of :func:`for_distance`. Only where braking from ``initial`` takes longer than ``duration``
    does the motion end later.
    """
    down = acceleration if deceleration is None else deceleration
    build = _Builder(initial, speed, down)
    left = duration - build.time
    braking = build.speed / down
    if left <= braking:
        build.rest()
        return build.profile(duration=duration if build.time <= duration else None)
    cruise = abs(speed)
    if build.speed < cruise:
        # (top - present) / up + top / down = left
        rates = 1.0 / acceleration + 1.0 / down
        if rates > 0.0:
            cruise = min(cruise, (left + build.speed / acceleration) / rates)
        ramps = (cruise - build.speed) / acceleration + cruise / down
    else:
        ramps = braking
    build.cruise(cruise, left - ramps, acceleration)
    return build.profile(duration=duration)


def brake(initial: float, deceleration: float = math.inf) -> Profile:
    """From ``initial`` to rest."""
    build = _Builder(initial, initial, deceleration)
    build.rest()
    return build.profile()


def _way(speed: float, rate: float) -> float:
    """What is covered between rest and ``speed`` at ``rate``: v^2 / 2a."""
    return speed * speed / (2.0 * rate)


def _top_for_distance(distance: float, initial: float, up: float, down: float) -> float:
    """The highest speed from which one can still brake within ``distance`` when one begins at ``initial``."""
    halves = 1.0 / (2.0 * up) + 1.0 / (2.0 * down)
    if halves == 0.0:
        return math.inf
    return math.sqrt((distance + _way(initial, up)) / halves)
