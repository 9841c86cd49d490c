"""Limits: refuse or clamp, by name; never a number that is none."""

from __future__ import annotations

import math
from dataclasses import fields

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.actions import Custom, Move, Navigate, Turn
from intent_engine.execution.limits import Limits, OverLimit

LIMITS = Limits(linear_velocity=0.5, angular_velocity=1.0, distance=10.0, angle=7.0, duration=60.0)


@pytest.mark.parametrize(
    ("action", "limit"),
    [
        (Move(0.6, 1.0, 1 / 0.6), "linear_velocity"),
        (Move(-0.6, 1.0, 1 / 0.6), "linear_velocity"),
        (Move(0.5, 11.0, 22.0), "distance"),
        (Move(0.1, 9.0, 90.0), "duration"),
        (Move(0.0, 1.0, 0.0), "linear_velocity"),
        (Turn(1.0, 1.1, 1 / 1.1), "angular_velocity"),
        (Turn(-8.0, -1.0, 8.0), "angle"),
        (Turn(6.5, 0.1, 65.0), "duration"),
        (Turn(1.0, 0.0, 0.0), "angular_velocity"),
    ],
)
def test_what_is_beyond_a_limit_is_refused_with_its_name(action, limit):
    checked = LIMITS.check(action)
    assert checked.limit == limit
    assert checked.refused


def forged(kind, **values):
    """An action with numbers that its own constructor would refuse."""
    action = object.__new__(kind)
    for field in fields(kind):
        object.__setattr__(action, field.name, values.get(field.name, 1.0))
    return action


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize(
    ("kind", "name"), [(Move, "linear_velocity"), (Move, "distance"), (Turn, "angle"), (Navigate, "yaw")]
)
def test_what_is_no_number_is_refused_by_every_robot(kind, name, bad):
    checked = Limits(over=OverLimit.CLAMP).check(forged(kind, **{name: bad}))
    assert checked.limit == "finite"


@given(st.floats(-5, 5).filter(lambda v: abs(v) > 1e-3), st.floats(0, 100))
def test_a_clamped_move_is_within_every_limit(speed, distance):
    clamp = Limits(linear_velocity=0.5, distance=10.0, duration=15.0, over=OverLimit.CLAMP)
    asked = Move(speed, distance, distance / abs(speed))
    checked = clamp.check(asked)
    done = checked.action
    assert isinstance(done, Move)
    assert not checked.refused
    assert abs(done.linear_velocity) <= 0.5
    assert done.distance <= 10.0
    assert done.duration <= 15.0 * (1 + 1e-9)
    assert done.duration == pytest.approx(done.distance / abs(done.linear_velocity))
    assert math.copysign(1, done.linear_velocity) == math.copysign(1, speed)
    assert (done == asked) == (not checked.clamped)


def test_one_limit_may_clamp_where_the_others_refuse():
    limits = Limits(linear_velocity=0.5, distance=1.0, over_each={"linear_velocity": OverLimit.CLAMP})
    assert limits.check(Move(1.0, 0.5, 0.5)).action == Move(0.5, 0.5, 1.0)
    assert limits.check(Move(1.0, 2.0, 2.0)).limit == "distance"


def test_other_actions_are_not_the_business_of_limits():
    assert LIMITS.check(Custom("wave")).refused == ""


@pytest.mark.parametrize("value", [0.0, -1.0, math.nan])
def test_a_limit_is_a_positive_number(value):
    with pytest.raises(ValueError, match="linear_velocity"):
        Limits(linear_velocity=value)


@pytest.mark.parametrize("name", ["refuse", OverLimit.REFUSE])
def test_what_happens_beyond_a_limit_may_be_named(name):
    fast = Move(1.0, 0.5, 0.5)
    assert Limits(linear_velocity=0.5, over=name).check(fast).refused
    assert Limits(linear_velocity=0.5, over="clamp", over_each={"linear_velocity": name}).check(fast).refused
    assert Limits(linear_velocity=0.5, over="clamp").check(fast).clamped


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"over": "refuze"}, "over is one of 'refuse', 'clamp', not 'refuze'"),
        ({"over": None}, "over is one of"),
        ({"over_each": {"distance": "clmap"}}, r"over_each\['distance'\] is one of 'refuse', 'clamp', not 'clmap'"),
        ({"over_each": {"distnace": "clamp"}}, "over_each is by limit: there is .*, distance, .*, not 'distnace'"),
        ({"over_each": "clamp"}, "over_each is a dictionary by limit"),
        ({"linear_velocity": None}, "the limit linear_velocity is a number in SI units, not None"),
    ],
)
def test_what_cannot_happen_beyond_a_limit(given, says):
    with pytest.raises((TypeError, ValueError), match=says):
        Limits(**given)


@pytest.mark.parametrize(
    ("action", "says"),
    [
        (Move(0.5, 1.0, 100.0), "move: 1 m at 0.5 m/s take 2 s, not 100 s"),  # 50 m, if its duration were kept
        (Move(0.5, 1.0, 0.0), "move: 1 m at 0.5 m/s take 2 s, not 0 s"),
        (Turn(-1.0, -0.5, 20.0), "turn: 1 rad at 0.5 rad/s take 2 s, not 20 s"),
    ],
)
def test_numbers_that_cannot_all_be_meant(action, says):
    for limits in (Limits(), LIMITS, Limits(over="clamp")):
        assert limits.check(action).refused == says


@pytest.mark.parametrize(("asked", "done"), [(Move(0.3, 1.0, 3.33), 3.3333), (Turn(1.0, 0.3, 3.33), 3.3333)])
def test_a_duration_that_was_rounded_is_reckoned_again(asked, done):
    checked = Limits().check(asked)
    assert not checked.refused
    assert checked.action.duration == pytest.approx(done, abs=1e-4)  # type: ignore[union-attr]


def test_a_turning_speed_in_degrees_is_no_limit():
    with pytest.raises(ValueError, match=r"90 are 14.3 turns a second: 90 degrees a second are math.radians\(90\)"):
        Limits(angular_velocity=90)
    assert Limits(angular_velocity=math.inf) == Limits()
    assert Limits(angular_velocity=19.9).angular_velocity == 19.9
