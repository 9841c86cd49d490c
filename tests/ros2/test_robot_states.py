"""The states that a node is told. No ROS is needed for it."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.errors import ConfigError
from intent_engine.ros2.robot_states import MAX_TEXT, States, in_one_line, state_names, states_text

KNOWN = frozenset({"moving", "docked", "carrying", "on the ramp"})
names = st.frozensets(st.sampled_from(sorted(KNOWN)))
plain_names = st.lists(st.sampled_from(["moving", "docked", "carrying"]))


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        ("", set()),
        (" \n", set()),
        (None, set()),
        ([], set()),
        ([""], set()),
        ("[]", set()),
        ("docked", {"docked"}),
        (" docked, carrying\n", {"docked", "carrying"}),
        ("docked carrying docked", {"docked", "carrying"}),
        (",docked,,", {"docked"}),
        ('["docked", "on the ramp"]', {"docked", "on the ramp"}),
        (["docked", "on the ramp"], {"docked", "on the ramp"}),
        (("docked",), {"docked"}),
    ],
)
def test_what_is_a_list_of_states(value, expected):
    assert state_names(value, "it") == expected


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ("[docked]", "it: '[docked]' is no JSON"),
        ('["docked"', "is no JSON"),
        ('{"docked": true}', "it: {'docked': True} is no list of states"),
        ('["docked", 7]', "it: 7 is no name of a state"),
        ('[["docked"]]', "it: ['docked'] is no name of a state"),
        ("[" * MAX_TEXT, "is no JSON"),
        ("[" + "9" * 4090 + "]", "is no name of a state"),
        ("[" * 900 + "]" * 900, "it: "),
        ("docked " * 1000, "7000 characters are no list of states"),
        (True, "it: True is no list of states"),
        (7, "it: 7 is no list of states"),
        ([7], "it: 7 is no name of a state"),
        (b"docked", "it: b'docked' is no list of states"),
    ],
)
def test_what_is_no_list_of_states_is_told_with_what_to_write(value, said):
    with pytest.raises(ConfigError) as raised:
        state_names(value, "it")
    assert said in in_one_line(raised.value)
    assert in_one_line(raised.value).endswith('docked carrying, or as JSON, ["docked", "carrying"]')
    assert len(in_one_line(raised.value)) < 400


@given(names)
def test_what_is_told_is_read_as_it_was_meant(states):
    assert state_names(states_text(states), "it") == states


@given(plain_names, st.lists(st.sampled_from([" ", ",", ", ", "\n", "\t,"]), min_size=1))
def test_words_and_json_say_the_same(some, joints):
    text = "".join(f"{name}{joints[i % len(joints)]}" for i, name in enumerate(some))
    assert state_names(text, "it") == state_names(json.dumps(some), "it") == frozenset(some)


# -- who says what -----------------------------------------------------------------------------------------------------


@given(st.lists(st.tuples(st.booleans(), names)))
def test_the_last_word_of_each_side_holds_and_neither_takes_the_other_s_back(said):
    states = States(KNOWN)
    last = {True: frozenset(), False: frozenset()}
    for by_topic, some in said:
        states = states.with_message(states_text(some)) if by_topic else states.with_parameter(sorted(some))
        last[by_topic] = some
    assert states.held == last[True] | last[False]


anything = st.one_of(
    st.text(),
    st.text(alphabet='[]{}",: \\u0dcokedmving7\ud800'),
    st.recursive(st.none() | st.booleans() | st.floats() | st.text(), st.lists).map(json.dumps),
    st.integers(1, MAX_TEXT).map(lambda n: "[" * n + "]" * n),
    st.lists(st.text(min_size=1), min_size=1).map(json.dumps),
)


@given(anything)
def test_whatever_comes_on_the_topic_is_known_states_or_a_reason_that_can_be_sent(text):
    states = States(KNOWN, by_topic=frozenset({"docked"}))
    try:
        after = states.with_message(text)
    except ConfigError as error:
        reason = in_one_line(error)
        assert reason.startswith("voice_commands/state: ")
        assert "\n" not in reason
        assert len(reason) < 2000
        reason.encode()  # as the middleware does
    else:
        assert after.held <= KNOWN


@given(st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.binary(), st.lists(st.integers()), anything))
def test_whatever_the_parameter_is_set_to_is_known_states_or_a_reason(value):
    why = "parameter states: "
    try:
        held = States(KNOWN).with_parameter(value).held
    except ConfigError as error:
        held, why = KNOWN, in_one_line(error)
    assert held <= KNOWN
    assert why.startswith("parameter states: ")


def test_what_no_intent_asks_for_is_told_as_the_command_line_tells_it():
    with pytest.raises(ConfigError) as raised:
        States(KNOWN).with_message("dockd carrying")
    assert in_one_line(raised.value) == (
        "voice_commands/state: no intent of the grammar asks for a state 'dockd': did you mean 'docked'?"
    )
