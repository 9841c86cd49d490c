"""What is said of an "it" that is no thing takes and puts nothing."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import does

from intent_engine import IntentEngine
from intent_engine.language.words.thing_words import thing_words

OF_IT = sorted(thing_words("en").sayings)
VERBS = st.sampled_from(["put", "set", "place", "leave", "get", "take", "bring", "carry", "lay"])


@given(
    VERBS,
    st.sampled_from(OF_IT),
    st.sampled_from(["", "let's ", "please ", "okay, "]),
    st.sampled_from(["", " please", ", please", " now"]),
)
def test_a_saying_takes_and_puts_nothing(verb: str, saying: str, before: str, after: str) -> None:
    command = saying if saying.startswith("take") else f"{verb} {saying}"
    assert does(f"{before}{command}{after}") in ("rejected", "incomplete", "ambiguous")
    assert does(f"{before}{command}{after} and turn left") in ("rejected", "incomplete", "ambiguous")


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("take it from the top of the shelf", "pick it"),
        ("take it from the table", "pick it"),
        ("pick it up from there", "pick it"),
        ("take the cup from here", "pick cup"),
        ("take that back to the kitchen", "bring"),
        ("put it in the box", "place it box"),
        ("put it in the light box", "place it light box"),
        ("put the towel on my knee", "place towel knee"),
        ("grab the swing handle", "pick swing handle"),
    ],
)
def test_what_names_a_thing_or_where_it_is_is_done(said: str, meant: str) -> None:
    assert does(said) == meant


@pytest.mark.parametrize(
    "said", ["take a crack at it", "take a swing at it", "take a run at it", "take a knee", "give me my freedom"]
)
def test_what_no_hand_can_hold_is_not_taken(said: str) -> None:
    assert does(said) in ("rejected", "incomplete")


def test_a_sentence_of_a_grammar_is_no_saying(engine_of) -> None:
    engine: IntentEngine = engine_of("intents: {play: {action: custom, sentences: ['(play|take) it from the top']}}")
    assert engine.parse("take it from the top").actions
