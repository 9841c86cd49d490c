"""A command that is broken off at a small word and goes on behind a correction, or is begun anew at a hesitation; and
things of which it is told afterwards, or by their number, which one is meant."""

from __future__ import annotations

import pytest

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  colour: [red, blue]
  height: distance
  bay: {type: number, whole: true, max: 9}
  nth: {type: ordinal, max: 6}
  angle: angle
  thing: [lid, tray]
  name: {type: text, max_words: 3}
intents:
  lift: {action: custom, sentences: ["(raise|lower) the arm [by] {height}"]}
  drive: {action: custom, sentences: ["(go|drive) to bay {bay}"]}
  take: {action: custom, sentences: ["(grab|take) the {colour} box [to bay {bay}]"]}
  twist: {action: custom, sentences: ["(twist|rotate) the {nth} joint [by] {angle}"]}
  pick: {action: custom, sentences: ["pick the [{colour}] (can|jar)", "lift the [{colour}] {thing}"]}
  beep: {action: custom, sentences: [beep, "beep twice"]}
  greet: {action: custom, sentences: ["greet {name}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("lower the arm by, no, by ten centimeters", "lower the arm by ten centimeters"),
        ("lower the arm to... no, by ten centimeters", "lower the arm by ten centimeters"),
        ("go to, I mean, to bay 3", "go to bay 3"),
        ("go to, no, rotate the first joint by 20 degrees", "rotate the first joint by 20 degrees"),
        ("twist, uh, rotate the second joint thirty degrees", "rotate the second joint thirty degrees"),
        ("raise the, um, lower the arm by one meter", "lower the arm by one meter"),
        ("beep, then grab, uh, take the red box to bay 3", "beep, then take the red box to bay 3"),
        ("rotate joint four ninety degrees", "rotate the fourth joint by ninety degrees"),
        (
            "rotate joint number 2 by 5 degrees, then go to bay 3",
            "rotate the second joint by 5 degrees, then go to bay 3",
        ),
        (
            "rotate joint 2 by ten degrees and joint 3 by twenty",
            "rotate the second joint by ten degrees and rotate the third joint by twenty degrees",
        ),
        ("lift the tray, I'm sorry, the lid", "lift the lid"),
        ("lift the tray, the blue one", "lift the blue tray"),
        ("lift the blue tray, not the red one", "lift the blue tray"),
        ("lift the blue tray not the red one, please", "lift the blue tray"),
        ("lift the blue tray and not the red one", "lift the blue tray"),
        ("rotate joint 4 90°", "rotate the fourth joint by ninety degrees"),
    ],
)
def test_what_is_said_at_last_is_done(engine: IntentEngine, said: str, meant: str) -> None:
    assert engine.parse(said).actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "lower the arm by, no",
        "greet, no, by ten centimeters",
        "raise, lower the arm by one meter",  # without an "uh" nobody knows
        "raise the arm by one meter uh the, uh, grab",
        "don't raise, uh, lower the arm by one meter",
        "he said raise, uh, lower the arm by one meter",
        "take the red, uh, go to bay 3",  # of a box something was said
        "lift the red tray, the blue one",  # both, or the other?
        "lift the tray, the big one",
        "lift the tray, the red or the blue one",
        "lift the blue tray, not the blue one",
        "rotate joint three five degrees",
        "rotate joint two hundred degrees",
    ],
)
def test_what_is_not_clear_does_nothing(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


def test_a_whole_command_before_a_hesitation_is_not_lost(engine: IntentEngine) -> None:
    found = engine.parse("beep, uh, go to bay 3")
    assert len(found.actions) != 1
