"""Phrases that files write in full are known as they are mostly said: "when you're done"."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine, Stop
from intent_engine.language.loading.contracted import with_contractions
from intent_engine.language.loading.language_words import default_operators

GRAMMAR = """
language: en
operators: {sequence: ["as soon as it is full"]}
intents:
  fill: {action: custom, sentences: [fill the tank]}
  sail: {action: custom, sentences: [sail, sail home]}
"""
SHORT = {"you are": "you're", "it is": "it's", "that is": "that's", "i would": "I'd"}
FULL = [text for texts in default_operators("en").values() for text in texts if any(f"{two} " in text for two in SHORT)]


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    "said",
    [
        "fill the tank and when you're done sail home",
        "fill the tank, when you're done, sail home",
        "fill the tank and then, once you're there, sail home",
        "I'd like you to fill the tank, and as soon as it's full, sail home",
        "fill the tank and once you are done sail home",
    ],
)
def test_a_joint_is_known_as_it_is_said(engine, said):
    assert [action.name for action in engine.parse(said).actions] == ["fill", "sail"]


def test_a_stop_is(engine):
    assert engine.parse("stop what you're doing").actions == (Stop(),)


@pytest.mark.parametrize("said", ["sail home when you're done", "when you're done", "you're done, I'd sail home"])
def test_talk_stays_talk(engine, said):
    assert not engine.parse(said).actions


@pytest.mark.parametrize("text", FULL)
def test_what_is_said_in_full_and_shortly_means_the_same(engine, text):
    short = text
    for two, one in SHORT.items():
        short = short.replace(f"{two} ", f"{one} ")
    frames = ["{}", "{}, sail", "fill the tank {} sail", "fill the tank, {}, sail home"]
    for frame in frames:
        full, shortly = (engine.parse(frame.format(way)) for way in (text, short))
        assert (full.status, full.actions) == (shortly.status, shortly.actions), frame


@given(st.lists(st.lists(st.sampled_from(["you", "are", "it", "is", "done"]), min_size=1, max_size=6).map(tuple)))
def test_every_phrase_stays_and_none_ends_short(phrases):
    ways = with_contractions(phrases, "en")
    assert len(set(ways)) == len(ways)
    assert set(phrases) <= set(ways)
    assert all(way[-1] in ("you", "are", "it", "is", "done") for way in ways)
    assert with_contractions(phrases, "de") == tuple(phrases)
