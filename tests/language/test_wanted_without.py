""" "With milk, no sugar" may say that there shall be none. Nobody knows, so nothing is done."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine, Status

EXTRAS = ("milk", "sugar", "oat milk", "lemon")
GRAMMAR = f"""
language: en
slots:
  drink: [coffee, tea]
  extra: [{", ".join(EXTRAS)}]
  count: {{type: number, whole: true}}
  topping: {{type: text, max_words: 2}}
intents:
  brew: {{action: custom, sentences: ["make me a {{drink}} [with [the] {{extra}}]"]}}
  sweeten: {{action: custom, sentences: ["sweeten it with {{count}} sugars"]}}
  bake: {{action: custom, sentences: ["bake a pizza with {{topping}}"]}}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    "said",
    [
        "make me a coffee with milk no sugar",
        "make me a coffee with milk, no sugar",
        "make me a coffee with the milk, no sugar please",
        "make me a tea with milk no lemon no sugar",
        "bake a pizza with cheese, no onions",
    ],
)
def test_it_is_asked_whether_there_shall_be_none(engine: IntentEngine, said: str) -> None:
    found = engine.parse(said)
    assert (found.status, found.actions) == (Status.AMBIGUOUS, ())
    assert "there shall be none" in found.reason


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("make me a coffee with milk, no, sugar", {"drink": "coffee", "extra": "sugar"}),
        ("make me a coffee with milk no with sugar", {"drink": "coffee", "extra": "sugar"}),
        ("make me a coffee with milk no wait sugar", {"drink": "coffee", "extra": "sugar"}),
        ("make me a coffee with milk no the sugar", {"drink": "coffee", "extra": "sugar"}),
        ("make me a coffee with milk I mean sugar", {"drink": "coffee", "extra": "sugar"}),
        ("make me a coffee no tea", {"drink": "tea"}),
        ("sweeten it with two sugars no three", {"count": 3}),
    ],
)
def test_what_can_only_correct_does(engine: IntentEngine, said: str, slots: dict[str, object]) -> None:
    found = engine.parse(said)
    assert found.status is Status.ACCEPTED, found.reason
    assert found.slots == slots


@given(first=st.sampled_from(EXTRAS), other=st.sampled_from(EXTRAS), pause=st.sampled_from(["", ","]))
def test_nothing_is_brewed_with_what_may_be_unwanted(engine: IntentEngine, first: str, other: str, pause: str) -> None:
    found = engine.parse(f"make me a coffee with {first}{pause} no {other}")
    assert not found.actions or found.slots["extra"] == first
