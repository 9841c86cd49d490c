"""The laws of the trapezoid, for every distance, speed, ramp and beginning."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.execution.profile import Profile, brake, for_distance, for_duration

positive = st.floats(0.01, 20.0)
rates = st.one_of(st.just(math.inf), st.floats(0.05, 10.0))
speeds = st.floats(-3.0, 3.0).filter(lambda v: abs(v) >= 0.01)
initials = st.floats(-3.0, 3.0)


def samples(profile: Profile, count: int = 60) -> list[float]:
    return [profile.duration * i / count for i in range(count + 1)]


def assert_lawful(profile: Profile, speed: float, initial: float, up: float, down: float) -> None:
    times = samples(profile)
    top = max(abs(speed), abs(initial)) + 1e-9
    for begin, end in pairwise(times):
        assert abs(profile.speed(begin)) <= top
        if begin and math.isfinite(max(up, down)):
            change = abs(profile.speed(end - 1e-12) - profile.speed(begin))
            assert change <= max(up, down) * (end - begin) + 1e-6
        covered = profile.mean_speed(begin, end) * (end - begin)
        assert covered == pytest.approx(profile.position(end) - profile.position(begin), abs=1e-9)
    assert profile.position(profile.duration) == profile.distance
    assert profile.speed(profile.duration) == 0.0
    assert profile.position(-1.0) == 0.0
    last = profile.pieces[-1]
    end = last.position + last.speed * last.length + last.acceleration * last.length**2 / 2
    assert end == pytest.approx(profile.distance, abs=1e-6)
    assert last.start + last.length == pytest.approx(profile.duration, abs=1e-6)


@given(positive, speeds, rates, rates)
def test_a_distance_is_kept_from_rest(distance, speed, up, down):
    profile = for_distance(distance, speed, up, down)
    assert profile.distance == math.copysign(distance, speed)
    assert profile.duration >= distance / abs(speed) - 1e-9
    assert_lawful(profile, speed, 0.0, up, down)


@given(positive, speeds, rates, rates, initials)
def test_a_distance_is_kept_from_any_speed_that_can_be_braked(distance, speed, up, down, initial):
    profile = for_distance(distance, speed, up, down, initial)
    along = initial * math.copysign(1.0, speed)
    if along**2 / (2 * down) <= distance or along < 0:
        assert profile.distance == math.copysign(distance, speed)
    else:
        assert abs(profile.distance) == pytest.approx(along**2 / (2 * down))
    assert_lawful(profile, speed, initial, up, down)


@given(positive, speeds, rates, rates, initials)
def test_a_duration_includes_its_ramps(duration, speed, up, down, initial):
    profile = for_duration(duration, speed, up, down, initial)
    assert profile.duration == pytest.approx(max(duration, abs(initial) / down))
    assert_lawful(profile, speed, initial, up, down)


@given(initials, rates)
def test_a_brake_takes_what_physics_takes(initial, down):
    profile = brake(initial, down)
    assert profile.duration == pytest.approx(abs(initial) / down)
    assert abs(profile.distance) == pytest.approx(initial**2 / (2 * down))
    assert_lawful(profile, initial, initial, down, down)


def test_ten_metres_at_half_a_metre_per_second():
    profile = for_distance(10.0, 0.5, 0.5)
    assert (profile.duration, profile.distance) == (21.0, 10.0)
    assert profile.speed(10.0) == 0.5
    assert profile.mean_speed(5.0, 5.05) == 0.5
