"""How long a question may be answered."""

from __future__ import annotations

import pytest

from intent_engine.actions import Turn
from intent_engine.execution.events import Event, EventKind
from intent_engine.interpretation import Interpretation, Question, Status
from intent_engine.runtime.last_asked import QUESTION_LASTS, LastAsked

ASKED = Interpretation("go to bay", Status.AMBIGUOUS, alternatives=("bay 3",), question=Question(("go to bay 3",)))
TURNED = Interpretation("turn left", Status.ACCEPTED, "turn", {}, (Turn(1.0, 0.5, 2.0),), 1.0)


@pytest.fixture
def last() -> LastAsked:
    kept = LastAsked()
    kept.take(ASKED, (), 5.0)
    return kept


def test_a_question_lasts_a_while(last):
    assert last.at(5.0 + QUESTION_LASTS) == ASKED
    assert last.at(5.1 + QUESTION_LASTS) is None
    assert last.at(25.0) is None
    assert LastAsked().at(0.0) is None


def test_a_question_that_lasts_no_time_is_none():
    kept = LastAsked(0.0)
    kept.take(ASKED, (), 5.0)
    assert kept.at(5.0) is None


@pytest.mark.parametrize("later", [TURNED, Interpretation("well", Status.REJECTED)])
def test_whatever_is_understood_ends_it(last, later):
    last.take(later, (), 6.0)
    assert last.at(6.5) is None


@pytest.mark.parametrize("kind", [EventKind.STOP, EventKind.ESTOP])
def test_a_stop_ends_what_was_asked_before_it(last, kind):
    last.happened(Event(kind, 4.0))
    assert last.at(6.0) is not None, "one that was told of late"
    last.happened(Event(kind, 5.5))
    assert last.at(6.0) is None
    last.take(ASKED, (), 7.0)
    assert last.at(7.5) is not None


def test_a_question_remembers_what_was_done_before_it(last):
    last.take(ASKED, TURNED, 6.0)
    question = last.at(6.5).question
    assert (question.choices, question.before) == (("go to bay 3",), TURNED.actions)


def test_a_question_is_forgotten(last):
    last.forget()
    assert last.at(5.0) is None
