""" "Faster" and "slow down", said to a robot that moves."""

from __future__ import annotations

import pytest
from continuing_stage import Talk

from intent_engine.actions import ChangeSpeed, Move, Place, Turn
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.runtime.continuing import ONE_SENTENCE

PAUSES = [0.3, 0.8, ONE_SENTENCE + 0.2]


@pytest.mark.parametrize("pause", PAUSES)
@pytest.mark.parametrize(
    ("text", "speed"),
    [("faster", 0.75), ("speed up", 0.75), ("a bit faster", 0.6), ("slow down", 0.25), ("please go slower", 0.25)],
)
def test_the_motion_goes_on_at_another_speed_and_comes_as_far(pause, text, speed):
    said = Talk("go forward four meters", text, pause=pause)
    motion, change = (goal for event in said.done for goal in event.goals)
    assert (motion.state, change.state) == (GoalState.SUCCEEDED, GoalState.SUCCEEDED)
    assert motion.action == Move(speed, 4.0, 4.0 / speed)
    assert motion.feedback.travelled == pytest.approx(4.0)


@pytest.mark.parametrize("pause", PAUSES[1:])
def test_what_waits_its_turn_is_done_as_it_was_said(pause):
    said = Talk("go forward two meters then turn left", "slow down", pause=pause)
    first, then, change = (goal for event in said.done for goal in event.goals)
    assert [goal.state for goal in (first, then, change)] == [GoalState.SUCCEEDED] * 3
    assert (first.action.linear_velocity, then.action) == (0.25, Turn(0.75, 0.5, 1.5))


def test_a_robot_that_stands_says_why_it_does_nothing():
    (event,) = Talk("faster").done
    (goal,) = event.goals
    assert (goal.state, goal.reason) == (GoalState.REJECTED, Reason.NOTHING_MOVES)
    assert "does not move" in goal.detail


@pytest.mark.parametrize("again", ["again", "keep going", "a bit more"])
def test_again_may_mean_the_motion_or_the_speed(again):
    said = Talk("go forward ten meters", "slow down", again, pause=PAUSES[-1])
    assert [event.interpretation.actions[0] for event in said.done] == [Move(0.5, 10.0, 20.0), ChangeSpeed(0.5)]
    assert "say what to do" in said.last.interpretation.reason


def test_it_is_still_what_was_named_before():
    said = Talk("pick up the cup", "go forward", "slow down", "put it on the table", pause=PAUSES[-1])
    assert said.done[-1].interpretation.actions == (Place("cup", "table"),)


@pytest.mark.parametrize("text", ["don't go faster", "that was faster", "the other one is slower"])
def test_what_is_not_asked_for_changes_nothing(text):
    said = Talk("go forward four meters", text, pause=PAUSES[-1])
    (motion,) = said.done[0].goals
    assert motion.action == Move(0.5, 4.0, 8.0)


def test_a_stop_stops():
    said = Talk("go forward ten meters", "faster", "stop", pause=PAUSES[-1])
    assert said.done[0].goals[0].reason is Reason.STOP
