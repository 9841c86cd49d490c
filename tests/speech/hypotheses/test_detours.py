"""Sentences that differ in a few words at one place: laws over sentences of real grammars."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from meanings import shipped
from speech_stage import ROOT

from intent_engine.engine import IntentEngine
from intent_engine.speech.hypotheses.detours import LEFT_OUT, MOST, WORDS, Detours, leads
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.testing.strategies import sentences

COFFEE = IntentEngine.from_files(ROOT / "examples" / "coffee" / "coffee.yaml")
ROBOT = shipped()


def detours(engine: IntentEngine, sentence: str, place: int, other: str) -> list[str]:
    """The sentences with a detour at a place."""
    search = SpokenGrammar(engine).search("en")
    words = sentence.split()
    state = search.graph.start()
    for word in words[:place]:
        state = search.graph.step(state, word)
    return [" ".join((*words[:place], *end)) for end in Detours(search).ways(state, other, words[place:])]


@pytest.mark.parametrize(
    ("engine", "sentence", "place", "other", "said"),
    [
        (COFFEE, "an triple shot mocha", 0, "make", "make me triple shot mocha"),
        (COFFEE, "make me a triple shot mocha with milk", 5, "iced", "make me a triple shot iced mocha with milk"),
        (COFFEE, "a latte with milk", 1, "dark", "a dark roast latte with milk"),
        (COFFEE, "a dark roast latte with milk", 1, "latte", "a latte with milk"),
        (COFFEE, "a latte with a lot of sugar", 3, "sugar", "a latte with sugar"),
        (COFFEE, "a latte with a lot of sugar", 3, "some", "a latte with some sugar"),
        (ROBOT, "drive ahead for two feet", 2, "forty", "drive ahead forty feet"),
        (ROBOT, "pick up the blue box", 2, "it", "pick up it"),
    ],
)
def test_what_was_said_is_on_the_way(engine, sentence, place, other, said):
    assert said in detours(engine, sentence, place, other)


def test_an_article_more_is_no_other_thing():
    assert "a a latte" not in detours(COFFEE, "a latte", 0, "a")


@settings(max_examples=60, deadline=None)
@given(st.data())
@pytest.mark.parametrize("engine", [COFFEE, ROBOT], ids=["coffee", "robot"])
def test_every_detour_is_a_sentence_that_differs_in_one_place(engine, data):
    words = tuple(data.draw(sentences(engine)).text.lower().split())
    search = SpokenGrammar(engine).search("en")
    place = data.draw(st.integers(0, len(words) - 1))
    state = search.graph.start()
    for word in words[:place]:
        state = search.graph.step(state, word) if state is not None else None
    if state is None:
        return  # as it is written: figures, capitals
    rest = words[place:]
    other = data.draw(st.sampled_from([word for word in search.words_after(state)[0] if word != rest[0]] or [None]))
    if other is None:
        return
    found = Detours(search).ways(state, other, rest)
    assert len(set(found)) == len(found) <= MOST + LEFT_OUT
    for end in found:
        assert leads(search.graph, state, end)
        assert end != rest
        assert end[0] == other
        same = next((count for count in range(len(rest) + 1) if end[len(end) - len(rest) + count :] == rest[count:]), 0)
        assert same <= LEFT_OUT
        assert len(end) - (len(rest) - same) <= WORDS
