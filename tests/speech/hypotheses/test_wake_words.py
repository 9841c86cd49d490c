"""Wake words in what was heard: "nurse bot" that models take for "do not"."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from speech_stage import ROOT

from intent_engine.engine import IntentEngine
from intent_engine.speech.acoustic.writing import Names, spellings
from intent_engine.speech.hypotheses.evidence import View
from intent_engine.speech.hypotheses.forbidding import forbidden
from intent_engine.speech.hypotheses.ranking import ranked
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.hypotheses.wake_words import WakeWords

WAKE = ("nurse bot", "hey nurse")


def grammar_with(*wake: str) -> SpokenGrammar:
    maps = ROOT / "locations" / "home.yaml"
    return SpokenGrammar(IntentEngine.from_files(ROOT / "grammars" / "en.yaml", locations=maps, wake=wake))


@pytest.fixture(scope="module")
def called() -> SpokenGrammar:
    return grammar_with(*WAKE)


@pytest.fixture(scope="module")
def plain() -> SpokenGrammar:
    return grammar_with()


@pytest.mark.parametrize(
    ("text", "after"),
    [
        ("nurse bot turn left", 2),
        ("please hey nurse please turn left", 3),
        ("turn left nurse bot", 0),
        ("nurse turn left", 0),
        ("nurse bot", 2),
        ("", 0),
    ],
)
def test_where_a_sentence_goes_on_after_its_wake_word(called, text, after):
    wake = called.wake()
    assert wake.after(text.split()) == after
    assert wake.addressed(text.split()) is (after > 0)


@given(st.lists(st.sampled_from(["nurse", "bot", "hey", "turn", "left", "please", "do", "not"]), max_size=8))
def test_without_wake_words_everything_is_for_the_robot(plain, words):
    assert plain.wake().addressed(words)
    assert plain.woken(words) == []


@pytest.mark.parametrize(
    ("text", "rests"),
    [
        ("go to the kitchen", ["go to the kitchen"]),
        ("do not go to the kitchen", ["go to the kitchen"]),
        ("lets go to the kitchen", ["lets go to the kitchen", "go to the kitchen"]),
        ("can you please turn left", ["can you please turn left", "please turn left", "turn left", "left"]),
        ("turn left and stop", ["turn left and stop", "left and stop"]),
        ("nurse bot turn left", []),
        ("the orchestra played", []),
    ],
)
def test_a_command_as_it_would_be_after_a_wake_word(called, text, rests):
    found = [" ".join(words) for words in called.woken(text.split())]
    assert [one for one in found if one.startswith(WAKE[0])] == [f"{WAKE[0]} {rest}" for rest in rests]
    assert len(found) == len(WAKE) * len(rests)


@given(
    st.lists(
        st.sampled_from(["nurse", "bot", "do", "not", "never", "please", "turn", "go", "left", "back", "and", "then"]),
        max_size=7,
    )
)
def test_what_is_compared_is_for_the_robot_and_means_the_same(called, words):
    asked = called.parse(" ".join(words)).actions
    for one in called.woken(words):
        assert called.wake().addressed(one)
        actions = called.parse(" ".join(one)).actions
        assert actions
        assert not asked or actions == asked


def test_first_words_that_are_unlike_a_wake_word_may_have_been_one(called, plain):
    heard = ["but", "he", "turn", "left"]
    assert ("nurse", "bot", "turn", "left") in called.near(heard)
    assert not [words for words in plain.near(heard) if "nurse" in words]


def test_a_command_for_the_robot_is_only_forbidden_to_the_robot(called):
    found = {" ".join(words) for words in forbidden(called, ["nurse", "bot", "please", "turn", "left"])}
    assert found == {f"nurse bot please {no} turn left" for no in ("don't", "do not", "never")}


def test_what_is_not_for_the_robot_is_another_meaning_and_less_likely(called):
    woken, alone = ("nurse", "bot", "turn", "left"), ("turn", "left")
    views = {one: [View(-2.0, -1.0, 0.0, words=3)] for one in (alone, woken)}
    first, second = ranked(called, views)
    assert first.words == woken
    assert 0 < second.behind == first.evidence.margin


def test_a_stop_is_as_likely_without_a_wake_word(called, plain):
    views = {one: [View(-2.0, -1.0, 0.0, words=3)] for one in (("stop",), ("nurse", "bot", "turn", "left"))}
    views[("stop",)] = [View(-1.9, -1.0, 0.0, words=3)]
    for grammar in (called, plain):
        first, second = ranked(grammar, views)
        assert first.words == ("stop",)
        assert second.behind == pytest.approx(0.1)


class _Pieces:
    def encode(self, text: str) -> list[int]:
        return [0] * len(text)


def test_a_comma_may_follow_a_wake_word(called):
    names = Names(_Pieces(), {}, called.wake().phrases)
    spelled = spellings(["hey", "nurse", "go", "two", "meters"], "en", names)
    assert ("hey", "nurse,", "go", "2", "meters") in spelled
    assert ("hey", "nurse", "go", "two", "meters") in spelled
    assert not [one for one in spellings(["go", "hey", "nurse"], "en", names) if "nurse," in one]


def test_a_grammar_of_no_wake_words_knows_none(plain):
    assert isinstance(plain.wake(), WakeWords)
    assert plain.wake().phrases.at(["robot"], 0) == 0


@pytest.mark.parametrize(
    ("text", "stops"),
    [
        ("stop", True),
        ("stop turning left", True),
        ("please stop rolling", True),
        ("nurse bot stop rolling", True),
        ("turn left", False),
        ("do not stop", False),
        ("she told him to stop rolling", False),
        ("turn left and stop rolling", False),
    ],
)
def test_no_sentence_that_stops_needs_the_wake_word(text, stops):
    maps = ROOT / "locations" / "home.yaml"
    engine = IntentEngine.from_files(ROOT / "grammars" / "en.yaml", locations=maps, wake=WAKE)
    found = engine.parse(text, spoken=True)
    assert found.stops is stops
    assert stops or not found.actions
