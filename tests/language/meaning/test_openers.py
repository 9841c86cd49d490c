"""What people begin with says nothing there, in every grammar: "first ..., then ...", "well, ..."."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine, Status

GRAMMAR = """
language: en
slots:
  room: [kitchen, bedroom]
  gear: {type: ordinal, min: 1, max: 5}
intents:
  visit: {action: custom, sentences: ["visit the {room}"]}
  well: {action: custom, sentences: ["(look at|well) the (well|oh)"]}
  gear: {action: custom, sentences: ["[shift to] [{gear}] gear"]}
"""
GERMAN = """
language: de
intents:
  klingeln: {action: custom, sentences: [klingle, "(klingle|geh) hinaus"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.fixture(scope="module")
def german(engine_of) -> IntentEngine:
    return engine_of(GERMAN)


def names(engine: IntentEngine, said: str) -> list[str]:
    found = engine.parse(said)
    return [action.name for action in found.actions] if found.status is Status.ACCEPTED else [found.status.value]


@given(
    st.sampled_from(["first", "first of all", "well", "oh", "to begin with"]),
    st.sampled_from([" ", ", "]),
    st.sampled_from(["visit the kitchen", "visit the kitchen, then visit the bedroom", "uh visit the bedroom please"]),
)
def test_an_opener_changes_nothing(engine: IntentEngine, opener: str, pause: str, command: str) -> None:
    assert engine.parse(opener + pause + command).actions == engine.parse(command).actions


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("okay, well, visit the kitchen", ["visit"]),
        ("well don't visit the kitchen", ["rejected"]),
        ("well he visits the kitchen", ["rejected"]),
        ("first", ["incomplete"]),
        ("visit first the kitchen", ["rejected"]),
        # Where they belong to a command they are words of it.
        ("well the well", ["well"]),
        ("well look at the well", ["well"]),
    ],
)
def test_it_is_one_at_the_beginning_alone(engine: IntentEngine, said: str, done: list[str]) -> None:
    assert names(engine, said) == done


@given(
    st.sampled_from(["well", "oh", "oh well", "um oh"]), st.sampled_from([" ", ", "]), st.sampled_from(["stop", "halt"])
)
def test_a_stop_is_one_behind_it(engine: IntentEngine, opener: str, pause: str, stop: str) -> None:
    assert names(engine, "visit the kitchen") == ["visit"]
    assert engine.parse(opener + pause + stop).stops


@pytest.mark.parametrize("said", ["first gear", "first gear then visit the kitchen", "first, shift to first gear"])
def test_what_is_counted_is_counted(engine: IntentEngine, said: str) -> None:
    assert engine.parse(said).actions[0].slots == {"gear": 1}


@pytest.mark.parametrize("said", ["Zuerst klingle und dann geh hinaus", "Na ja, klingle und geh hinaus"])
def test_in_german_too(german: IntentEngine, said: str) -> None:
    assert names(german, said) == ["klingeln", "klingeln"]


GO_AHEAD = """
language: en
intents:
  advance: {action: custom, sentences: [go ahead, next page, next]}
  turn: {action: custom, sentences: [turn left]}
  lift: {action: custom, sentences: [lift the box]}
"""


@given(st.sampled_from(["", "please ", "okay ", "alright, "]), st.sampled_from(["lift the box", "turn left"]))
def test_go_ahead_says_nothing_after_a_pause_whatever_stands_before_it(engine_of, filler: str, command: str) -> None:
    engine = engine_of(GO_AHEAD)
    plain = engine.parse(f"turn left, {command}").actions or engine.parse(f"turn left and {command}").actions
    assert engine.parse(f"turn left, {filler}go ahead and {command}").actions == plain != ()
    assert [one.name for one in engine.parse(f"turn left, {filler}go ahead").actions] == ["turn", "advance"]


@given(
    st.sampled_from(["stop", "halt", "please stop"]),
    st.sampled_from(["next page", "next", "then next page", "lift the box"]),
)
def test_a_stop_before_a_command_that_begins_as_joints_do(engine_of, stop: str, command: str) -> None:
    engine = engine_of(GO_AHEAD)
    assert engine.parse(f"{stop}, {command}").stops
