"""A robot that moves stops at words that stop it by themselves, whatever follows a pause and is not understood."""

from __future__ import annotations

import pytest
from continuing_stage import Talk
from hypothesis import given
from hypothesis import strategies as st
from meanings import german, shipped

from intent_engine.actions import Stop
from intent_engine.execution.goal import GoalState

ENGLISH = shipped()
HOLDS = ["wait", "hold on", "one moment", "no, wait", "hang on please", "scratch that", "never mind", "don't", "enough"]
REST = ["there is a cat", "wrong way", "the cat is there", "I need to think", "where are you going", "go to the"]


@given(st.sampled_from(HOLDS), st.sampled_from(REST))
def test_it_stops_at_what_would_stop_it_alone(hold: str, rest: str) -> None:
    assert ENGLISH.parse(f"{hold}, {rest}", state=["moving"]).actions == (Stop(),)


@pytest.mark.parametrize("text", ["warte, da ist eine Katze", "Moment, falsche Richtung", "vergiss es, die Katze"])
def test_in_german(text: str) -> None:
    assert german().parse(text, state=["moving"]).actions == (Stop(),)


@pytest.mark.parametrize(
    ("text", "same"),
    [("wait, go back", "go back"), ("never mind, turn left", "turn left"), ("don't stop, keep going", "keep going")],
)
def test_what_is_understood_is_done(text: str, same: str) -> None:
    assert ENGLISH.parse(text, state=["moving"]).actions == ENGLISH.parse(same).actions


@pytest.mark.parametrize("text", ["he said wait, and left", "don't stop, the cat is gone"])
def test_nothing_else_stops_it(text: str) -> None:
    assert not ENGLISH.parse(text, state=["moving"]).actions


@pytest.mark.parametrize("hold", ["wait", "no, wait"])
def test_a_correction_said_at_once_is_one_still(hold: str) -> None:
    said = Talk("go to the kitchen", f"{hold}, the bedroom")
    assert said.done[-1].goals[0].action.location == "bedroom"
    assert said.done[-1].goes_on


def test_what_is_none_stops() -> None:
    said = Talk("go forward ten meters", "wait, the cat is there")
    assert said.done[0].goals[0].state is GoalState.CANCELED
