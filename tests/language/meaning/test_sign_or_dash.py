"""A dash before a number, which may be its sign: "keep it at - 20 degrees"."""

from __future__ import annotations

import pytest
from meanings import does

from intent_engine.engine import IntentEngine

GRAMMAR = """
language: en
slots: {heat: {type: number, min: -40, max: 40}, note: {type: text, max_words: 6, dictation: true}}
intents:
  keep: {action: custom, sentences: ["keep it at {heat} degrees", "cool it to {heat} degrees"]}
  write: {action: custom, sentences: ["write {note}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    "said",
    [
        "keep it at --20 degrees",
        "keep it at— 20 degrees",
        "keep it at - twenty degrees",
        "keep it at minus -20 degrees",
    ],
)
def test_what_may_be_below_zero_is_not_above(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


@pytest.mark.parametrize(
    ("said", "heat"),
    [
        ("keep it at -20 degrees", -20),
        ("keep it at −20 degrees", -20),
        ("keep it at - 20 degrees", -20),
        ("cool it to – 20 degrees", -20),
        ("keep it at minus 20 degrees", -20),
        ("keep it - at 20 degrees", 20),
        ("keep it at 20 degrees", 20),
        ("keep it at 10 - no - 20 degrees", 20),
    ],
)
def test_what_is_clear(engine: IntentEngine, said: str, heat: float) -> None:
    found = engine.parse(said)
    assert found.slots == {"heat": heat}, found.reason


def test_other_dashes_are_pauses(engine: IntentEngine) -> None:
    assert engine.parse("write they won at - 20").actions
    assert does("turn left - 20 degrees") == "left 20"


def test_german(engine_of) -> None:
    engine = engine_of(
        "language: de\nslots: {heat: {type: number, min: -40}}\n"
        'intents:\n  kühl: {action: custom, sentences: ["kühl es auf {heat} grad"]}\n'
    )
    assert not engine.parse("kühl es auf -- 20 Grad").actions
    assert engine.parse("kühl es auf - 20 Grad").slots == {"heat": -20}
    assert engine.parse("kühl es auf -20 Grad").slots == {"heat": -20}
    cold = engine_of(
        "language: de\nslots: {heat: {type: number, min: 4}}\n"
        'intents:\n  kühl: {action: custom, sentences: ["kühl es auf {heat} grad"]}\n'
    )
    assert not cold.parse("kühl es auf - 20 Grad").actions, "which cannot be below zero"
