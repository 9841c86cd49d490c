"""Where a name of free words ends that a dictated text follows, "tell Anna dinner is ready"."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

GRAMMAR = """
language: en
slots:
  person: {type: text, max_words: 3, known: [night nurse]}
  message: {type: text, dictation: true}
intents:
  tell: {action: custom, sentences: ["tell {person} [that] {message}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "person", "message"),
    [
        ("tell Anna the linen is here", "anna", "the linen is here"),
        ("tell anna the linen is here", "anna", "the linen is here"),
        ("tell uh Anna my car is broken", "anna", "my car is broken"),
        ("tell Anna dinner is ready", "anna", "dinner is ready"),
        ("tell nurse Julia dinner is ready", "nurse julia", "dinner is ready"),
        ("tell nurse Julia: Peter is here", "nurse julia", "Peter is here"),
        ("tell Anna I'm late", "anna", "I'm late"),
        ("tell Anna to come", "anna", "to come"),
        ("tell night nurse dinner is ready", "night nurse", "dinner is ready"),
        ("tell Anna Miller that I'm here", "anna miller", "I'm here"),
    ],
)
def test_it_ends_where_no_name_goes_on(engine, said: str, person: str, message: str) -> None:
    (action,) = engine.parse(said).actions
    assert action.slots == {"person": person, "message": message}


@pytest.mark.parametrize(
    "said", ["tell Anna Peter is here", "tell the porter dinner is ready", "tell anna dinner is ready"]
)
def test_where_it_may_end_in_two_places_nobody_is_told(engine, said: str) -> None:
    found = engine.parse(said)
    assert not found.actions
    assert "pause before it" in found.reason
