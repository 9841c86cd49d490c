"""What makes a sentence more or less likely to have been said."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.speech.hypotheses.evidence import Evidence, View, letters_apart

AMOUNT = st.floats(0.0, 50.0)
EVIDENCE = st.builds(Evidence, AMOUNT, AMOUNT, AMOUNT, AMOUNT, st.integers(0, 5), st.integers(1, 3), st.booleans())
WORDS = st.lists(st.text("abcdefghijklmnopqrstuvwxyz", min_size=1, max_size=9), max_size=6)


@given(EVIDENCE, st.floats(0.01, 10.0))
def test_each_kind_of_evidence_speaks_one_way(evidence, more):
    sure = evidence.confidence
    assert 0.0 <= sure <= 1.0
    for name in ("gap", "cost", "apart"):
        assert replace(evidence, **{name: getattr(evidence, name) + more}).confidence <= sure
    assert replace(evidence, unknown=evidence.unknown + 1).confidence <= sure
    assert replace(evidence, margin=evidence.margin + more).confidence >= sure


@pytest.mark.parametrize("models", [1, 2])
def test_what_was_heard_as_it_is_and_has_no_rival_was_said(models):
    assert Evidence(gap=0.0, margin=8.0, cost=0.5, apart=0.0, models=models).confidence > 0.95
    assert Evidence(gap=3.0, margin=1.0, cost=3.0, apart=3.0, models=models).confidence < 0.1


@given(EVIDENCE, st.floats(0.0, 8.0))
def test_of_two_that_are_as_likely_none_is_sure(evidence, margin):
    """Two models' nats add up; a single word, beside which all others were looked at, is weighed as a whole."""
    sentence = replace(evidence, models=2, alone=False, margin=margin)
    assert sentence.confidence <= sentence.share
    assert replace(sentence, margin=0.0).confidence <= 0.5
    assert sentence.share + replace(sentence, margin=-margin).share == pytest.approx(1.0)
    assert replace(sentence, alone=True).share == replace(sentence, models=1).share == 1.0


def test_letters_that_differ_weigh_beside_the_score():
    assert View(-3.0, -1.0, 0.0).value == -3.0
    assert View(-3.0, -1.0, 5.0).value < View(-3.0, -1.0, 4.0).value < -3.0


@given(WORDS, WORDS)
def test_letters_that_differ_are_counted_both_ways_and_none_in_the_same_words(one, other):
    assert letters_apart(one, one) == 0.0
    assert letters_apart(one, other) >= 0.0


@pytest.mark.parametrize(
    ("nearer", "farther"),
    [("go to the dock", "go to the kitchen"), ("go to the dark", "go to the kitchen"), ("turn left", "turn right")],
)
def test_what_is_like_it_is_nearer(nearer, farther):
    heard = {"go to the dock": "go to the dog", "go to the dark": "go to the dock", "turn left": "term left"}[
        nearer
    ].split()
    assert letters_apart(nearer.split(), heard) < letters_apart(farther.split(), heard)
