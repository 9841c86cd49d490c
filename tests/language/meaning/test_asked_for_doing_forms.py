""" "Would you mind sitting down": what is asked for has the form of a verb that says what somebody is doing."""

from __future__ import annotations

import pytest
from meanings import does

from intent_engine import IntentEngine
from intent_engine.actions import Stop

GRAMMAR = """
language: en
slots:
  person: [Anna, Ben]
  thing: {type: text, max_words: 3, known: [cup]}
intents:
  sit: {action: custom, sentences: ["(sit|lie) down", "take a seat"]}
  wave: {action: custom, sentences: ["wave [to {person}]"]}
  run: {action: custom, sentences: ["run [to {person}]"]}
  plan: {action: custom, sentences: ["(plan|plane) it"]}
  bring: {action: custom, sentences: ["bring {thing}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("would you mind sitting down", ["sit"]),
        ("would you mind taking a seat, please?", ["sit"]),
        ("do you mind waving to Ben", ["wave"]),
        ("would you mind, uh, lying down", ["sit"]),
        ("would you mind running to Anna and waving to Ben", ["run", "wave"]),
        ("would you mind bringing the cup", ["bring"]),
        ("okay would you mind waving to Anna, no, to Ben", ["wave"]),
    ],
)
def test_it_is_done(engine: IntentEngine, said: str, done: list[str]) -> None:
    assert [action.name for action in engine.parse(said).actions] == done


@pytest.mark.parametrize(
    "said",
    [
        "sitting down",
        "would you mind not sitting down",
        "would you mind Ben sitting down",
        "would you mind if I sat down",
        "I would mind sitting down",
        "he asked would you mind sitting down",
        "would you mind planing it",
        "would you mind",
        "waving to Ben, would you mind",
        "she is waving to Ben",
    ],
)
def test_nothing_else_is_done(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


def test_it_stops(engine: IntentEngine) -> None:
    assert engine.parse("would you mind stopping").actions == (Stop(),)


def test_in_the_shipped_grammar() -> None:
    assert does("would you mind driving to the kitchen") == does("drive to the kitchen") != "rejected"
    assert does("would you mind picking up the cup") == does("pick up the cup") != "rejected"
    assert does("would you mind moving back a bit") == does("move back a bit") != "rejected"
