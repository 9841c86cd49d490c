""" "The other way": what was driven or turned last, in the opposite direction."""

from __future__ import annotations

import math

import pytest
from continuing_stage import Talk

from intent_engine.actions import Move, Turn
from intent_engine.execution.goal import Goal, GoalState, Reason
from intent_engine.runtime.continuing import ONE_SENTENCE

APART = ONE_SENTENCE + 0.2


def goals(said: Talk) -> list[Goal]:
    return [goal for event in said.done for goal in event.goals]


@pytest.mark.parametrize("pause", [0.8, APART])
@pytest.mark.parametrize("text", ["the other way", "no, the other way", "the opposite direction"])
@pytest.mark.parametrize(
    ("first", "instead"),
    [
        ("turn left one hundred and eighty degrees", Turn(-math.pi, -0.5, 2 * math.pi)),
        ("go forward ten meters", Move(-0.5, 10.0, 20.0)),
        ("go back ten meters", Move(0.3, 10.0, 10 / 0.3)),
    ],
)
def test_while_it_is_done_it_takes_its_place(pause, text, first, instead):
    said = Talk(first, text, pause=pause)
    begun, then = goals(said)
    assert (begun.state, begun.reason) == (GoalState.CANCELED, Reason.PREEMPTED)
    assert then.succeeded
    assert type(then.action) is type(instead)
    assert [getattr(then.action, name) for name in then.action.__slots__] == pytest.approx(
        [getattr(instead, name) for name in instead.__slots__]
    )


def test_what_is_over_is_done_back():
    said = Talk("turn left ten degrees", "the other way", "the other way", pause=APART)
    assert [goal.state for goal in goals(said)] == [GoalState.SUCCEEDED] * 3
    assert [goal.action.angle > 0 for goal in goals(said)] == [True, False, True]


@pytest.mark.parametrize(
    ("before", "why"),
    [
        ((), "nothing was done yet"),
        (("go forward ten meters", "stop"), "nothing was done yet"),
        (("go forward two meters and turn left",), "more than one motion"),
        (("go to the kitchen",), "navigate has no other way"),
        (("go forward ten meters", "slow down"), "the speed was changed"),
    ],
)
@pytest.mark.parametrize("text", ["the other way", "no, the other way"])
def test_where_it_is_not_clear_of_what_nothing_is_done(before, why, text):
    said = Talk(*before, text, pause=APART)
    assert len(said.done) == len(before)
    assert why in said.last.interpretation.reason


@pytest.mark.parametrize(
    "text", ["turn left, no, the other way", "turn left, the other way", "go back and the other way"]
)
def test_in_one_sentence_with_another_neither_is_done(text):
    said = Talk("go forward ten meters", text, pause=APART)
    assert len(said.done) == 1


@pytest.mark.parametrize("text", ["not the other way", "don't go the other way", "hold on, wrong way"])
def test_what_is_said_beside_it_turns_nothing(text):
    said = Talk("go forward ten meters", text, pause=APART)
    assert all(isinstance(goal.action, Move) and goal.action.linear_velocity > 0 for goal in goals(said))
