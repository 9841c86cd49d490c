"""A place whose name ends with a stop word, with and without what people say around a command."""

from __future__ import annotations

import pytest

from intent_engine.actions import Navigate, Stop
from intent_engine.engine import IntentEngine


@pytest.fixture(scope="module")
def engine() -> IntentEngine:
    places = {"bus": (9.0, 9.0), "bus stop": (1.0, 2.0), "emergency stop": (4.0, 4.0), "kitchen": (3.0, 4.0)}
    return IntentEngine.from_files("en", locations=places)


@pytest.mark.parametrize("state", [(), ("moving",)], ids=str)
@pytest.mark.parametrize(
    ("said", "place"),
    [
        ("go to the bus stop", "bus stop"),
        ("please go to the bus stop", "bus stop"),
        ("go to the bus stop please", "bus stop"),
        ("uh go to bus stop now", "bus stop"),
        ("could you go to the emergency stop please", "emergency stop"),
    ],
)
def test_politeness_makes_no_stop_of_a_place(engine, said, place, state):
    (action,) = engine.parse(said, state=state).actions
    assert isinstance(action, Navigate)
    assert action.location == place


@pytest.mark.parametrize("state", [(), ("moving",)], ids=str)
@pytest.mark.parametrize(
    "said",
    [
        "go to the bus, stop",
        "please go to the bus, stop",
        "go to the bus please stop",
        "go to the bus uh stop",
        "go to the bus, please stop",
        "go to the bus stop stop",
        "please go to the bus stop, stop",
        "go to the kitchen please stop",
        "stop please go to the bus stop",
    ],
)
def test_a_stop_behind_a_command_is_no_part_of_a_name(engine, said, state):
    assert engine.parse(said, state=state).actions == (Stop(),)
