"""Slots to actions: every number finite, everything that moves bounded, distance always speed times time."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from intent_engine.actions import Action, Custom, Move, Navigate, Pick, Place, Stop, Turn
from intent_engine.language.grammar import ActionSpec, Condition, Intent
from intent_engine.language.locations import LocationMap
from intent_engine.language.numbers.units import units
from intent_engine.language.quantities import Relative
from intent_engine.language.sampler import RandomChoices, Sampler
from intent_engine.language.slots.action_builder import (
    MOVE_DURATION,
    MOVE_SPEED,
    TURN_DURATION,
    TURN_SPEED,
    CannotActError,
    build_action,
)

HOME = LocationMap.from_mapping({"kitchen": (5.0, 2.0, 0.5)})


def act(
    kind: str,
    said: Mapping[str, Any],
    defaults: Mapping[str, Any] | None = None,
    parameters: Mapping[str, Any] | None = None,
    when: tuple[Condition, ...] = (),
    name: str | None = None,
) -> Action:
    intent = Intent("it", ActionSpec(kind, name, parameters or {}), defaults=defaults or {}, when=when)
    return build_action(intent, said, HOME)


@pytest.mark.parametrize(
    ("said", "defaults", "velocity", "distance", "duration"),
    [
        ({}, {}, MOVE_SPEED, MOVE_SPEED * MOVE_DURATION, MOVE_DURATION),
        ({}, {"speed": 0.2, "duration": 3.0}, 0.2, 0.6, 3.0),
        ({}, {"speed": 0.2, "distance": 1.0}, 0.2, 1.0, 5.0),
        ({"direction": "backward"}, {}, -0.5, 1.0, 2.0),
        ({"distance": 2.0}, {}, 0.5, 2.0, 4.0),
        ({"distance": -2.0}, {}, -0.5, 2.0, 4.0),
        ({"distance": -2.0, "direction": "back"}, {}, 0.5, 2.0, 4.0),
        ({"duration": 3.0}, {}, 0.5, 1.5, 3.0),
        ({"distance": 2.0, "speed": 0.25}, {}, 0.25, 2.0, 8.0),
        ({"distance": 2.0, "speed": 0.25, "duration": 1.0}, {}, 0.25, 2.0, 8.0),
        ({"distance": 2.0, "duration": 10.0}, {}, 0.2, 2.0, 10.0),
        ({"duration": 3.0, "speed": 1.0}, {}, 1.0, 3.0, 3.0),
        ({"speed": Relative(0.5)}, {"speed": 0.8}, 0.4, 0.8, 2.0),
        ({"speed": Relative(2.0), "distance": 1.0}, {}, 1.0, 1.0, 1.0),
    ],
)
def test_move(
    said: Mapping[str, Any], defaults: Mapping[str, Any], velocity: float, distance: float, duration: float
) -> None:
    found = act("move", said, defaults)
    assert isinstance(found, Move)
    assert (found.linear_velocity, found.distance, found.duration) == pytest.approx((velocity, distance, duration))


@pytest.mark.parametrize(
    ("said", "defaults", "angle", "velocity", "duration"),
    [
        ({}, {}, TURN_SPEED * TURN_DURATION, TURN_SPEED, TURN_DURATION),
        ({"direction": "left"}, {"angle": 1.0}, 1.0, 0.5, 2.0),
        ({"direction": "right"}, {}, -0.75, -0.5, 1.5),
        ({"direction": "clockwise", "angle": 1.0}, {}, -1.0, -0.5, 2.0),
        ({"direction": "left", "angle": -1.0}, {}, -1.0, -0.5, 2.0),
        ({"direction": "right", "angle": -1.0}, {}, 1.0, 0.5, 2.0),
        ({"angle": 1.0, "speed": 0.25}, {}, 1.0, 0.25, 4.0),
        ({"angle": 1.0, "duration": 4.0}, {}, 1.0, 0.25, 4.0),
        ({"duration": 4.0}, {"angle": 1.0}, 2.0, 0.5, 4.0),
        ({"angle": 1.0, "speed": Relative(0.5)}, {"speed": 1.0}, 1.0, 0.5, 2.0),
    ],
)
def test_turn(
    said: Mapping[str, Any], defaults: Mapping[str, Any], angle: float, velocity: float, duration: float
) -> None:
    found = act("turn", said, defaults)
    assert isinstance(found, Turn)
    assert (found.angle, found.angular_velocity, found.duration) == pytest.approx((angle, velocity, duration))


def test_the_others() -> None:
    assert act("stop", {"anything": 1}) == Stop()
    assert act("pick", {"object": "cup"}) == Pick("cup")
    assert act("place", {}) == Place(None, None)
    assert act("place", {"object": "cup", "location": "table"}) == Place("cup", "table")
    assert act("navigate", {"location": "kitchen"}) == Navigate("kitchen", 5.0, 2.0, 0.5, "map")
    assert act("custom", {"a": 1.5, "b": None}, {"c": "x"}) == Custom("it", {"c": "x", "a": 1.5})
    assert act("custom", {"who": "ann"}, parameters={"person": "{who}", "mood": "glad"}, name="wave") == Custom(
        "wave", {"person": "ann", "mood": "glad"}
    )


def test_a_program_gets_a_speed_in_meters_per_second() -> None:
    """A factor would be taken for one."""
    assert act("custom", {"pace": Relative(0.5)}, {"pace": 4.0}) == Custom("it", {"pace": 2.0})
    found = act("custom", {"pace": Relative(0.5)}, {"pace": 4.0}, parameters={"limit": "{pace}"})
    assert found == Custom("it", {"limit": 2.0})
    with pytest.raises(CannotActError, match="no usual pace is known"):
        act("custom", {"pace": Relative(0.5)})


def test_slots_have_other_names_than_parameters() -> None:
    found = act("turn", {"side": "right", "by": 1.0}, parameters={"direction": "{side}", "angle": "{by}"})
    assert isinstance(found, Turn)
    assert found.angle == -1.0
    fixed = act("move", {}, parameters={"direction": "backward", "distance": 0.3})
    assert isinstance(fixed, Move)
    assert (fixed.linear_velocity, fixed.distance) == (-0.5, 0.3)
    by_slot = act("turn", {}, {"by": 1.0}, parameters={"angle": "{by}"})
    assert isinstance(by_slot, Turn)
    assert by_slot.angle == 1.0


def test_defaults_of_some_slot_values_only() -> None:
    when = (Condition({"direction": "backward"}, {"speed": 0.1}),)
    assert act("move", {"direction": "backward"}, {"speed": 0.5}, when=when) == Move(-0.1, 0.2, 2.0)
    assert act("move", {"direction": "forward"}, {"speed": 0.5}, when=when) == Move(0.5, 1.0, 2.0)


@pytest.mark.parametrize(
    ("kind", "said", "reason"),
    [
        ("move", {"distance": 0.0}, "a distance of 0 cannot be driven"),
        ("move", {"duration": 0.0}, "a duration of 0 cannot be driven"),
        ("move", {"speed": 0.0}, "a speed of 0 cannot be driven"),
        ("move", {"speed": -0.3}, "a speed of -0.3 cannot be driven"),
        ("move", {"distance": math.inf}, "a distance of inf cannot be driven"),
        ("move", {"duration": math.nan}, "a duration of nan cannot be driven"),
        ("turn", {"angle": 0.0}, "an angle of 0 cannot be driven"),
        ("turn", {"angle": 1.0, "speed": -1.0}, "a speed of -1 cannot be driven"),
        ("pick", {}, "no object was said"),
        ("navigate", {}, "no location was said"),
        ("navigate", {"location": "atlantis"}, "'atlantis' is not on the map"),
    ],
)
def test_what_cannot_be_done_says_why(kind: str, said: Mapping[str, Any], reason: str) -> None:
    with pytest.raises(CannotActError) as caught:
        act(kind, said)
    assert str(caught.value) == reason


any_float = st.floats(allow_nan=True, allow_infinity=True)
speeds = st.one_of(any_float, st.floats(0.001, 4).map(Relative))


@example("move", {"distance": 1e300, "speed": 1e-300})
@example("move", {"duration": 1e-200, "speed": 1e-200})
@example("turn", {"angle": 1e300, "duration": 1e-300})
@given(
    st.sampled_from(["move", "turn"]),
    st.fixed_dictionaries(
        {},
        optional={
            "direction": st.sampled_from(["forward", "backward", "left", "right"]),
            "distance": any_float,
            "angle": any_float,
            "duration": any_float,
            "speed": speeds,
        },
    ),
)
def test_whatever_was_said_the_motion_is_finite_and_adds_up(kind: str, said: Mapping[str, Any]) -> None:
    try:
        found = act(kind, said)
    except CannotActError:
        return
    if isinstance(found, Move):
        velocity, way = found.linear_velocity, found.distance
    else:
        assert isinstance(found, Turn)
        velocity, way = found.angular_velocity, found.angle
        assert (velocity > 0) == (way > 0)
    assert all(map(math.isfinite, (velocity, way, found.duration)))
    assert found.duration > 0
    assert velocity
    assert abs(way) == pytest.approx(abs(velocity) * found.duration)


LIMIT = """
language: en
slots:
  pace: {type: speed, max: 3 m/s}
intents:
  limit: {action: custom, defaults: {pace: 2 m/s}, sentences: ["keep to {pace}"]}
  record: {action: custom, sentences: ["note {pace}"]}
"""


def test_a_speed_of_the_usual_one_has_the_limits_of_its_slot(engine_of) -> None:
    engine = engine_of(LIMIT)
    assert engine.parse("keep to half speed").actions == (Custom("limit", {"pace": 1.0}),)
    assert engine.parse("keep to full speed").reason == "pace of 4 m/s is more than the largest, 3 m/s"
    assert engine.parse("note half speed").reason == (
        "no usual pace is known that this could be 0.5 times of: the intent has no default for it"
    )
    assert engine.parse("note one meter per second").actions == (Custom("record", {"pace": 1.0}),)
    sampler = Sampler(engine.grammar)
    drawn = [sampler.draw(RandomChoices(seed)) for seed in range(200)]
    assert all(engine.parse(each.text).actions == each.actions for each in drawn)
    table = units("en")
    assert table is not None
    assert {f"keep to {said}" for said in table.speeds} & {each.text for each in drawn}
