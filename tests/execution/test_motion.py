"""The follower: what it writes, tick by tick, also when ticks come late."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.actions import Move, Turn
from intent_engine.errors import RobotError
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Ended, Follower, Keep, Motion, Rates, Travel, time_for

RATES = Rates(rate=20.0, valid_for=0.3)
LIMITS = Limits(linear_acceleration=0.5, angular_acceleration=1.0)


class World:
    """Integrates what is written, as a base with a command timeout does."""

    def __init__(self) -> None:
        self.now = 0.0
        self.x = 0.0
        self.speed = 0.0
        self.until = 0.0
        self.log: list[tuple[float, float, float]] = []

    def advance(self, to: float) -> None:
        self.x += self.speed * max(min(to, self.until) - self.now, 0.0)
        self.now = to
        if to >= self.until:
            self.speed = 0.0

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        self.log.append((self.now, linear, angular))
        self.speed, self.until = linear, self.now + valid_for

    def stop(self) -> None:
        self.velocity(0.0, 0.0, 0.0)


def follow(follower: Follower, world: World, lateness) -> Ended | None:
    """Run to the end; ``lateness`` says how late each tick is."""
    ended = None
    while (due := follower.due()) is not None:
        world.advance(max(due + lateness(), world.now))
        ended = follower.step(world.now) or ended
    return ended


@given(st.sampled_from([-0.8, -0.1, 0.3, 1.0]), st.floats(0.01, 5.0), st.booleans())
def test_on_time_the_distance_is_exact_whatever_the_ramps(speed, distance, ramps):
    world = World()
    follower = Follower(world, LIMITS if ramps else Limits(), RATES)
    follower.start(Motion(False, speed, distance, distance / abs(speed)), 0.0)
    ended = follow(follower, world, lambda: 0.0)
    assert ended is not None
    assert world.x == pytest.approx(math.copysign(distance, speed), abs=1e-9)
    assert ended.travel.amount == pytest.approx(world.x, abs=1e-9)
    assert [entry[1] for entry in world.log[-3:]] == [0.0] * 3
    assert follower.due() is None


def assert_gentle(world: World) -> None:
    """No write asks for more than the acceleration, counted from the write before it."""
    for (before, slow, _), (at, fast, _) in pairwise(world.log):
        assert abs(fast) <= 0.5 + 1e-12
        if at - before > RATES.valid_for:
            slow = 0.0
        if fast:
            assert abs(fast - slow) <= 0.5 * max(min(at - before, RATES.valid_for), RATES.period) + 1e-9


@given(st.floats(0.2, 4.0), st.randoms(use_true_random=False), st.floats(0.0, 0.04))
def test_small_delays_cost_little_and_the_account_is_true(distance, chance, most):
    world = World()
    follower = Follower(world, LIMITS, RATES)
    follower.start(Motion(False, 0.5, distance, distance / 0.5), 0.0)
    ended = follow(follower, world, lambda: chance.uniform(0.0, most))
    assert ended is not None
    assert ended.travel.amount == pytest.approx(world.x, abs=1e-9)
    assert world.x == pytest.approx(distance, abs=0.03)
    assert_gentle(world)


@pytest.mark.parametrize("freeze", [0.08, 0.25, 0.9])
@pytest.mark.parametrize("keep", list(Keep))
@pytest.mark.parametrize("at", [0.3, 1.5, 3.0])
def test_a_freeze_is_made_good_where_it_still_can_be(at, keep, freeze):
    world = World()
    follower = Follower(world, LIMITS, RATES)
    follower.start(Motion(False, 0.5, 2.0, 4.0, keep), 0.0)
    frozen = False

    def lateness() -> float:
        nonlocal frozen
        if not frozen and world.now >= at:
            frozen = True
            return freeze
        return 0.0

    ended = follow(follower, world, lateness)
    assert ended is not None
    assert_gentle(world)
    if keep is Keep.DISTANCE:
        assert world.x == pytest.approx(2.0, abs=1e-9)
    elif at < 3.0:
        assert ended.at == pytest.approx(4.0)
    else:
        # Frozen when the last ramp should have begun: braking takes what it takes.
        assert 4.0 <= ended.at <= 4.0 + freeze + 2 * RATES.period


def test_a_turn_that_replaces_a_drive_brakes_it_meanwhile():
    world = World()
    follower = Follower(world, LIMITS, RATES)
    follower.start(Motion(False, 0.5, 5.0, 10.0), 0.0)
    while world.now < 2.0:
        world.advance(follower.due() or 0.0)
        follower.step(world.now)
    follower.start(Motion(True, 0.5, 1.0, 2.0), world.now)
    begin = len(world.log)
    follow(follower, world, lambda: 0.0)
    linears = [linear for _, linear, _ in world.log[begin:]]
    assert linears == sorted(linears, reverse=True)
    assert linears[0] > 0.4
    turned = sum(w * (b - a) for (a, _, w), (b, _, _) in zip(world.log[begin:], world.log[begin + 1 :], strict=False))
    assert turned == pytest.approx(1.0, abs=1e-9)


def turning_into_a_drive(limits: Limits) -> tuple[World, Follower, float]:
    """A turn of 1 rad/s, and a drive of 1 m that has just taken its place; when that is to end."""
    world = World()
    follower = Follower(world, limits, RATES)
    follower.start(Motion(True, 1.0, 30.0, 30.0), 0.0)
    while world.now < 4.0:
        world.advance(follower.due() or 0.0)
        follower.step(world.now)
    return world, follower, follower.start(Motion(False, 0.5, 1.0, 2.0), world.now)


@pytest.mark.parametrize("angular", [10.0, 0.5, 0.1])
def test_the_end_of_a_motion_is_known_when_it_begins(angular):
    """It is over when everything stands: who takes it for late before that ends a goal of a robot that moves."""
    limits = Limits(linear_acceleration=5.0, angular_acceleration=1.0, angular_deceleration=angular)
    world, follower, planned = turning_into_a_drive(limits)
    assert planned == pytest.approx(world.now + time_for(Motion(False, 0.5, 1.0, 2.0), limits, 0.0, 1.0))
    ended = follow(follower, world, lambda: 0.0)
    assert ended is not None
    assert ended.at == pytest.approx(planned)


@pytest.mark.parametrize("angular", [10.0, 0.5, 0.1])
def test_what_a_brake_covers_is_of_the_axis_of_the_motion(angular):
    limits = Limits(linear_acceleration=5.0, angular_acceleration=1.0, angular_deceleration=angular)
    world, follower, _ = turning_into_a_drive(limits)
    before, until = world.x, world.now + 0.5
    while world.now < until:
        world.advance(follower.due() or 0.0)
        follower.step(world.now)
    travel = follower.brake(world.now)
    ended = follow(follower, world, lambda: 0.0)
    assert ended is not None
    assert travel.amount + ended.travel.amount == pytest.approx(world.x - before)


def test_halt_is_one_zero_now_and_two_more():
    world = World()
    follower = Follower(world, LIMITS, RATES)
    follower.start(Motion(False, 0.5, 5.0, 10.0), 0.0)
    for _ in range(20):
        world.advance(follower.due() or 0.0)
        follower.step(world.now)
    begin = len(world.log)
    world.advance(world.now + 0.02)
    travel = follower.halt(world.now)
    assert travel.amount == pytest.approx(world.x)
    assert follow(follower, world, lambda: 0.0) is None
    assert [entry[1:] for entry in world.log[begin:]] == [(0.0, 0.0)] * 3


def test_silence_ends_the_zeros_so_that_others_can_drive():
    world = World()
    follower = Follower(world, LIMITS, RATES)
    follower.halt(0.0)
    follower.silence()
    assert follower.due() is None


def test_a_velocity_that_is_no_number_never_leaves():
    follower = Follower(World(), Limits(), RATES)
    with pytest.raises(RobotError, match="nan"):
        follower._write(math.nan, 0.0, 0.0)


@pytest.mark.parametrize(
    ("action", "expected"),
    [
        (Move(-0.5, 1.0, 2.0), Motion(False, -0.5, 1.0, 2.0)),
        (Turn(-1.0, -0.5, 2.0), Motion(True, -0.5, 1.0, 2.0)),
        (Move(0.5, 0.0, 0.0), None),
        (Turn(0.0, 0.0, 0.0), None),
    ],
)
def test_a_motion_is_what_an_action_says(action, expected):
    assert Motion.of(action) == expected
    if expected is not None:
        assert Motion.from_json(expected.to_json()) == expected


def test_the_rest_of_a_motion():
    motion = Motion(False, -0.5, 1.0, 2.0)
    assert motion.rest(Travel(-0.4, 0.9)) == Motion(False, -0.5, pytest.approx(0.6), pytest.approx(1.1))
    assert motion.rest(Travel(-1.0, 2.0)) is None
    timed = Motion(False, 0.5, 1.0, 2.0, Keep.DURATION)
    assert timed.rest(Travel(0.1, 2.0)) is None


@pytest.mark.parametrize("wrong", [{"rate": 0.0}, {"rate": 2.0}, {"valid_for": 0.0}, {"zeros": 0}, {"rate": 10**400}])
def test_rates_that_cannot_work_are_refused(wrong):
    with pytest.raises(ValueError, match=r"rates|runs out|beyond"):
        Rates(**wrong)
