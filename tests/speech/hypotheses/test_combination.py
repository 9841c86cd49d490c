"""What two models heard, weighed without a recogniser: two opinions that were made up."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from two_models import FORWARD, LEFT, LIKELY, Thinks, heard

from intent_engine.speech.hypotheses.combination import Combination
from intent_engine.speech.hypotheses.evidence import letters_apart
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar


@pytest.fixture
def combination(engine):
    return Combination(SpokenGrammar(engine), lambda ask, opinions: [ask(one) for one in opinions])


def thinks(text: str, scores: dict[str, float], **more) -> Thinks:
    return Thinks(heard(text, 0.5), scores, **more)


def test_the_likelier_for_both_is_taken_with_the_letters_by_which_it_differs(combination):
    first = thinks("go forward two meter", {FORWARD: LIKELY, LEFT: -9.0})
    second = thinks("turn left", {FORWARD: LIKELY - 1.0, LEFT: -9.0})
    both, apart = combination.weighed(first, second)
    assert (both.text, apart) == (FORWARD, letters_apart(FORWARD.split(), first.heard))
    assert 0.0 < both.confidence < 1.0


def test_where_neither_thought_of_a_sentence_the_words_of_the_first_are_told(combination):
    first, second = thinks("the weather is nice", {}), thinks("the feather is mice", {})
    assert combination.weighed(first, second) == (first.transcript, math.inf)


@pytest.mark.parametrize("refuser", [0, 1])
def test_what_one_heard_to_be_refused_is_refused(combination, refuser):
    opinions = [thinks(LEFT, {LEFT: LIKELY}), thinks(LEFT, {LEFT: LIKELY})]
    opinions[refuser] = thinks("don't turn left", {LEFT: LIKELY})
    both, apart = combination.weighed(*opinions)
    assert (both.text, apart) == ("don't turn left", 0.0)


@pytest.mark.parametrize(
    ("first", "second", "unclear"),
    [(0.5, 0.5, ()), (-9.0, 9.0, ("left",)), (9.0, -9.0, ("left",)), (-9.0, -9.0, ("left",))],
)
def test_a_word_must_be_clear_to_both_together_and_impossible_to_neither(combination, first, second, unclear):
    both, other = (thinks(LEFT, {LEFT: LIKELY}, clear={"left": clear}) for clear in (first, second))
    assert combination.weighed(both, other)[0].unclear == unclear


def test_the_same_opinions_in_the_other_order_take_the_same_sentence(combination):
    first = thinks("turn left", {FORWARD: -12.0, LEFT: LIKELY})
    second = replace(thinks("go forward two meters", {FORWARD: LIKELY, LEFT: -3.0}))
    there, back = combination.joint(first, second), combination.joint(second, first)
    assert [one.words for one in there] == [one.words for one in back]
    assert there[0].words == tuple(LEFT.split())
