"""Behind a way "back" may be backward, or the way back: it is asked about, unless more is said."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import done, shipped

from intent_engine import IntentEngine, Status

WAYS = st.sampled_from(
    ["go to the kitchen", "drive to the dock", "go forward two meters", "move forward for two seconds"]
)
JOINTS = st.sampled_from([" and ", ", ", " and then ", ", then "])


@pytest.fixture(scope="module")
def german() -> IntentEngine:
    return IntentEngine.from_files("de", locations="zuhause")


@given(WAYS, JOINTS, st.sampled_from(["back", "go back", "drive back", "please go back"]))
def test_back_behind_a_way_is_asked_about(way: str, joint: str, back: str) -> None:
    found = shipped().parse(f"{way}{joint}{back}")
    assert found.status is Status.AMBIGUOUS, found
    assert not found.actions


@given(WAYS, JOINTS, st.sampled_from(["back up", "go backward", "go back one meter", "go back to the bedroom"]))
def test_what_says_more_is_done(way: str, joint: str, back: str) -> None:
    assert len(shipped().parse(f"{way}{joint}{back}").actions) == 2


@pytest.mark.parametrize("said", ["go forward and back", "turn left and go back", "left, back", "forward then back"])
def test_behind_what_goes_nowhere_in_particular_it_is_backward(said: str) -> None:
    assert done(shipped().parse(said)).endswith("back 0.6")


@pytest.mark.parametrize("said", ["fahr in die Küche und zurück", "fahr zwei Meter vor und dann wieder zurück"])
def test_in_german(german: IntentEngine, said: str) -> None:
    assert not german.parse(said).actions
