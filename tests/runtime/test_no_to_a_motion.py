"""A "no" long after the command, said to a robot that still does it."""

from __future__ import annotations

import pytest
from continuing_stage import ENGINE, Talk

from intent_engine.execution.goal import GoalState
from intent_engine.needs import MOVING
from intent_engine.runtime.judgement import Judge
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import HARDLY_A_WORD


@pytest.mark.parametrize("command", ["go forward ten meters", "turn left two full turns", "go to the kitchen"])
@pytest.mark.parametrize("said", ["no", "nope", "no, that's wrong", "not that"])
def test_it_stops(command, said):
    heard = Talk(command, said, pause=2.0)
    assert [goal.state for goal in heard.done[0].goals] == [GoalState.CANCELED]


@pytest.mark.parametrize("said", ["no problem", "no, thanks", "no, I did not see it"])
def test_an_answer_to_somebody_else_does_not(said):
    heard = Talk("go forward ten meters", said, pause=2.0)
    assert [goal.state for goal in heard.done[0].goals] == [GoalState.SUCCEEDED]


def test_what_is_meant_may_follow():
    heard = Talk("go forward ten meters", "no", "turn left", pause=2.0)
    assert [goal.state for event in heard.done for goal in event.goals] == [GoalState.CANCELED, GoalState.SUCCEEDED]


@pytest.mark.parametrize(
    ("state", "score", "stops"), [({MOVING}, -0.3, True), ((), -0.3, False), ({MOVING}, HARDLY_A_WORD, False)]
)
def test_it_is_heard_beside_the_nearest_sentence_of_the_grammar(state, score, stops):
    """ "Go" is the likest sentence, and was not said."""
    heard = Transcript("go", score, "no", gap=0.0, confidence=0.1)
    assert Judge(ENGINE).meaning(heard, state, ()).stops is stops
