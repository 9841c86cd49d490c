"""Over several utterances "it" is what was named last, and "again" nothing that was taken back."""

from __future__ import annotations

import pytest
from continuing_stage import Talk

from intent_engine.actions import Place
from intent_engine.runtime.continuing import ONE_SENTENCE

APART = ONE_SENTENCE + 0.2
"""s after which an utterance is by itself."""


@pytest.mark.parametrize("pause", [0.8, APART])
@pytest.mark.parametrize(
    "before",
    [
        ("pick up the cup", "turn left"),
        ("pick up the cup", "turn left", "go forward"),
        ("pick up the cup and turn left",),
        ("pick up the plate", "pick up the cup", "go forward", "what a nice day"),
    ],
)
def test_it_is_what_was_named_last(before, pause):
    said = Talk(*before, "put it on the table", pause=pause)
    assert [goal.action for goal in said.done[-1].goals] == [Place("cup", "table")]


@pytest.mark.parametrize("pause", [0.8, APART])
@pytest.mark.parametrize("put", ["put them on the table", "then put them on the table"])
def test_of_two_that_were_named_nobody_knows_which(put, pause):
    """Nor are they put anywhere with the command before."""
    said = Talk("pick up the cup and the plate", "turn left", put, pause=pause)
    assert "more than one thing" in said.last.interpretation.reason
    assert len(said.done) == 2


def test_a_correction_keeps_what_it_points_to():
    said = Talk("pick up the cup", "put it on the table", "no, on the shelf")
    assert [goal.action for goal in said.done[-1].goals] == [Place("cup", "shelf")]


@pytest.mark.parametrize("pause", [0.8, APART])
@pytest.mark.parametrize("taken_back", ["no, the thing", "I mean the thing", "no, that is wrong"])
@pytest.mark.parametrize("again", ["again", "a bit more"])
def test_what_was_taken_back_is_not_done_again(taken_back, again, pause):
    said = Talk("go forward ten meters", taken_back, again, pause=pause)
    driven = [event.interpretation for event in said.done if not event.interpretation.stops]
    assert [meaning.text for meaning in driven] == ["go forward ten meters"]


def test_what_was_said_beside_it_takes_nothing_back():
    said = Talk("go forward two meters", "what a nice day", "again", pause=APART)
    assert len(said.done) == 2
