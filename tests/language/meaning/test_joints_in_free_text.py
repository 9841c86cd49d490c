"""Words that join are no end of a name: what follows them is another command, or none is done."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine

GRAMMAR = """
language: {language}
slots:
  food: {{type: text, max_words: 4, known: [rice, peas], allow: [and]}}
  song: {{type: text, max_words: 5, allow: [and, i]}}
  name: {{type: text, max_words: 2}}
intents:
  cook: {{action: custom, sentences: ["cook [{{food}}]"]}}
  play: {{action: custom, sentences: ["play {{song}}"]}}
  greet: {{action: custom, sentences: ["greet {{name}}"]}}
  rest: {{action: custom, sentences: [rest, "wash up"]}}
"""
FIRST = ["cook rice", "cook rice and peas", "cook", "play yesterday", "greet Anna"]
SECOND = st.sampled_from(["rest", "wash up", "greet Tom"])


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR.format(language="en"))


@given(st.sampled_from(FIRST), SECOND, st.sampled_from(["and then", "then", "and after that", ", then"]))
def test_no_name_takes_what_joins(engine, first, second, joint):
    both = (*engine.parse(first).actions, *engine.parse(second).actions)
    assert len(both) == 2
    assert engine.parse(f"{first} {joint} {second}").actions == both


@given(st.sampled_from(FIRST), SECOND)
def test_of_two_of_which_one_is_wanted_none_is_done(engine, first, second):
    found = engine.parse(f"{first} or {second}")
    assert len(found.actions) < 2  # a song may be called "yesterday or rest"
    if first != "play yesterday":
        assert not found.actions


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("cook rice and peas", {"food": "rice and peas"}),
        ("play and I love her", {"song": "and i love her"}),
        ("greet Anna or Tom", None),
        ("cook and", None),
        ("cook rice and", None),
        ("play salt and", None),
        ("greet Anna or", None),
    ],
)
def test_names_with_such_words(engine, said, slots):
    found = engine.parse(said)
    assert (dict(found.slots) if found.actions else None) == slots


def test_german(engine_of):
    assert not engine_of(GRAMMAR.format(language="de")).parse("greet Anna oder rest").actions
