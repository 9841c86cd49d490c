"""What is hardly heard is heard once more, a moment later."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from two_models import FORWARD, LEFT, LIKELY, SOUND, Thinks, heard, two

from intent_engine.speech import second_opinion
from intent_engine.speech.again import CONFIRMED, HOPELESS, LATER, MAY_BE, SURE_AGAIN, heard_again, later
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

HARDLY = Thinks(replace(heard(LEFT, 0.5), free_text="ten laugh"), {LEFT: -9.0})
"""Asked back, after both have searched and dug."""
RATHER = Thinks(replace(heard(LEFT, 0.5), free_text="turn loft"), {LEFT: -6.5, "turn right": -12.0})
"""Done, though not surely."""
SURELY = Thinks(heard(FORWARD, 0.5), {FORWARD: LIKELY})
OTHER = Thinks(replace(heard("turn right", 0.5), free_text="turn right"), {"turn right": LIKELY})

confidences = st.floats(0, 1)


LAMP = """
language: en
intents:
  red: {action: custom, min_confidence: 0.6, sentences: [red]}
  blue: {action: custom, sentences: [blue]}
"""


@pytest.fixture(scope="module")
def forgiving(engine_of):
    """A grammar that would rather be wrong than ask."""
    return SpokenGrammar(engine_of(LAMP))


def twice(grammar, once, again):
    return heard_again(once, SOUND, grammar, lambda _sound, _searching: again)


def hearing(engine, once: Thinks, again: Thinks):
    both, one, other = two(engine, once, once)
    one.later = other.later = again
    return both, one, other


def test_it_is_the_same_sound_a_moment_later():
    np.testing.assert_array_equal(later(SOUND)[LATER:], SOUND)
    assert not later(SOUND)[:LATER].any()
    assert later(SOUND).dtype == SOUND.dtype


@given(st.floats(0.7, CONFIRMED - 0.01), confidences)
def test_what_is_said_before_it_counts_the_second_time_too(grammar, once, again):
    """ "Did you turn left": the first time nobody heard the "did"."""
    found, told = heard(LEFT, once), replace(heard(LEFT, again), left_out=("did you",))
    assert twice(grammar, found, told).left_out == (("did you",) if again >= MAY_BE else ())


@given(st.floats(0.7, 1), confidences)
def test_what_is_done_is_as_sure_as_it_was_if_it_is_the_same_the_second_time(grammar, once, again):
    found = heard(LEFT, once)
    assert twice(grammar, found, heard(LEFT, again)) == found


@given(st.floats(HOPELESS, CONFIRMED, exclude_max=True), confidences)
def test_what_may_have_been_something_else_is_asked_back(grammar, once, again):
    found = twice(grammar, heard(LEFT, once), heard(FORWARD, again))
    if min(once, again) >= MAY_BE:
        assert (found.text, found.sureness) == (LEFT, pytest.approx(once / 2 if once >= 0.7 else once))
    else:
        assert found.sureness in (once, again)


@given(st.floats(0.7, 1), confidences)
def test_but_not_where_to_be_wrong_costs_less_than_to_be_asked(forgiving, once, again):
    assert twice(forgiving, heard("red", once), heard("blue", again)) == heard("red", once)


@given(st.floats(HOPELESS, 0.7, exclude_max=True))
def test_a_stop_is_done_whatever_it_seemed_the_first_time(grammar, once):
    assert twice(grammar, heard(LEFT, once), heard("stop", SURE_AGAIN)).text == "stop"


@pytest.mark.parametrize("doubt", [{"unclear": ("two",)}, {"left_out": ("do you",)}, {"confidence": SURE_AGAIN - 0.01}])
def test_what_is_doubtful_the_second_time_is_not_done(grammar, doubt):
    once, sure = heard(FORWARD, 0.5), heard(FORWARD, SURE_AGAIN)
    assert twice(grammar, once, sure) == sure
    assert twice(grammar, once, replace(sure, **doubt)) == once


@given(confidences, confidences)
def test_nothing_is_done_by_a_second_time_that_was_refused_the_first(grammar, once, again):
    refused = heard("don't turn left", once)
    assert twice(grammar, refused, heard(LEFT, again)) == refused


def test_what_would_be_asked_back_is_done_if_it_is_heard_surely_the_second_time(engine):
    both, one, _ = hearing(engine, HARDLY, Thinks(heard(LEFT, 0.5), {LEFT: LIKELY}))
    found = both.transcribe(SOUND)
    assert found.text == LEFT
    assert found.sureness >= SURE_AGAIN
    assert (one.listened, one.listened_again) == ([SOUND.size], [SOUND.size])


def test_but_nothing_else_however_surely(engine):
    both, *_ = hearing(engine, HARDLY, SURELY)
    assert both.transcribe(SOUND).sureness < 0.7


def test_but_no_thing_that_may_have_any_name(engine):
    mouse = Thinks(replace(heard("take the mouse", 0.5), free_text="tape the mows"), {"take the mouse": -11.0})
    both, *_ = hearing(engine, mouse, Thinks(heard("take the mouse", 0.5), {"take the mouse": LIKELY}))
    found = both.transcribe(SOUND)
    assert HOPELESS < found.sureness < 0.7


def test_what_is_heard_neither_time_is_asked_back(engine):
    both, *_ = hearing(engine, HARDLY, HARDLY)
    assert both.transcribe(SOUND).sureness < 0.7


def test_what_was_rather_something_else_the_second_time_is_asked_back(engine):
    both, *_ = hearing(engine, RATHER, OTHER)
    assert both.transcribe(SOUND).sureness < 0.7


def test_what_was_the_same_the_second_time_is_done(engine):
    both, one, _ = hearing(engine, RATHER, Thinks(heard(LEFT, 0.5), {LEFT: LIKELY}))
    found = both.transcribe(SOUND)
    assert found.text == LEFT
    assert found.sureness > 0.7
    assert (one.listened, one.listened_again) == ([SOUND.size], [SOUND.size])


def test_while_somebody_may_still_be_speaking_nothing_is_heard_again(engine):
    both, one, _ = hearing(engine, HARDLY, SURELY)
    assert both.transcribe(SOUND, final=False).draft
    assert (one.listened, one.listened_again) == ([SOUND.size], [])


SURE = Thinks(replace(heard(LEFT, 0.5), free_text="ten lost"), {LEFT: -1.5})
REFUSED = Thinks(heard("don't turn left", None), {})
STOP = Thinks(replace(heard("stop", 0.5), free_text="stock up"), {"stop": -3.0})
TALK = Thinks(replace(heard("", None), text="", free_text="a lot of people there were"), {})


@pytest.mark.parametrize("once", [SURE, REFUSED, STOP, TALK], ids=["sure", "refused", "a stop", "talk"])
def test_what_is_sure_or_refused_or_a_stop_or_nothing_is_not_heard_again(engine, once):
    """A stop waits for nothing, and what shall not be done is not tried until it is heard otherwise."""
    both, one, _ = hearing(engine, once, SURELY)
    both.transcribe(SOUND)
    assert (one.listened, one.listened_again) == ([SOUND.size], [])


def test_on_a_slow_machine_what_would_be_asked_back_is_not_heard_again(engine, monkeypatch):
    monkeypatch.setattr(second_opinion, "SOON", -1.0)
    both, one, _ = hearing(engine, HARDLY, SURELY)
    both.transcribe(SOUND)
    assert (one.listened, one.listened_again) == ([SOUND.size], [])


def test_but_what_would_be_done_is(engine, monkeypatch):
    """Who has a slow machine is not to have a less careful robot."""
    monkeypatch.setattr(second_opinion, "SOON", -1.0)
    both, one, _ = hearing(engine, RATHER, OTHER)
    assert both.transcribe(SOUND).sureness < 0.7
    assert (one.listened, one.listened_again) == ([SOUND.size], [SOUND.size])


def test_the_cases_are_what_they_are_called(engine):
    for once, least, most in ((HARDLY, 0.03, 0.7), (RATHER, 0.7, CONFIRMED), (SURE, CONFIRMED, 1.0)):
        both, *_ = two(engine, once, once)
        found = both._sought(both._look(SOUND), 0.0)
        assert least <= found.sureness < most, (once, found)
