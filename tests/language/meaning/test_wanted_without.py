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
  dish: {{type: text, max_words: 3}}
  guest: [Anna, Tom]
intents:
  brew: {{action: custom, sentences: ["make me a {{drink}} [with [the] {{extra}}]"]}}
  sweeten: {{action: custom, sentences: ["sweeten it with {{count}} sugars"]}}
  bake: {{action: custom, sentences: ["bake a pizza with {{topping}}"]}}
  cook:
    action: custom
    sentences: ["cook [the] {{dish}} [for {{guest}}]"]
    then: ["the {{dish}}"]
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
        "cook pasta, no cheese",
        "cook pasta no cheese",
        "cook the red beans, no bacon",
        "cook the red beans, no green beans",
        "cook pasta for Anna, no cheese",
        "cook pasta for Anna, no rice for Tom",
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
        ("make me a coffee, no tea", {"drink": "tea"}),
        ("cook pasta, no, cheese", {"dish": "cheese"}),
        ("cook pasta, no the beans", {"dish": "beans"}),
        ("cook the pasta, no cook cheese", {"dish": "cheese"}),
        ("cook pasta, I mean cheese", {"dish": "cheese"}),
        ("cook pasta for Anna, no Tom", {"dish": "pasta", "guest": "Tom"}),
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


@pytest.mark.parametrize("said", ["prepara un caffè con latte, no zucchero", "prepara un caffè con latte no zucchero"])
def test_italian_has_things_with_others(engine_of, said: str) -> None:
    engine = engine_of(
        "language: it\nslots: {extra: [latte, zucchero]}\n"
        "intents: {brew: {action: custom, sentences: ['prepara un caffè con {extra}']}}\n"
    )
    assert engine.parse(said).status is Status.AMBIGUOUS
    assert engine.parse("prepara un caffè con latte, no, con zucchero").slots == {"extra": "zucchero"}


THINGS = st.lists(st.sampled_from(("cheese", "red", "beans", "rice")), min_size=1, max_size=3).map(" ".join)


@given(first=THINGS, other=THINGS, pause=st.sampled_from(["", ","]), article=st.sampled_from(["", "the "]))
def test_no_free_thing_is_taken_for_another_in_one_breath_with_a_no(
    engine: IntentEngine, first: str, other: str, pause: str, article: str
) -> None:
    assert engine.parse(f"cook {article}{first}{pause} no {other}").status is Status.AMBIGUOUS
    corrected = engine.parse(f"cook {article}{first}{pause} no, {other}")
    assert corrected.slots == {"dish": other}, corrected.reason
