"""Who is spoken to is no part of a thing: "put it on the table, Ben" is said to Ben, and no table is called so."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import does

from intent_engine import IntentEngine

GRAMMAR = """
language: {language}
slots:
  thing: {{type: object, max_words: 4}}
  drink: {{type: text, max_words: 3, known: [bottle, coke]}}
  song: {{type: text, max_words: 4}}
  note: {{type: text, dictation: true}}
intents:
  fetch: {{action: custom, sentences: ["{fetch} {{thing}}"]}}
  pour: {{action: custom, sentences: ["pour {{drink}}"]}}
  play: {{action: custom, sentences: ["play {{song}}"]}}
  note: {{action: custom, sentences: ["note {{note}}"]}}
"""
NAMES = st.sampled_from(["Ben", "Anna", "Mrs Miller", "Mr. Jones", "Robbie"])


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR.format(language="en", fetch="fetch"))


@given(
    st.sampled_from(["put it on the table", "pick up that", "drop the cup", "look at the door", "bring me those"]),
    NAMES,
    st.sampled_from(["", ".", "!", ", please", " please."]),
)
def test_nothing_is_called_like_who_is_spoken_to(order: str, name: str, end: str) -> None:
    assert does(f"{order}, {name}{end}") in ("rejected", "incomplete")


@pytest.mark.parametrize("said", ["fetch the cup, Ben", "Fetch the cup, Ben, and fetch the plate", "fetch this, Anna!"])
def test_of_any_thing(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


@pytest.mark.parametrize(
    ("said", "value"),
    [
        ("fetch the big, red cup", "big red cup"),
        ("Fetch The Big, Red Cup", "big red cup"),
        ("FETCH THE BIG, RED CUP", "big red cup"),
        ("fetch Ben", "ben"),
        ("fetch the cup of Ben", "cup of ben"),
        ("fetch the old, Swiss knife", "old swiss knife"),
        ("pour the cold, Coke", "cold coke"),
        ("play yesterday, Paul", "yesterday paul"),
        ("note bring water, Ben", "bring water, Ben"),
    ],
)
def test_what_is_a_name_is_kept(engine: IntentEngine, said: str, value: str) -> None:
    assert list(engine.parse(said).slots.values()) == [value]


def test_german_nouns_have_a_capital(engine_of) -> None:
    german = engine_of(GRAMMAR.format(language="de", fetch="hol"))
    assert german.parse("hol die kleine, Tasse").slots == {"thing": "kleine tasse"}
