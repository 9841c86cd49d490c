"""What was said twice by who hesitates is meant once; what may be two is not."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine
from intent_engine.language.meaning.corrections.said_twice import said_once
from intent_engine.language.utterance import Utterance

GRAMMAR = """
language: en
slots:
  room: [kitchen, bedroom]
  state: ["on", "off"]
  bay: {type: number, whole: true, max: 99}
  height: {type: distance}
  thing: {type: text, max_words: 4}
intents:
  light: {action: custom, sentences: ["turn {state} the lights [in the {room}]"]}
  ring: {action: custom, sentences: ["ring [the bell] [twice]"]}
  park: {action: custom, sentences: ["park [in bay {bay}]"]}
  lift: {action: custom, sentences: ["lift the fork to {height}"]}
  fetch: {action: custom, sentences: ["fetch the {thing}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("turn turn on the lights", "turn on the lights"),
        ("turn on the, the lights", "turn on the lights"),
        ("turn on the uh the lights in the in the kitchen", "turn on the lights in the kitchen"),
        ("turn on the turn on the lights", "turn on the lights"),
        ("park in bay in bay seven", "park in bay seven"),
        ("park in bay bay seven and turn on the the lights", "park in bay seven and turn on the lights"),
        ("lift the lift the fork to half a meter", "lift the fork to half a meter"),
        ("turn the turn on the lights", "turn on the lights"),
        ("park in park in bay seven", "park in bay seven"),
        ("park uh park in bay seven", "park in bay seven"),
    ],
)
def test_who_hesitates_means_it_once(engine: IntentEngine, said: str, meant: str) -> None:
    assert engine.parse(said).actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "park in bay seven seven",
        "ring ring",
        "turn off turn on the lights",
        "turn on the lights in the turn off the lights",
        "don't turn the turn on the lights",
        "park in bay seven in the park in bay eight",
        "lift the fork to lift the fork",
        "park park in bay seven and park",
        "ring park ring park",
        "lift the fork to to thirty centimeters",
        "don't don't turn on the lights",
        "turn on the lights turn on the lights",
        "turn turn turn on the lights",
        "turn on the lights in the kitchen kitchen",
    ],
)
def test_what_may_be_two_or_a_number_is_not_done(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


words = st.lists(st.sampled_from("abcd"), max_size=10)


@given(words)
def test_nothing_stands_twice_in_what_is_left(said: list[str]) -> None:
    once = said_once(Utterance(said, [False] * len(said)), lambda start, end: True)
    if once is not None:
        assert len(once) < len(said)
        assert set(once.words) == set(said)


@given(words)
def test_what_may_not_be_left_out_is_not(said: list[str]) -> None:
    assert said_once(Utterance(said, [False] * len(said)), lambda start, end: False) is None
