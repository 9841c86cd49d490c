"""Bounds of quantities: what is beyond them is understood and refused, whichever way it points."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.grammar import Slot

GRAMMAR = """
language: en
slots:
  way: {type: distance, max: 5 m}
  low: {type: distance, min: -20 m, max: 5 m}
  below: {type: distance, max: -1 m}
  nap: {type: duration, max: 1 h}
  shift: {type: duration, min: -1 h, max: 1 h}
  degrees: {type: number, max: 8}
  level: percent
  full: {type: percent, max: 100 %}
  trim: {type: percent, min: -20 %, max: 20 %}
intents:
  do:
    action: custom
    sentences: ["walk {way}", "sink {low}", "dive {below}", "rest {nap}", "shift {shift}", "cool to {degrees}"]
  dim:
    action: {type: custom}
    sentences: ["dim [the lamp] to {level}", "fill the tank to {full}", "trim by {trim}"]
"""


@pytest.mark.parametrize(
    ("said", "reason"),
    [
        ("walk six meters", "way of 6 m is more than the largest, 5 m"),
        ("walk minus six meters", "way of -6 m is less than the smallest, -5 m"),
        ("rest minus ten seconds", "nap of -10 s is less than the smallest, 0 s"),
        ("dim to minus ten percent", "level of -10 % is less than the smallest, 0 %"),
        ("dim the lamp to -5%", "level of -5 % is less than the smallest, 0 %"),
        ("fill the tank to minus twenty percent", "full of -20 % is less than the smallest, 0 %"),
        ("fill the tank to 120 percent", "full of 120 % is more than the largest, 100 %"),
        ("trim by minus thirty percent", "trim of -30 % is less than the smallest, -20 %"),
        ("sink minus thirty meters", "low of -30 m is less than the smallest, -20 m"),
    ],
)
def test_a_size_beyond_the_bounds_is_refused_by_name(engine_of, said, reason):
    found = engine_of(GRAMMAR).parse(said)
    assert not found.actions
    assert found.reason == reason


@pytest.mark.parametrize(
    ("said", "value"),
    [
        ("walk minus five meters", -5.0),
        ("sink minus ten meters", -10.0),
        ("dive minus two meters", -2.0),
        ("shift minus ten seconds", -10.0),
        ("cool to minus twenty", -20.0),  # a plain number is no size: eight degrees at most, and no least
        ("rest zero seconds", 0.0),
        ("dim to zero percent", 0.0),
        ("dim to 150 percent", 1.5),
        ("trim by minus ten percent", -0.1),
    ],
)
def test_a_size_within_the_bounds_is_done(engine_of, said, value):
    (action,) = engine_of(GRAMMAR).parse(said).actions
    assert list(action.slots.values()) == [value]


@given(
    st.sampled_from(("distance", "angle", "speed", "angular_speed")),
    st.floats(0.01, 1e6),
    st.floats(-1e7, 1e7),
)
def test_a_largest_size_holds_both_ways(kind, most, value):
    slot = Slot("x", kind, maximum=most)
    assert (slot.beyond(value) is None) == (abs(value) <= most)


@given(st.sampled_from(("duration", "percent")), st.floats(-1e6, -1e-6), st.none() | st.floats(0, 1e6))
def test_no_time_and_no_share_is_less_than_none(kind, value, most):
    assert Slot("x", kind, maximum=most).beyond(value) is not None
    assert Slot("x", kind, minimum=-1e7, maximum=most).beyond(value) is None


def test_a_default_beyond_the_size_is_a_mistake_in_the_file(engine_of):
    with pytest.raises(Exception, match="-7 m is less than the smallest, -5 m") as caught:
        engine_of(GRAMMAR.replace("action: custom", "action: custom\n    defaults: {way: -7 m}"))
    assert "max" in str(caught.value)
