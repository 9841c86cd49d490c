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


@pytest.mark.parametrize(
    ("command", "said"),
    [
        ("go to the kitchen", "no, the bedroom"),
        ("go to the kitchen", "actually the bedroom"),
        ("go to the kitchen", "wrong way, the bedroom"),
        ("go to the kitchen", "no no go to the bedroom"),
        ("go forward ten meters", "no no the kitchen"),
        ("go forward ten meters", "no, go to the moon"),
        ("go forward ten meters", "make it two meters"),
        ("turn left two full turns", "no, right"),
        ("go forward ten meters", "no, left"),
        ("turn left two full turns", "not left right"),
    ],
)
def test_so_it_does_where_what_is_meant_instead_follows(command, said):
    """Long after the command, what is meant instead is not done; the robot stops."""
    heard = Talk(command, said, pause=3.0)
    (goal,) = (goal for event in heard.done for goal in event.goals)
    assert goal.state is GoalState.CANCELED


@pytest.mark.parametrize("said", ["no, that is the kitchen", "no, I saw it there", "no, Anna", "sorry Anna"])
def test_what_follows_may_be_said_to_somebody_else(said):
    (goal,) = (goal for event in Talk("go to the kitchen", said, pause=3.0).done for goal in event.goals)
    assert goal.state is GoalState.SUCCEEDED
