"""A unit that corrects another, and a number that takes the unit said before: "five hours, no, minutes", "no, six"."""

from __future__ import annotations

import pytest
from meanings import does

from intent_engine.engine import IntentEngine

GRAMMAR = """
language: en
slots:
  mass: {type: number, max: 9000, units: {1: [mg, milligram, milligrams], 1000: [g, gram, grams]}}
  thing: [salt, tea]
  time: duration
  far: distance
  bed: {type: number, whole: true, max: 40}
intents:
  weigh: {action: custom, sentences: ["weigh {mass} of {thing} [for bed {bed}] [in {time}]"]}
  remind: {action: custom, sentences: ["remind me in {time} [for {time:length}]"]}
  roll: {action: custom, sentences: ["roll {far} [back]"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("remind me in five hours, no, minutes", {"time": 300}),
        ("remind me in an hour, no, minute", {"time": 60}),
        ("remind me in five hours, sorry, I mean minutes", {"time": 300}),
        ("remind me in five hours, no, minutes, for ten seconds", {"time": 300, "length": 10}),
        ("roll two meters, no, feet back", {"far": pytest.approx(0.6096)}),
        ("weigh 1.5 grams, I mean milligrams, of salt", {"mass": 1.5, "thing": "salt"}),
        ("weigh 5 g of salt, no, mg", {"mass": 5, "thing": "salt"}),
        ("weigh 5 grams of tea for bed 3, no, milligrams", {"mass": 5, "thing": "tea", "bed": 3}),
        ("weigh 5 grams of tea in two hours, no, minutes", {"mass": 5000, "thing": "tea", "time": 120}),
        # A number alone.
        ("weigh 500 mg of salt, no, 250", {"mass": 250, "thing": "salt"}),
        ("weigh 5 grams of salt, no, 2", {"mass": 2000, "thing": "salt"}),
        ("weigh 500 mg of salt, no, 2 g", {"mass": 2000, "thing": "salt"}),
        ("weigh 500 mg of salt for bed 3, no, 4", {"mass": 500, "thing": "salt", "bed": 4}),
    ],
)
def test_what_is_corrected(engine: IntentEngine, said: str, slots: dict[str, object]) -> None:
    found = engine.parse(said)
    assert found.actions, found.reason
    assert found.slots == slots


@pytest.mark.parametrize(
    "said",
    [
        "remind me in two hours 30, no, minutes",
        "remind me in two hours and thirty minutes, no, seconds",
        "remind me in two hours for ten minutes, no, seconds",  # of either
        "remind me in two hours, no, meters",
        "weigh 5 grams of tea, no, minutes",
        "weigh 500 mg of salt for bed 3, no, 400",
        "weigh 5 grams of tea, no milligrams, no",
        "remind me in five minutes, no seconds",  # sharp, or after five seconds
        "weigh 5 grams, no milligrams of tea",
        "weigh 5 grams of tea, no, grams",
    ],
)
def test_what_is_not_clear(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("put the cup on the table no in the sink", "place cup sink"),
        ("turn left no turn right", "right 43"),
        ("go forward two no three meters", "forward 3"),
    ],
)
def test_words_that_are_units_elsewhere_correct_as_ever(said: str, done: str) -> None:
    assert does(said) == done
