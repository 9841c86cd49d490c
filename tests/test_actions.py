"""Actions: their limits, their way through JSON and back, and the schema that says the same."""

from __future__ import annotations

import json
import math

import jsonschema
import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.actions import (
    ChangeSpeed,
    Custom,
    Move,
    Navigate,
    Pick,
    Place,
    Stop,
    Turn,
    actions_of,
    from_json,
    json_schema,
    to_json,
)

finite = st.floats(allow_nan=False, allow_infinity=False, width=32)
positive = st.floats(min_value=0, max_value=1e6, allow_nan=False)
names = st.text(min_size=1, max_size=20)
slot_values = st.one_of(names, finite, st.booleans(), st.none())

yaws = st.floats(-math.tau, math.tau)

turns = st.builds(
    lambda size, speed, left: Turn(size if left else -size, speed if left else -speed, size / speed),
    st.floats(0, 100),
    st.floats(0.01, 10),
    st.booleans(),
)
actions = st.one_of(
    st.builds(Move, finite, positive, positive),
    turns,
    st.just(Stop()),
    st.builds(Navigate, names, finite, finite, yaws, names),
    st.builds(Pick, names),
    st.builds(Place, st.none() | names, st.none() | names),
    st.builds(ChangeSpeed, st.floats(min_value=0, max_value=1e6, exclude_min=True)),
    st.builds(Custom, names, st.dictionaries(names, slot_values, max_size=4)),
)


@given(actions)
def test_every_action_comes_back_from_json_and_fits_the_schema(action):
    text = json.dumps(to_json(action), allow_nan=False)
    jsonschema.Draft202012Validator(json_schema()).validate(json.loads(text))
    assert from_json(text) == action
    assert from_json(json.loads(text)) == action
    assert hash(from_json(text)) == hash(action)


@given(actions, st.sampled_from(["linear_velocity", "object", "extra", "type", "slots"]))
def test_what_the_schema_refuses_from_json_refuses(action, key):
    data = to_json(action) | {key: [1]}
    assert not jsonschema.Draft202012Validator(json_schema()).is_valid(data)
    with pytest.raises(ValueError, match=r"."):
        from_json(data)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize(
    "make",
    [
        lambda v: Move(v, 1.0, 1.0),
        lambda v: Move(1.0, v, 1.0),
        lambda v: Move(1.0, 1.0, v),
        lambda v: Turn(v, 1.0, 1.0),
        lambda v: Turn(1.0, v, 1.0),
        lambda v: Turn(1.0, 1.0, v),
        lambda v: Navigate("kitchen", v, 0.0, 0.0),
        lambda v: Navigate("kitchen", 0.0, v, 0.0),
        lambda v: Navigate("kitchen", 0.0, 0.0, v),
    ],
)
def test_numbers_are_finite(make, value):
    with pytest.raises(ValueError, match="finite"):
        make(value)


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: Move(0.5, -1.0, 2.0), "negative"),
        (lambda: Move(0.5, 1.0, -2.0), "negative"),
        (lambda: Turn(1.0, -0.5, 2.0), "same sign"),
        (lambda: Turn(1.0, 0.5, -2.0), "negative"),
    ],
)
def test_values_that_contradict_themselves_are_refused(make, says):
    with pytest.raises(ValueError, match=says):
        make()


@pytest.mark.parametrize(
    ("data", "says"),
    [
        ({}, "unknown action type None; known: move, turn, stop, navigate, pick, place, change_speed, custom"),
        ({"type": "fly"}, "unknown action type 'fly'"),
        ({"type": "pick"}, "pick"),
        ({"type": "pick", "object": 3}, "pick.object must be a string, not 3"),
        ({"type": "pick", "object": None}, "pick.object must be a string"),
        ({"type": "stop", "now": True}, "stop has no field 'now'; it has none"),
        ({"type": "move", "linear_velocity": "fast", "distance": 1, "duration": 1}, "must be a number, not 'fast'"),
        ({"type": "move", "linear_velocity": True, "distance": 1, "duration": 1}, "must be a number, not True"),
        ({"type": "move", "linear_velocity": 1, "distance": 1}, "duration"),
        ({"type": "move", "linear_velocity": 10**400, "distance": 1, "duration": 1}, "must be a finite number"),
        ({"type": "pick", "object": {}}, "pick.object must be a string, not {}"),
        ({"type": "custom", "name": "wave", "slots": "fast"}, "custom.slots must be an object, not 'fast'"),
        ({"type": "custom", "name": "wave", "slots": {"a": [1]}}, "custom.slots['a'] must be a string, number"),
        ({"type": ["stop"]}, "unknown action type ['stop']"),
        ("[]", "an action is a JSON object, not list"),
    ],
)
def test_json_that_is_no_action_says_why(data, says):
    with pytest.raises(ValueError, match=r".") as caught:
        from_json(data)
    assert says in str(caught.value)


def test_the_sign_of_an_action_is_the_direction():
    # REP 103: x forward, z up; so a positive linear velocity is forward and a positive angle is to the left.
    assert to_json(Move(-0.3, 0.6, 2.0)) == {"type": "move", "linear_velocity": -0.3, "distance": 0.6, "duration": 2.0}
    assert to_json(Turn(-1.5, -0.5, 3.0)) == {"type": "turn", "angle": -1.5, "angular_velocity": -0.5, "duration": 3.0}


def test_the_format_has_a_version():
    jsonschema.Draft202012Validator.check_schema(json_schema())
    assert json_schema()["$id"] == "urn:intent-engine:actions:1"


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"type": "move"}, "move needs linear_velocity, distance and duration"),
        ({"type": "turn", "angle": 1}, "turn needs angular_velocity and duration"),
        ({"type": "move", "linear_velocity": 1, "distance": 1}, "move needs duration"),
    ],
)
def test_what_an_action_lacks_is_named(data, said):
    with pytest.raises(ValueError, match=f"^{said}$"):
        from_json(data)


def test_one_action_or_several_are_taken():
    assert actions_of("submit", Stop()) == (Stop(),)
    assert actions_of("submit", iter([Stop(), Pick("cup")])) == (Stop(), Pick("cup"))
    assert actions_of("submit", []) == ()


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("stop", "not str: engine.parse"),
        ([Stop(), "stop"], "not str: engine.parse"),
        ({"type": "stop"}, "not dict: from_json"),
        (Stop, "not the class Stop: make one"),
        (None, "not NoneType$"),
        (b"stop", "not bytes$"),
    ],
)
def test_what_is_no_action_is_refused_with_what_was_meant(given, said):
    with pytest.raises(TypeError, match=rf"^submit takes actions \(Move, Turn, Stop, \.\.\.\), {said}"):
        actions_of("submit", given)


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: Move("0.5", 1.0, 2.0), "Move.linear_velocity is a number in SI units, not '0.5'"),
        (lambda: Move(True, 1.0, 2.0), "Move.linear_velocity is a number in SI units, not True"),
        (lambda: Turn(1.0, None, 2.0), "Turn.angular_velocity is a number in SI units, not None"),
        (lambda: Navigate("kitchen", "1", 2.0, 0.0), "Navigate.x is a number"),
        (lambda: Navigate(5, 1.0, 2.0, 0.0), "Navigate.location is a text, not 5"),
        (lambda: Navigate("kitchen", 1.0, 2.0, 0.0, None), "Navigate.frame is a text, not None"),
        (lambda: Pick(None), "Pick.object is a text, not None"),
        (lambda: Pick(""), "Pick.object is empty"),
        (lambda: Place(5), "Place.object is a text, not 5"),
        (lambda: Custom("wave", ["a"]), r"Custom.slots are a dictionary, as \{'person': 'Ada'\}, not \['a'\]"),
        (lambda: Custom(print), "Custom.name is a text"),
        (lambda: Custom(""), "Custom.name is empty"),
    ],
)
def test_what_no_action_is_made_of(make, says):
    with pytest.raises((TypeError, ValueError), match=says):
        make()


def test_numbers_of_numpy_are_written_as_others():
    numpy = pytest.importorskip("numpy")
    move = Move(numpy.float32(0.5), numpy.float64(1.0), numpy.int64(2))
    assert from_json(json.dumps(to_json(move))) == move == Move(0.5, 1.0, 2.0)


@pytest.mark.parametrize("given", [5, None, [Stop()], Stop, {"type": "stop"}])
def test_what_is_no_action_is_not_written(given):
    with pytest.raises(TypeError, match="to_json takes an action, not"):
        to_json(given)


def test_equal_custom_actions_have_one_hash_whatever_their_slots_hold():
    assert len({Custom("wave", {"times": 2}), Custom("wave", {"times": 2.0})}) == 1
    assert len({Custom("wave", {"place": (1, object), "who": {1, 2}})}) == 1


@pytest.mark.parametrize("degrees", [90, -90, 45, 360, 7, -7])
def test_a_turn_by_a_whole_number_beyond_a_turn_is_one_in_degrees(degrees):
    with pytest.raises(
        ValueError, match=rf"Turn.angle is in rad.* math.radians\({degrees}\), or {degrees}\.0 if you mean"
    ):
        Turn(degrees, math.copysign(0.5, degrees), abs(degrees) / 0.5)
    meant = Turn(float(degrees), math.copysign(0.5, degrees), abs(degrees) / 0.5)
    assert from_json({**to_json(meant), "angle": degrees}) == meant  # other programs write whole numbers for any


@given(st.integers(-6, 6))
def test_a_turn_by_a_few_radians_may_be_a_whole_number(angle):
    assert Turn(angle, math.copysign(1, angle), abs(angle)).angle == angle


@given(st.floats(math.tau + 0.01, 1e6), st.sampled_from([1, -1]))
def test_no_way_to_look_is_more_than_a_turn(yaw, side):
    with pytest.raises(ValueError, match=r"Navigate\.yaw is in rad"):
        Navigate("kitchen", 1.0, 2.0, side * yaw)
