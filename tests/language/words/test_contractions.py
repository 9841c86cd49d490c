"""English words that are mostly said as one mean the same either way, and deny nothing."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.language.words.contractions import apart, together

ROOM = """
language: en
slots:
  person: [Anna, Tom]
intents:
  ask: {action: {type: custom, name: ask}, sentences: ["what is the battery level", "where is {person}"]}
  greet: {action: {type: custom, name: greet}, sentences: ["what's up", "how are you"]}
  order: {action: {type: custom, name: order}, sentences: ["(I would|you'll) like (tea|coffee)"]}
  quieter: {action: {type: custom, name: quieter}, sentences: ["(it's|the music's) too loud", "I am trying to sleep"]}
  lid: {action: {type: custom, name: lid}, sentences: ["open its lid", "(is it|it is) open"]}
"""
WORDS = st.text("abcdefghilmnorstuvwy", min_size=1, max_size=7)


@pytest.fixture(scope="module")
def room(engine_of) -> IntentEngine:
    return engine_of(ROOM)


@pytest.mark.parametrize(
    ("said", "written"),
    [
        ("what's the battery level", "what is the battery level"),
        ("what is up", "what's up"),
        ("where's Anna", "where is anna"),
        ("I'd like tea", "i would like tea"),
        ("you will like tea", "you'll like tea"),
        ("it is too loud", "it's too loud"),
        ("the music is too loud", "the music's too loud"),
        ("I'm trying to sleep", "i am trying to sleep"),
        ("it's open", "it is open"),
    ],
)
def test_a_sentence_is_the_same_either_way(room, said, written):
    found = room.parse(said)
    assert found.actions == room.parse(written).actions != ()
    assert found.confidence == 1.0
    assert room.prefix(said).status is room.prefix(written).status


@pytest.mark.parametrize(
    "text",
    ["I'd not like tea", "I wouldn't like tea", "what's not the battery level", "what's level", "wells"],
)
def test_nothing_else_is_a_sentence_so(room, text):
    assert not room.parse(text).actions


@given(WORDS, WORDS)
def test_what_is_said_as_one_is_again_what_it_was(first, second):
    one = together(first, second)
    assert one is None or (first, second) in apart(one)


@given(WORDS)
def test_what_is_apart_is_again_that_word(word):
    assert all(together(*parts) == word for parts in apart(word))
