"""Interpretations go to JSON and back, with the eight keys that programs rely on."""

from __future__ import annotations

import json

from hypothesis import given
from hypothesis import strategies as st

import intent_engine
from intent_engine.actions import Move, Navigate, Stop
from intent_engine.interpretation import Interpretation, Question, Status

KEYS = ["text", "status", "intent", "slots", "actions", "confidence", "alternatives", "reason"]

words = st.text(max_size=30)
interpretations = st.builds(
    Interpretation,
    text=words,
    status=st.sampled_from(Status),
    intent=st.none() | words,
    slots=st.dictionaries(words, st.one_of(words, st.booleans(), st.none(), st.integers(-9, 9)), max_size=3),
    actions=st.lists(
        st.sampled_from([Stop(), Move(0.5, 1.0, 2.0), Navigate("kitchen", 5.0, 2.0, 0.0)]), max_size=3
    ).map(tuple),
    confidence=st.integers(0, 10_000).map(lambda n: n / 10_000),
    alternatives=st.lists(words, max_size=3).map(tuple),
    reason=words,
)


@given(interpretations)
def test_every_interpretation_comes_back_from_json(interpretation):
    data = json.loads(json.dumps(interpretation.to_json()))
    assert list(data) == KEYS
    assert Interpretation.from_json(data) == interpretation


def test_nothing_is_done_unless_something_says_so():
    nothing = Interpretation("hello there", Status.REJECTED)
    assert nothing.actions == ()
    assert nothing.intent is None
    assert nothing.confidence == 0.0


def test_confidence_is_written_to_four_places():
    assert Interpretation("x", Status.ACCEPTED, confidence=2 / 3).to_json()["confidence"] == 0.6667


@given(interpretations)
def test_equal_ones_have_one_hash(interpretation):
    again = Interpretation.from_json(interpretation.to_json())
    assert len({interpretation, again}) == 1


def test_what_an_interpretation_asks_is_a_public_type() -> None:
    assert intent_engine.Question is Question
    assert "Question" in intent_engine.__all__
