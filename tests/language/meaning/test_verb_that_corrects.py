"""Words of correction with which a command begins, as "wait" and "make it": such a command can be corrected as any."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine, Status
from intent_engine.language.numbers.spelled import in_words

GRAMMAR = """
language: en
slots:
  time: duration
  warmth: {type: choice, values: {up: warmer, down: [cooler, colder]}}
  room: [kitchen, bedroom]
intents:
  wait: {action: custom, sentences: ["wait [here] for {time}"]}
  heat: {action: custom, sentences: ["make it {warmth} [in the {room}]"]}
  visit: {action: custom, sentences: ["visit the {room} [for {time}]"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("make it warmer, no, cooler", [("heat", {"warmth": "down"})]),
        ("make it warmer no colder in the kitchen", [("heat", {"warmth": "down", "room": "kitchen"})]),
        ("make it warmer in the bedroom, sorry, in the kitchen", [("heat", {"warmth": "up", "room": "kitchen"})]),
        ("wait for ten seconds, wait, twenty seconds", [("wait", {"time": 20})]),
        ("wait for ten no visit the bedroom", [("visit", {"room": "bedroom"})]),
        (
            "visit the kitchen and wait here for ten no twenty seconds",
            [("visit", {"room": "kitchen"}), ("wait", {"time": 20})],
        ),
        # Where no such sentence goes on behind them they correct, as ever.
        ("wait, visit the bedroom", [("visit", {"room": "bedroom"})]),
        ("visit the kitchen make it the bedroom", [("visit", {"room": "bedroom"})]),
    ],
)
def test_a_command_that_begins_with_one_is_corrected(engine: IntentEngine, said: str, meant: list) -> None:
    found = engine.parse(said)
    assert found.status is Status.ACCEPTED, found.reason
    assert [(action.name, action.slots) for action in found.actions] == meant


@pytest.mark.parametrize("said", ["make it warmer, no", "no, make it", "wait, for twenty, no", "wait"])
def test_what_is_taken_back_is_not_done(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


@given(st.integers(2, 300), st.integers(2, 300), st.sampled_from(["no", "sorry", "I mean", "no wait"]))
def test_the_last_number_counts(engine: IntentEngine, old: int, new: int, corrects: str) -> None:
    first, second = (" ".join(in_words([str(number)])) for number in (old, new))
    found = engine.parse(f"wait for {first}, {corrects}, {second} seconds")
    assert [action.slots for action in found.actions] == [{"time": new}]


HELD = """
language: en
slots: {time: duration}
intents:
  wait: {action: custom, sentences: ["wait [here] [for {time}]"]}
  again: {action: {type: custom, name: again}, sentences: ["[do that] again", "a little more"]}
  greet: {action: custom, sentences: [greet the visitors]}
"""


@pytest.mark.parametrize("said", ["wait a little more", "wait do that again", "please wait greet the visitors"])
def test_in_one_breath_a_command_to_wait_corrects_nothing(engine_of, said):
    """Whether one is to wait, or to do what follows, or both, nobody knows."""
    assert not engine_of(HELD).parse(said).actions


@pytest.mark.parametrize(
    "said", ["wait, greet the visitors", "no wait, greet the visitors", "sorry greet the visitors"]
)
def test_after_a_pause_it_corrects(engine_of, said):
    assert [action.name for action in engine_of(HELD).parse(said).actions] == ["greet"]
