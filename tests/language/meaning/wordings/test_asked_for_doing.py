"""Orders that ask for doing something: "would you mind locking drawer 3"."""

from __future__ import annotations

import pytest
from meanings import does

from intent_engine.actions import Stop
from intent_engine.engine import IntentEngine

GRAMMAR = """
language: en
slots: {drawer: {type: number, whole: true, max: 12}, share: percent}
intents:
  lock: {action: custom, sentences: ["lock drawer {drawer}"]}
  dim: {action: custom, sentences: ["dim the light to {share}", "write it down"]}
"""
LOCKED = {
    "would you mind locking drawer 3": [3],
    "would you mind locking drawer 3?": [3],
    "okay, would you mind, uh, locking drawer 3 please": [3],
    "do you mind locking drawer 3 and then locking drawer 4": [3, 4],
    "would you mind locking drawer 3, no, 4": [4],
    "would you be so kind as to lock drawer 3": [3],
    "it would be great if you could lock drawer 3": [3],
    "what I need is for you to lock drawer 3": [3],
    "I'd love it if you'd lock drawer 3": [3],
    "could you be so kind to lock drawer 3": [3],
    "would be nice if you could lock drawer 3": [3],
    "it would be nice if you lock drawer 3": [3],
    "let's have you lock drawer 3": [3],
    "would it be possible to lock drawer 3?": [3],
    "would it be possible for you to lock drawer 3": [3],
    "I'd appreciate it if you could lock drawer 3 and lock drawer 4": [3, 4],
    "I'd appreciate it if you'd lock drawer 3": [3],
    "I would be grateful if you would lock drawer 3": [3],
}

PEOPLE = """
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


@pytest.mark.parametrize("spoken", [False, True])
@pytest.mark.parametrize("said", LOCKED)
def test_what_is_asked_for_is_done(engine: IntentEngine, said: str, spoken: bool) -> None:
    found = engine.parse(said, spoken=spoken)
    assert [action.slots["drawer"] for action in found.actions] == LOCKED[said], found.reason


def test_verbs_with_a_doubled_or_a_left_out_letter(engine: IntentEngine) -> None:
    assert engine.parse("would you mind dimming the light to half").slots == {"share": 0.5}
    assert engine.parse("would you mind writing it down").actions


@pytest.mark.parametrize(
    "said",
    [
        "would you mind not locking drawer 3",
        "would you mind never locking drawer 3",
        "would you mind if I lock drawer 3",
        "would you mind him locking drawer 3",
        "would you mind locking drawer 3 when he comes",
        "would you mind locking drawer 13",
        "would you mind locking it",
        "would you mind",
        "I wouldn't mind locking drawer 3",
        "he asked would you mind locking drawer 3",
        "I would mind locking drawer 3",
        "it would be great if you could not lock drawer 3",
        "it would have been great if you could lock drawer 3",
        "it would be great if I could lock drawer 3",
        "locking drawer 3",
    ],
)
def test_nothing_else_is(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


def test_a_stop_is_heard(engine: IntentEngine) -> None:
    assert engine.parse("would you mind stopping").stops


def test_the_wake_word_is_needed_as_ever(engine_of) -> None:
    engine = engine_of(GRAMMAR + "wake: [hey robot]\n")
    assert not engine.parse("would you mind locking drawer 3", spoken=True).actions
    assert engine.parse("hey robot, would you mind locking drawer 3", spoken=True).actions


def test_a_grammar_without_fillers_has_none(engine_of) -> None:
    assert not engine_of(GRAMMAR + "fillers: []\n").parse("would you mind locking drawer 3").actions


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("would you mind turning left", "left 43"),
        ("would you mind going to the kitchen and picking up the cup", "to kitchen, pick cup"),
        ("would you mind not going to the kitchen", "rejected"),
    ],
)
def test_in_the_shipped_grammar(said: str, done: str) -> None:
    assert does(said) == done


@pytest.fixture(scope="module")
def humanoid(engine_of) -> IntentEngine:
    return engine_of(PEOPLE)


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
def test_any_form_of_a_verb_is_done(humanoid: IntentEngine, said: str, done: list[str]) -> None:
    assert [action.name for action in humanoid.parse(said).actions] == done


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
def test_other_forms_are_not_done(humanoid: IntentEngine, said: str) -> None:
    assert not humanoid.parse(said).actions


def test_it_stops(humanoid: IntentEngine) -> None:
    assert humanoid.parse("would you mind stopping").actions == (Stop(),)


def test_forms_in_the_shipped_grammar() -> None:
    assert does("would you mind driving to the kitchen") == does("drive to the kitchen") != "rejected"
    assert does("would you mind picking up the cup") == does("pick up the cup") != "rejected"
    assert does("would you mind moving back a bit") == does("move back a bit") != "rejected"
