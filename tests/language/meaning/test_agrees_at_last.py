"""A command that may only agree is none beside words that agree, whatever was said before it."""

from __future__ import annotations

import pytest
from continuing_stage import Talk
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine.actions import Stop

ENGLISH = shipped()
AGREES = ["okay right", "yeah right", "right, okay", "right, right", "right right"]


@pytest.mark.parametrize("text", AGREES)
def test_by_themselves_they_do_nothing(text: str) -> None:
    assert not ENGLISH.parse(text).actions


@given(
    st.sampled_from(["go forward", "go to the kitchen", "turn left and go back", "don't move"]), st.sampled_from(AGREES)
)
def test_nor_behind_a_command(first: str, text: str) -> None:
    assert not ENGLISH.parse(f"{first}, {text}").actions


def test_a_stop_is_one_beside_them() -> None:
    assert ENGLISH.parse("stop, okay right").actions == (Stop(),)
    assert ENGLISH.parse("don't move, okay right", state=["moving"]).actions == (Stop(),)


@pytest.mark.parametrize(
    "text", ["go forward, right", "turn left, right", "go forward and right", "turn left, no, right"]
)
def test_alone_it_is_a_command(text: str) -> None:
    assert ENGLISH.parse(text).actions[-1] == ENGLISH.parse("turn right").actions[0]


@pytest.mark.parametrize("text", AGREES)
def test_who_agrees_after_a_command_asks_for_no_other(text: str) -> None:
    assert len(Talk("go forward two meters", text).done) == 1
