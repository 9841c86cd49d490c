"""A move or turn, and the follower that writes its velocity, tick by tick, to a robot.

The follower is the same in the executor's own thread, in the guardian process and on a virtual clock: it is told the
time and says when it wants to be called next. It holds no lock and starts no thread; its owner does.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from enum import StrEnum
from numbers import Integral
from typing import Any, Protocol

from intent_engine.actions import Action, Move, Turn
from intent_engine.errors import RobotError
from intent_engine.execution.limits import Limits
from intent_engine.execution.profile import Profile, brake, for_distance, for_duration
from intent_engine.values import check_number

__all__ = ["Ended", "Follower", "Keep", "Motion", "Rates", "Travel", "VelocitySink", "ramps", "time_for"]


class VelocitySink(Protocol):
    """The two methods of a robot that its velocity needs."""

    def velocity(self, linear: float, angular: float, valid_for: float) -> None: ...

    def stop(self) -> None: ...


class Keep(StrEnum):
    """What of a motion is kept when ramps make it impossible to keep both."""

    DISTANCE = "distance"
    """Distance (or angle); the motion takes longer."""
    DURATION = "duration"
    """Duration, ramps included; the motion covers less."""


@dataclass(frozen=True, slots=True)
class Motion:
    """A straight drive or a turn on the spot."""

    turning: bool
    speed: float
    """m/s or rad/s, signed, not zero"""
    amount: float
    """m or rad, not negative"""
    duration: float
    """s"""
    keep: Keep = Keep.DISTANCE

    @staticmethod
    def of(action: Action, keep: Keep = Keep.DISTANCE) -> Motion | None:
        """The motion of a move or turn; None if there is nothing to drive."""
        if isinstance(action, Move):
            motion = Motion(False, action.linear_velocity, action.distance, action.duration, keep)
        elif isinstance(action, Turn):
            motion = Motion(True, action.angular_velocity, abs(action.angle), action.duration, keep)
        else:
            return None
        return motion if motion.speed and motion.amount and motion.duration else None

    def same_way(self, other: Motion) -> bool:
        """Whether both drive, or both turn, in the same direction."""
        return self.turning is other.turning and (self.speed > 0) is (other.speed > 0)

    def rest(self, travel: Travel) -> Motion | None:
        """What is left of it after ``travel``; None if nothing is."""
        amount = self.amount - travel.amount * math.copysign(1.0, self.speed)
        duration = self.duration - travel.elapsed
        if (amount if self.keep is Keep.DISTANCE else duration) <= 1e-9:
            return None
        return replace(self, amount=max(amount, 0.0), duration=max(duration, 0.0))

    def to_json(self) -> list[Any]:
        return [self.turning, self.speed, self.amount, self.duration, self.keep.value]

    @staticmethod
    def from_json(data: list[Any]) -> Motion:
        return Motion(bool(data[0]), float(data[1]), float(data[2]), float(data[3]), Keep(data[4]))


@dataclass(frozen=True, slots=True)
class Rates:
    """How a robot wants its velocity written."""

    rate: float = 20.0
    """Hz"""
    valid_for: float = 0.3
    """s: how long a written velocity holds when no other follows"""
    zeros: int = 3
    """How many zeros end a motion; after them the loop is silent, so that other sources can drive."""

    def __post_init__(self) -> None:
        for name, unit in (("rate", "Hz"), ("valid_for", "s"), ("zeros", "zeros")):
            check_number(name, getattr(self, name), unit)
        if not isinstance(self.zeros, Integral):
            raise TypeError(f"zeros is a whole number, not {self.zeros!r}")
        if not (0 < self.rate <= 1000 and self.valid_for > 0 and self.zeros >= 1):
            raise ValueError(f"impossible rates: {self}")
        if self.valid_for <= 1.0 / self.rate:
            raise ValueError(
                f"a velocity valid for {self.valid_for} s runs out before the next one at {self.rate} Hz is written"
            )

    @property
    def period(self) -> float:
        """s"""
        return 1.0 / self.rate


@dataclass(frozen=True, slots=True)
class Travel:
    """How far a motion has come by what was written."""

    amount: float = 0.0
    """m or rad, signed"""
    elapsed: float = 0.0
    """s"""
    time_left: float = 0.0
    """s"""
    braking: bool = False
    """Only the last ramp is left: no brake would end it sooner."""


@dataclass(frozen=True, slots=True)
class Ended:
    """A motion came to its end (the first of its zeros is written)."""

    at: float
    """s on the clock"""
    travel: Travel
    late: float
    """s after the planned end"""


def time_for(motion: Motion, limits: Limits, linear: float, angular: float) -> float:
    """How long a motion takes, in s, until everything stands.

    Args:
        motion: what is to be done.
        limits: whose accelerations the ramps have.
        linear, angular: m/s and rad/s at which it begins.
    """
    main, other = _profiles(motion, ramps(limits), linear, angular)
    return max(main.duration, other.duration if other is not None else 0.0)


class Follower:
    """Writes the velocity of one motion at a time: accelerates, cruises, brakes, and then is silent.

    Life cycle: idle -> ``start`` -> (``step`` whenever ``due``) -> ended, two more zeros -> idle. ``start`` while a
    motion runs replaces it, from the present velocity. ``halt`` ends everything with a zero, at once, from anywhere.
    """

    def __init__(self, sink: VelocitySink, limits: Limits, rates: Rates) -> None:
        self._sink = sink
        self._rates = rates
        self._rate_of = ramps(limits)
        self._motion: Motion | None = None
        self._main: Profile | None = None
        self._other: Profile | None = None
        """What brakes the other axis, when a turn replaces a drive or the other way round."""
        self._started = 0.0
        """Beginning of the present profiles"""
        self._began = 0.0
        """Beginning of the motion"""
        self._written = (0.0, 0.0)
        self._written_at = -math.inf
        self._travelled = 0.0
        self._zeros_left = 0
        self._next: float | None = None

    @property
    def moving(self) -> bool:
        return self._main is not None

    @property
    def written(self) -> tuple[float, float]:
        """The last velocity that was written: m/s, rad/s."""
        return self._written

    def due(self) -> float | None:
        """When :meth:`step` has something to do."""
        return self._next

    def start(self, motion: Motion, now: float) -> float:
        """Begin a motion at the present velocity; returns its planned end. The first write is the next ``step``."""
        linear, angular = self._present(now)
        self._motion, self._began = motion, now
        self._travelled = 0.0
        self._plan(motion, linear, angular, now)
        self._next = now
        return self._end

    def brake(self, now: float) -> Travel:
        """Come to rest with the robot's deceleration. Returns how far the motion had come.

        In its last ramp a motion is left alone (the travel's ``braking`` says so): it cannot end sooner.
        """
        travel = self.travel(now)
        if travel.braking:
            return travel
        linear, angular = self._present(now)
        # What is covered from now on is still of the axis that the motion was on.
        turning = self._motion is not None and self._motion.turning
        main, other = (angular, linear) if turning else (linear, angular)
        self._motion = Motion(turning, math.copysign(1.0, main), 0.0, 0.0)
        self._main = brake(main, self._rate_of[turning][1])
        self._other = brake(other, self._rate_of[not turning][1])
        self._started = self._began = now
        self._travelled = 0.0
        self._zeros_left = self._rates.zeros
        self._next = now
        return travel

    def halt(self, now: float, write: bool = True) -> Travel:
        """Zero, now. Returns how far the motion had come.

        Args:
            write: False where the caller has just stopped the robot itself; the zeros that follow are written anyway.
        """
        travel = self.travel(now)
        self._main = self._other = self._motion = None
        self._written, self._written_at = (0.0, 0.0), now
        self._zeros_left = self._rates.zeros - 1
        self._next = now + self._rates.period if self._zeros_left else None
        if write:
            self._sink.velocity(0.0, 0.0, self._rates.valid_for)
        return travel

    def silence(self) -> None:
        """Write no more zeros: something else (the robot's own navigation) drives now."""
        if not self.moving:
            self._zeros_left, self._next = 0, None

    def travel(self, now: float) -> Travel:
        """How far the present motion has come by now."""
        if self._main is None:
            return Travel()
        left = max(self._end - now, 0.0)
        return Travel(
            self._travelled + self._since_write(now), now - self._began, left, self._main.braking(now - self._started)
        )

    def step(self, now: float) -> Ended | None:
        """Write what is due at ``now``. Returns the end of the motion when it has come.

        Raises:
            Exception: whatever the robot raises.
        """
        if self._next is None or now < self._next:
            return None
        if self._main is None:
            self._zeros_left -= 1
            self._next = now + self._rates.period if self._zeros_left > 0 else None
            self._sink.velocity(0.0, 0.0, self._rates.valid_for)
            return None
        return self._tick(now)

    # -- inside ------------------------------------------------------------------------------------------------------

    @property
    def _end(self) -> float:
        """When the present profiles end; s."""
        return self._started + max(each.duration for each in (self._main, self._other) if each is not None)

    def _plan(self, motion: Motion, linear: float, angular: float, now: float) -> None:
        self._main, self._other = _profiles(motion, self._rate_of, linear, angular)
        self._started = now
        self._zeros_left = self._rates.zeros

    def _since_write(self, now: float) -> float:
        """What the last written velocity has covered since; nothing beyond the time that it is valid for."""
        turning = self._motion.turning if self._motion is not None else False
        begin = max(self._written_at, self._began)
        end = min(now, self._written_at + self._rates.valid_for)
        return self._written[turning] * (end - begin) if end > begin else 0.0

    def _present(self, now: float) -> tuple[float, float]:
        """The velocity that the robot has now, by what was written to it.

        That is the profile's own speed and not the last write, which is the mean of its tick: a brake that begins
        here then ends where the profile would have.
        """
        if self._main is None or now - self._written_at > self._rates.valid_for:
            return (0.0, 0.0)
        if self._written_at < self._started:
            return self._written  # planned, not begun
        main = self._main.speed(now - self._started)
        other = self._other.speed(now - self._started) if self._other is not None else 0.0
        turning = self._motion is not None and self._motion.turning
        return (other, main) if turning else (main, other)

    def _tick(self, now: float) -> Ended | None:
        assert self._main is not None
        period = self._rates.period
        late_tick = self._next is not None and now - self._next > period and self._written_at >= self._started
        self._travelled += self._since_write(now)
        motion = self._motion
        if late_tick and motion is not None and motion.amount:
            # Whole ticks were missed (a frozen machine): plan again from what was really covered and driven.
            self._replan(motion, now)
        end = self._end
        if now >= end - 1e-12:
            return self._finish(now, end)
        # Ticks stand at whole periods after the beginning, whatever the delay of this one.
        count = math.floor((now - self._started) / period + 1e-6) + 1
        following = min(self._started + count * period, end)
        self._next = following
        begin, until = now - self._started, following - self._started
        main = self._main.mean_speed(begin, until)
        other = self._other.mean_speed(begin, until) if self._other is not None else 0.0
        turning = motion is not None and motion.turning
        self._write(*((other, main) if turning else (main, other)), now)
        return None

    def _replan(self, motion: Motion, now: float) -> None:
        alive = now - self._written_at <= self._rates.valid_for
        linear, angular = self._written if alive else (0.0, 0.0)
        rest = motion.rest(Travel(self._travelled, now - self._began))
        if rest is not None:
            self._plan(rest, linear, angular, now)

    def _finish(self, now: float, end: float) -> Ended:
        travel = Travel(self._travelled, now - self._began, 0.0)
        self._main = self._other = self._motion = None
        self._zeros_left -= 1
        self._next = now + self._rates.period if self._zeros_left > 0 else None
        self._written, self._written_at = (0.0, 0.0), now
        self._sink.velocity(0.0, 0.0, self._rates.valid_for)
        return Ended(now, travel, now - end)

    def _write(self, linear: float, angular: float, now: float) -> None:
        if not (math.isfinite(linear) and math.isfinite(angular)):
            raise RobotError(f"a velocity of {linear} m/s and {angular} rad/s was about to be written")
        self._sink.velocity(linear, angular, self._rates.valid_for)
        self._written, self._written_at = (linear, angular), now


_Ramps = dict[bool, tuple[float, float]]
"""Whether it turns -> how fast a speed grows, and how fast it falls: m/s^2 or rad/s^2."""


def ramps(limits: Limits) -> _Ramps:
    """The ramps of a robot, by whether it turns."""
    return {
        False: (limits.linear_acceleration, limits.linear_deceleration or limits.linear_acceleration),
        True: (limits.angular_acceleration, limits.angular_deceleration or limits.angular_acceleration),
    }


def _profiles(motion: Motion, rates: _Ramps, linear: float, angular: float) -> tuple[Profile, Profile | None]:
    """What a motion does on its own axis from present speeds, and what brakes the other, if that moves."""
    main, other = (angular, linear) if motion.turning else (linear, angular)
    up, down = rates[motion.turning]
    if motion.keep is Keep.DISTANCE:
        own = for_distance(motion.amount, motion.speed, up, down, main)
    else:
        own = for_duration(motion.duration, motion.speed, up, down, main)
    return own, brake(other, rates[not motion.turning][1]) if other else None
