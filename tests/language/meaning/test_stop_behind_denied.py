"""A stop that is joined to what shall not be done stops a robot that moves: a stop that is missed may cost more than a
word."""

from __future__ import annotations

import pytest
from meanings import german, shipped

from intent_engine.engine import IntentEngine

ENGLISH = shipped()
GERMAN = german()


@pytest.mark.parametrize(
    ("engine", "text"),
    [
        (ENGLISH, "don't go to the kitchen and stop"),
        (ENGLISH, "do not go to the kitchen then stop"),
        (ENGLISH, "don't pick up the cup and stop"),
        (ENGLISH, "never go back and stop stop"),
        (ENGLISH, "don't turn left, stop"),
        (GERMAN, "fahr nicht in die Küche und stopp"),
        (ENGLISH, "do not turn left and stop there and wait"),
        (ENGLISH, "don't go to the kitchen but stop there now"),
        (ENGLISH, "don't pick up the cup, and wait"),
        (ENGLISH, "don't follow me and stay there"),
        (ENGLISH, "don't go to the zoo and stop there and wait"),
        (ENGLISH, "no, don't go to the zoo and wait"),
        (GERMAN, "nimm den Becher nicht und warte"),
    ],
)
def test_a_moving_robot_stops(engine: IntentEngine, text: str) -> None:
    assert engine.parse(text, state=["moving"]).stops


@pytest.mark.parametrize(
    ("engine", "text"),
    [
        (ENGLISH, "don't stop"),
        (ENGLISH, "do not stop there and wait"),
        (ENGLISH, "never stop and wait"),
        (ENGLISH, "don't pick up the cup and don't wait"),
        (ENGLISH, "don't turn left and don't stop"),
        (ENGLISH, "never stop and turn left"),
        (ENGLISH, "do not go forward and never stop"),
        (ENGLISH, "don't go to the bus stop"),
        (GERMAN, "nicht anhalten und weiterfahren"),
        (GERMAN, "halte nicht an und warte"),
        (ENGLISH, "she does not work and stop signs are red"),
    ],
)
def test_a_stop_that_is_denied_itself_does_not(engine: IntentEngine, text: str) -> None:
    assert not engine.parse(text, state=["moving"]).actions


@pytest.mark.parametrize("text", ["don't go to the kitchen and stop", "do not turn left and stop there and wait"])
def test_a_robot_at_rest_does_nothing(text: str) -> None:
    assert not ENGLISH.parse(text).actions


GRAMMAR = """
language: {}
intents:
  take: {{action: {{type: pick, object: "{{thing}}"}}, sentences: ["{}"]}}
slots: {{thing: object}}
"""
TAKE = {"fr": "prends {thing}", "es": "coge {thing}", "it": "prendi {thing}"}


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("fr", "ne prends pas la tasse et arrête-toi"),
        ("fr", "ne prends pas la tasse et arrête-toi là et attends"),
        ("es", "no cojas la taza y para"),
        ("es", "no cojas la taza y para ahí y espera"),
        ("it", "non prendere la tazza e fermati"),
        ("it", "non prendere la tazza e fermati lì e aspetta"),
    ],
)
def test_it_stops_in_other_languages(engine_of, language: str, text: str) -> None:
    engine = engine_of(GRAMMAR.format(language, TAKE[language]))
    assert engine.parse(text, state=["moving"]).stops
    assert not engine.parse(text).actions
