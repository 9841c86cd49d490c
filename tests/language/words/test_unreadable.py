"""Text of which a character was lost on its way, as in files of another encoding: nothing is done of the rest."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from meanings import shipped

from intent_engine import IntentEngine, Stop
from intent_engine.interpretation import Status
from intent_engine.testing import moves, sentences

ENGINE = shipped()
LOST = ("\ufffd", "\udcbd")


@given(case=sentences(ENGINE), at=st.floats(0, 1), lost=st.sampled_from(LOST))
@settings(max_examples=200, deadline=None)
def test_nothing_moves_by_a_text_with_a_lost_character(case, at, lost) -> None:
    place = round(at * len(case.text))
    assert not moves(ENGINE.parse(case.text[:place] + lost + case.text[place:]))


@pytest.mark.parametrize("lost", LOST)
def test_one_and_a_lost_half_is_not_one(lost) -> None:
    found = ENGINE.parse(f"go forward 1{lost} meters")
    assert (found.status, found.actions) == (Status.REJECTED, ())
    assert found.reason == "a character could not be read, behind 'go forward 1': give the text as UTF-8"
    assert ENGINE.parse("go forward 1½ meters").actions[0].distance == 1.5


def test_a_stop_that_was_read_stops() -> None:
    assert ENGINE.parse("stop\ufffd").actions == (Stop(),)
    assert ENGINE.parse("stop! turn left\ufffd", state=["moving"]).actions == (Stop(),)


def test_an_answer_that_could_not_be_read_is_none() -> None:
    bays = IntentEngine.from_files("en", locations={"bay 3": (3.0, 0.0, 0.0), "bay 13": (9.0, 0.0, 0.0)})
    asked = bays.parse("go to bay")
    assert bays.parse("bay 3", last=asked).actions
    assert not bays.parse("bay 3\ufffd", last=asked).actions
    answer = bays.answer(asked, "bay 3\ufffd")
    assert answer is None or not answer.actions
