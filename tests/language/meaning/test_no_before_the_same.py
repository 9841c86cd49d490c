""" "Go forward no go forward": in one breath with its "no" the same command corrects nothing, and may be forbidden."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine import Status

SAID = ("go forward", "turn left ninety degrees", "go to the kitchen", "pick up the bottle", "drive back two meters")
NOES = st.sampled_from(("no", "nope", "nah"))


@given(st.sampled_from(SAID), NOES, st.sampled_from(("", ",")))
def test_the_same_command_in_one_breath_with_a_no_is_asked_about(said: str, no: str, pause: str) -> None:
    found = shipped().parse(f"{said}{pause} {no} {said}")
    assert (found.status, found.actions) == (Status.AMBIGUOUS, ())
    assert "may forbid it" in found.reason


@given(st.sampled_from(SAID), st.sampled_from(("no,", "I mean", "no, I mean", "actually,", "no wait")))
def test_what_can_only_correct_says_it_again(said: str, correction: str) -> None:
    found = shipped().parse(f"{said}, {correction} {said}")
    assert found.actions == shipped().parse(said).actions


@given(st.sampled_from(SAID), st.sampled_from(SAID), NOES)
def test_another_command_corrects(said: str, meant: str, no: str) -> None:
    if said != meant:
        assert shipped().parse(f"{said} {no} {meant}").actions == shipped().parse(meant).actions


@pytest.mark.parametrize(
    "text", ["go forward no move forward", "turn left no please turn left", "go back, no drive back"]
)
def test_other_words_for_the_same_are_the_same(text: str) -> None:
    assert not shipped().parse(text).actions


def test_a_value_said_again_is_one() -> None:
    assert shipped().parse("turn left no left").actions == shipped().parse("turn left").actions
