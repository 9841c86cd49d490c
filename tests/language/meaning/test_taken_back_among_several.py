"""Of two commands of which one takes back the other, never both are done."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  part: [nose, chin]
  drink: [water, tea]
  time: duration
intents:
  scratch: {action: custom, sentences: ["scratch [my] {part}"]}
  pour: {action: custom, sentences: ["pour [some] {drink}"]}
  park: {action: custom, sentences: ["park [the arm]"]}
  wait: {action: custom, sentences: ["wait for {time}"]}
"""
EXACT = ["scratch my nose", "pour some water", "park the arm", "park"]
LOOSE = ["scratch that nose", "pour the tea", "pour some waters"]
"""Understood with an article that no sentence has, or with a word that is like one of the list."""
COMMANDS = st.sampled_from([*EXACT, *LOOSE])
NO = ["no", "no wait", "sorry", "I mean", "actually", "oops", "scratch that"]


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize("said", [*EXACT, *LOOSE])
def test_each_is_a_command(engine, said):
    assert len(engine.parse(said).actions) == 1


@given(
    COMMANDS,
    COMMANDS,
    st.sampled_from(NO),
    st.sampled_from(["{}, {}, {}", "{} and, {}, {}", "{} and {}, {}", "{} {} {}"]),
)
def test_never_both_are_done(engine, said, meant, no, frame):
    actions = engine.parse(frame.format(said, no, meant)).actions
    assert actions in ((), engine.parse(meant).actions)


@given(COMMANDS, st.sampled_from(NO), COMMANDS, st.sampled_from([", and then ", " and then ", ", then "]))
def test_what_is_taken_back_is_not_done_before_another(engine, said, no, other, then):
    assert not engine.parse(f"{said}, {no}{then}{other}").actions


@pytest.mark.parametrize(
    ("said", "names"),
    [
        ("no, park the arm and then pour some tea", ["park", "pour"]),
        ("park, no, pour some tea, and scratch my nose", ["pour", "scratch"]),
        ("park and wait for ten seconds", ["park", "wait"]),
        ("park and wait for ten, no, twenty seconds", ["park", "wait"]),
        ("park, wait for ten seconds, and pour some tea", ["park", "wait", "pour"]),
    ],
)
def test_others_are(engine, said, names):
    assert [action.name for action in engine.parse(said).actions] == names
