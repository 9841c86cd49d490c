"""The wake word may be said again before what goes on from a command: "robot, then turn left"."""

from __future__ import annotations

import pytest
from continuing_stage import Talk

from intent_engine import IntentEngine
from intent_engine.execution.goal import GoalState
from intent_engine.runtime.follow_up import FollowUp
from intent_engine.speech.recognizer import Transcript

ENGINE = IntentEngine.from_files("en", locations="home", wake=["falcon", "hey falcon"])


@pytest.mark.parametrize("called", ["falcon", "falcon,", "hey falcon,", "okay falcon"])
def test_what_comes_later_waits_its_turn(called):
    said = Talk("falcon go forward five meters", f"{called} then turn left", engine=ENGINE, pause=2.0)
    first, second = said.done
    assert [first.goals[0].state, second.in_turn] == [GoalState.SUCCEEDED, True]


@pytest.mark.parametrize("called", ["", "falcon, "])
@pytest.mark.parametrize(("text", "later"), [("then turn left", True), ("turn left", False), ("and turn left", False)])
def test_a_program_can_ask_so_too(called, text, later):
    assert ENGINE.comes_later(f"{called}{text}") is later


@pytest.mark.parametrize("called", ["", "falcon, ", "hey falcon, "])
@pytest.mark.parametrize(("text", "back"), [("no, left", True), ("I meant left", True), ("turn left, no", False)])
def test_what_takes_back_does(called, text, back):
    assert ENGINE.takes_back(f"{called}{text}") is back
    assert FollowUp(ENGINE).corrects(Transcript(f"{called}{text}", 0.0, f"{called}{text}")) is back


@pytest.mark.parametrize("called", ["falcon, no, two meters", "no, two meters"])
def test_a_motion_is_put_right(called):
    said = Talk("falcon go forward ten meters", called, engine=ENGINE)
    assert said.done[-1].goals[0].action.distance == 2.0
    assert said.done[-1].goes_on


def test_what_was_not_meant_is_not_gone_on_with():
    said = Talk("falcon go forward ten meters", "falcon, no, the thing", engine=ENGINE)
    assert said.done[0].goals[0].state is GoalState.CANCELED
