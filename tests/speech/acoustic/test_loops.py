"""Sentences that a model says over and over, folded."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.speech.acoustic.loops import LONG_SENTENCE, fold_loop, goes_round, stutters

words = st.sampled_from(["go", "stop", "left", "two", "meters", "the", "kitchen"])


@pytest.mark.parametrize(
    ("written", "once"),
    [
        ("Go to the kitchen. Go to the kitchen. Go to the kitchen.", "Go to the kitchen."),
        ("grasp the bottle now, grasp the bottle now, gr", "grasp the bottle now,"),
        ("stop stop stop st", "stop"),
        ("Folge mir Folge mir", "Folge mir"),
        ("follow me follow me", "follow me follow me"),
        ("Follow me Anna Follow me Anna", "Follow me Anna"),
        ("Guten Tag Guten Tag", "Guten Tag Guten Tag"),
        (
            "Give me a large latte with milk and sugar. Give me a large latte wi",
            "Give me a large latte with milk and sugar.",
        ),
        ("Go forward two meters slowly. Go forward two", "Go forward two meters slowly. Go forward two"),
        (
            "Turn right for 40 5 degrees turn right for 45 degrees turn right for 45 degrees turn right for 45",
            "Turn right for 40 5 degrees",
        ),
        (
            "Gonna have a large mocha with brown sugar. I have a large mocha with brown sugar. I have a large",
            "Gonna have a large mocha with brown sugar.",
        ),
        (
            "I have a coffee with a little bit of soy milk. They have a coffee with a little bit of soy milk. They",
            "I have a coffee with a little bit of soy milk.",
        ),
        (
            "Put the red box on the big table there. Put the green box on the big table there. Put",
            "Put the red box on the big table there. Put the green box on the big table there. Put",
        ),
        (
            "I have a coffee with a little bit of soy milk. You have a coffee with a little bit of soy milk.",
            "I have a coffee with a little bit of soy milk. You have a coffee with a little bit of soy milk.",
        ),
        ("go to the lab and turn left. Turn left. Turn left.", "go to the lab and turn left. Turn left. Turn left."),
        (
            "Give me a large mocha with milk. Give me a large mocha with mil",
            "Give me a large mocha with milk.",
        ),
        ("Stir for five minutes. Stir for five minutes. Stir. Stir. Stir", "Stir for five minutes."),
        ("Stir for five minutes. Stir for five minutes. Stir for. Stir for five", "Stir for five minutes."),
        ("Right. Right.", "Right."),
        ("Turn left. Turn left.", "Turn left."),
        ("turn left, turn left", "turn left, turn left"),
        ("go to the lab and go to the dock", "go to the lab and go to the dock"),
        ("", ""),
    ],
)
def test_a_loop_is_what_was_said_once(written: str, once: str) -> None:
    assert fold_loop(written) == once


@given(st.lists(words, min_size=LONG_SENTENCE, max_size=7), st.integers(3, 6), st.data())
def test_however_often_it_went_round_and_wherever_it_was_cut(said: list[str], times: int, data: st.DataObject) -> None:
    whole = " ".join([" ".join(said)] * times)
    cut = data.draw(st.integers(0, len(" ".join(said)) - 1))
    folded = fold_loop((whole + " " + " ".join(said)[:cut]).strip())
    # "go go go go" is a shorter loop than the sentence it was drawn as.
    assert whole.startswith(folded)
    assert len(folded.split()) <= len(said)


@given(st.lists(words, max_size=12))
def test_folding_again_changes_nothing_and_adds_no_word(said: list[str]) -> None:
    once = fold_loop(" ".join(said))
    assert " ".join(said).startswith(once)
    assert fold_loop(once) in (once, fold_loop(fold_loop(once)))


@pytest.mark.parametrize(
    ("written", "round_"),
    [
        ("Turn left 30 degrees Turn left 30 degrees Turn", False),
        ("Turn left 30 degrees Turn left 30 degrees Turn left", True),
        ("Pick it up. Pick it up. Pick it", False),
        ("Pick it up. Pick it up. Pick it up. Pick it", True),
        ("no no no no no no no stop", False),
        ("go to the lab and go to the dock and go to the bedroom", False),
        ("", False),
    ],
)
def test_a_loop_that_is_certain_need_not_be_waited_for(written: str, round_: bool) -> None:
    assert goes_round(written) is round_


@given(st.lists(words, min_size=1, max_size=9), st.integers(1, 6))
def test_what_goes_round_is_folded_as_the_whole_would_be(said: list[str], times: int) -> None:
    whole = (said * times)[:40]
    begun = next((count for count in range(len(whole)) if goes_round(" ".join(whole[:count]))), None)
    if begun is not None:
        assert fold_loop(" ".join(whole[:begun])) == fold_loop(" ".join(whole))


@pytest.mark.parametrize(
    ("written", "stuck"),
    [
        ("A latte with sugar and cream with sugar and cream with sugar and cream with", True),
        ("I want a single shot, aint aint aint aint mocha.", True),
        ("May I have a cappuccino with sweet sweet sweet sweet sweet", True),
        ("no no no, go left", False),
        ("turn left and turn left and go back", False),
        ("go to the kitchen, and go to the dock, and go home", False),
        ("", False),
    ],
)
def test_a_model_that_could_not_go_on(written: str, stuck: bool) -> None:
    assert stutters(written) is stuck


@given(st.lists(words, max_size=5), st.lists(words, min_size=1, max_size=4), st.lists(words, max_size=5))
def test_wherever_it_could_not_go_on(before: list[str], unit: list[str], after: list[str]) -> None:
    assert stutters(" ".join([*before, *unit * 4, *after]))


@given(st.lists(words, max_size=12, unique=True))
def test_words_that_are_all_different_are_no_stutter(said: list[str]) -> None:
    assert not stutters(" ".join(said))
