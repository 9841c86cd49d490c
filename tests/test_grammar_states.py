"""States that somebody named, beside those of the grammar, and what words mean in some state."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.grammar_states import meant_in_some_state, unknown_states
from intent_engine.interpretation import Status


def test_every_unknown_name_is_told_once_with_what_was_meant():
    problems = unknown_states(["dockd", "docked", "asleep", "dockd"], {"docked", "moving"}, "--state")
    assert [str(problem) for problem in problems] == [
        "--state: no intent of the grammar asks for a state 'dockd'\n    did you mean 'docked'?",
        "--state: no intent of the grammar asks for a state 'asleep'\n    there is docked, moving",
    ]


def test_known_names_are_no_problem():
    assert unknown_states(["docked", "moving"], {"docked", "moving"}, "--state") == []


GRAMMAR = """
language: en
intents:
  undock: {action: {type: custom, name: undock}, requires: [docked], sentences: [leave now]}
  leave: {action: {type: custom, name: leave}, excludes: [docked], sentences: [leave now]}
  unload: {action: custom, requires: [carrying, docked], sentences: [unload it]}
  hurry: {action: custom, requires: [moving], sentences: [hurry along]}
  wave: {action: custom, sentences: [wave now]}
"""
STATES = ("docked", "carrying", "moving")


@pytest.fixture(scope="module")
def engine(engine_of):
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("leave now", ["leave"]),  # in no state, as without anybody who tells them
        ("unload it", ["unload"]),
        ("hurry along", ["hurry"]),
        ("unload it then hurry along", ["unload", "hurry"]),
        ("don't unload it", []),
        ("the cellar", []),
        ("unload it you will hit the wall stop", []),  # a stop only of a robot that moves
    ],
)
def test_what_words_mean_in_some_state(engine, text, names):
    assert [action.name for action in meant_in_some_state(engine, text).actions] == names


@given(
    st.sampled_from(["leave now", "unload it", "hurry along", "wave now", "wave now then unload it", "wave it"]),
    st.sets(st.sampled_from(STATES)),
)
def test_what_is_understood_in_a_state_is_understood_in_some(engine, text, state):
    found = engine.parse(text, state=state)
    if found.status is Status.ACCEPTED:
        assert meant_in_some_state(engine, text).status is Status.ACCEPTED


def test_what_means_nothing_says_why_as_in_no_state(engine):
    assert meant_in_some_state(engine, "paint it") == engine.parse("paint it")
