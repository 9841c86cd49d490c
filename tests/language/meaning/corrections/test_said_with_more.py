"""A value is corrected, and another said with it: "pan left, no, right twenty degrees"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine.engine import IntentEngine

JIB = """
language: en
slots:
  way: [pan left, pan right, tilt up, tilt down]
  by: {type: angle, max: 180 deg}
  over: {type: duration, max: 2 min}
  pace: [smoothly, hard]
  drink: [tea, coffee]
  extra: [milk, lemon]
  thing: {type: text, max_words: 2}
  room: [hall, attic]
intents:
  move: {action: custom, sentences: ["{way} [by] [{by}] [over {over}] [{pace}]"]}
  brew: {action: custom, sentences: ["brew {drink} [with {extra}] [for the {room}]"]}
  hide: {action: custom, sentences: ["hide {thing} [in the {room}]"]}
"""


@pytest.fixture(scope="module")
def jib(engine_of) -> IntentEngine:
    return engine_of(JIB)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("pan left, no, right twenty degrees", "pan right twenty degrees"),
        ("tilt up, no, down ten degrees smoothly", "tilt down ten degrees smoothly"),
        ("pan left ten degrees, no, right twenty degrees", "pan right twenty degrees"),
        ("pan left ten degrees, no, right over ten seconds", "pan right ten degrees over ten seconds"),
        ("pan left ten degrees hard, no, fifty degrees smoothly", "pan left fifty degrees smoothly"),
        (
            "pan left ten degrees over five seconds, no, right twenty degrees",
            "pan right twenty degrees over five seconds",
        ),
        ("brew tea, no, coffee for the hall", "brew coffee for the hall"),
        ("brew tea for the hall, no, coffee with milk for the attic", "brew coffee with milk for the attic"),
    ],
)
def test_both_are_meant(jib, said, meant):
    assert_same(jib, said, meant)


@pytest.mark.parametrize(
    "said",
    [
        "pan left ten degrees, no, right on time",
        "pan left ten degrees, no, twenty degrees in five",
        "pan left ten degrees, no, right or left twenty degrees",
        "brew tea, no, coffee is better",
        "brew tea, no, coffee with sugar",
        "hide the key, no, lamp in the hall",  # the thing may be called anything
        "brew tea, no, in the hall coffee",
    ],
)
def test_it_is_not_clear_with_other_words(jib, said):
    assert not jib.parse(said).actions
