"""A stop that is joined to what shall not be done stops a robot that moves: a stop that is missed may cost more than a
word."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

ENGLISH = IntentEngine.from_files("en", locations="home")
GERMAN = IntentEngine.from_files("de", locations="zuhause")


@pytest.mark.parametrize(
    ("engine", "text"),
    [
        (ENGLISH, "don't go to the kitchen and stop"),
        (ENGLISH, "do not go to the kitchen then stop"),
        (ENGLISH, "don't pick up the cup and stop"),
        (ENGLISH, "never go back and stop stop"),
        (ENGLISH, "don't turn left, stop"),
        (GERMAN, "fahr nicht in die Küche und stopp"),
    ],
)
def test_a_moving_robot_stops(engine: IntentEngine, text: str) -> None:
    assert engine.parse(text, state=["moving"]).stops


@pytest.mark.parametrize(
    ("engine", "text"),
    [
        (ENGLISH, "don't stop"),
        (ENGLISH, "don't turn left and don't stop"),
        (ENGLISH, "never stop and turn left"),
        (ENGLISH, "do not go forward and never stop"),
        (ENGLISH, "don't go to the bus stop"),
        (GERMAN, "nicht anhalten und weiterfahren"),
    ],
)
def test_a_stop_that_is_denied_itself_does_not(engine: IntentEngine, text: str) -> None:
    assert not engine.parse(text, state=["moving"]).actions


def test_a_robot_at_rest_does_nothing() -> None:
    assert not ENGLISH.parse("don't go to the kitchen and stop").actions
