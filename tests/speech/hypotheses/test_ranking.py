"""Which sentence is the likeliest, by what models think of each."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.networks.approximate import FreeWord
from intent_engine.speech.hypotheses.evidence import View
from intent_engine.speech.hypotheses.ranking import UNKNOWN_WORD, ranked
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

SENTENCES = st.sampled_from(
    [("go", "forward", "two", "meters"), ("turn", "left"), ("stop",), ("go", "to", "the", "kitchen")]
)
VIEWS = st.builds(View, st.floats(-40, 0), st.floats(-40, 0), st.floats(0, 20))


@given(st.dictionaries(SENTENCES, VIEWS, min_size=1))
def test_two_models_that_think_the_same_rank_as_one_does(grammar, views):
    alone = ranked(grammar, {words: (view,) for words, view in views.items()})
    both = ranked(grammar, {words: (view, view) for words, view in views.items()})
    assert [one.words for one in alone] == [one.words for one in both]
    for one, two in zip(alone, both, strict=True):
        assert two.evidence.models == 2
        assert two.evidence.weighed == pytest.approx(one.evidence.weighed)


@given(VIEWS, VIEWS)
def test_of_two_models_neither_counts_more(grammar, one, other):
    words = ("turn", "left")
    (forth,), (back,) = ranked(grammar, {words: (one, other)}), ranked(grammar, {words: (other, one)})
    assert forth.evidence.confidence == pytest.approx(back.evidence.confidence)


def test_a_sentence_carries_what_it_would_do(engine, grammar):
    (reading,) = ranked(grammar, {("turn", "left"): (View(-1.0, -1.0, 0.0),)})
    assert reading.actions == engine.parse("turn left").actions


PEOPLE = """
language: en
slots:
  name: {type: text, max_words: 2}
  thing: {type: text, known: [cup, ball]}
intents:
  call: {action: {type: custom, name: call}, sentences: ["call {name}", "take {thing}"]}
"""


def test_a_word_that_a_slot_without_a_list_takes_is_no_less_likely(engine_of):
    people = SpokenGrammar(engine_of(PEOPLE))
    view = View(-3.0, -3.0, 0.0)
    jessica, flurb = ("call", FreeWord("jessica")), ("take", "the", FreeWord("flurb"))
    found = {one.words: one.evidence.unknown for one in ranked(people, {jessica: (view,), flurb: (view,)})}
    assert found == {jessica: 0, flurb: 1}


def test_a_word_that_no_list_has_is_less_likely(engine_of):
    people, heard = SpokenGrammar(engine_of(PEOPLE)), (View(-3.0, -3.0, 0.0),)
    cup, flurb = ranked(people, {("take", "the", FreeWord("flurb")): heard, ("take", "the", "cup"): heard})
    assert cup.words == ("take", "the", "cup")
    assert (cup.evidence.margin, flurb.behind) == (UNKNOWN_WORD, UNKNOWN_WORD)


@pytest.mark.parametrize(("ahead", "first"), [(3.5, "ball"), (4.5, "bell")])
def test_what_was_clearly_heard_is_no_listed_word_that_sounds_alike(engine_of, ahead, first):
    people = SpokenGrammar(engine_of(PEOPLE))
    bell, ball = ("take", "the", FreeWord("bell")), ("take", "the", "ball")
    views = {bell: (View(-1.0, -1.0, 0.0),), ball: (View(-1.0 - ahead, -1.0, 0.0),)}
    assert ranked(people, views)[0].words[-1] == first


GATES = """
language: en
slots: {gate: {type: number, min: 1, max: 16, whole: true}}
intents: {bring: {action: custom, sentences: ["bring it to gate {gate}"]}}
"""


@pytest.fixture(scope="module")
def gates(engine_of) -> SpokenGrammar:
    return SpokenGrammar(engine_of(GATES))


@pytest.mark.parametrize("number", ["seventy", "twenty", "two and a half", "minus three"])
def test_a_number_beyond_its_limits_does_nothing(gates, number):
    words = ("bring", "it", "to", "gate", *number.split())
    alone = (View(-1.0, -1.0, 0.0),)
    best, *_ = readings = ranked(
        gates, {words: alone, ("bring", "it", "to", "gate", "seven"): (View(-9.0, -1.0, 2.0),)}
    )
    assert (best.words, best.actions, len(readings)) == (words, (), 2)


def test_a_number_within_its_limits_is_likelier(gates):
    heard = (View(-1.0, -1.0, 0.0),)
    within, beyond = ("bring", "it", "to", "gate", "seven"), ("bring", "it", "to", "gate", "seventy")
    assert [one.words for one in ranked(gates, {beyond: heard, within: heard})] == [within, beyond]


@pytest.mark.parametrize(("apart", "first"), [(0.0, "seventy"), (1.0, "seven")])
def test_a_number_beyond_its_limits_must_be_far_likelier_unless_it_was_heard_so(gates, apart, first):
    within, beyond = ("bring", "it", "to", "gate", "seven"), ("bring", "it", "to", "gate", "seventy")
    views = {within: (View(-5.0, -1.0, 1.0),), beyond: (View(-1.5, -1.0, apart),)}
    assert ranked(gates, views)[0].words[-1] == first
