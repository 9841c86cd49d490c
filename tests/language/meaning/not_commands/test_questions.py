"""Questions that ask to do something, and those that ask whether: the verb may be the value of a slot."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

DRONE = """
language: en
slots:
  way: {type: choice, values: {up: [climb, go up, lift], down: [descend, lower]}}
  height: distance
  side: [left, right]
intents:
  way: {action: custom, sentences: ["{way} [the arm] [by] {height}"]}
  side: {action: custom, sentences: ["{side} [{height}]"]}
"""


@pytest.fixture(scope="module")
def drone(engine_of) -> IntentEngine:
    return engine_of(DRONE)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("Could you descend a couple of meters for me?", {"way": "down", "height": 2.0}),
        ("okay, can you go up two meters?", {"way": "up", "height": 2.0}),
        ("would you please lift that arm by a meter?", {"way": "up", "height": 1.0}),
    ],
)
def test_what_is_asked_for_is_done(drone: IntentEngine, said: str, slots: dict[str, object]) -> None:
    assert drone.parse(said).slots == slots


@pytest.mark.parametrize(
    "said",
    [
        "left?",
        "left two meters?",
        "all right, left?",
        "can you, right?",
        "did you descend two meters?",
        "do you climb two meters?",
        "descends two meters?",
        "could you descend two or three meters?",
        "could they descend two meters?",
    ],
)
def test_what_asks_whether_is_none(drone: IntentEngine, said: str) -> None:
    assert not drone.parse(said).actions
