"""Which one of several, without its noun: "the red cup and the blue one", "die rote Tasse, nein, die blaue"."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine.actions import Pick, Place
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation
from intent_engine.language.words.thing_words import thing_words

QUALITIES = sorted(thing_words("en").qualities)
NOUNS = ["cup", "ball", "tool box"]


def things(found: Interpretation) -> list[str]:
    return [action.object for action in found.actions if isinstance(action, Pick | Place)]


@pytest.fixture(scope="module")
def german(root) -> IntentEngine:
    return IntentEngine.from_files(root / "grammars" / "de.yaml", locations=root / "locations" / "home.yaml")


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("pick up the red cup and the blue one", ["red cup", "blue cup"]),
        ("take the red cup and put the blue one on the table", ["red cup", "blue cup"]),
        ("pick up the big red cup, then pick up the small blue one", ["big red cup", "small blue cup"]),
        ("take the red cup, no, the blue", ["blue cup"]),
        ("take the red cup, no, the blue plate", ["blue plate"]),
        # Nobody knows of which noun, or that there is one.
        ("pick up the blue one", ["blue one"]),
        ("pick up the cup of tea and the big one", ["cup of tea", "big one"]),
        ("pick up box two and the blue one", ["box two", "blue one"]),
        ("pick up the red one and the blue one", ["red one", "blue one"]),
        ("pick up the cup, then pick up box one", ["cup", "box one"]),
    ],
)
def test_it_is_that_of_the_thing_before(text, named):
    assert things(shipped().parse(text)) == named


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("nimm die rote Tasse, nein, die blaue", ["blaue tasse"]),
        ("nimm den roten Ball, ich meine den blauen", ["blauen ball"]),
        ("nimm die rote Tasse und die blaue", ["rote tasse", "blaue tasse"]),
        ("nimm die rote Tasse, nein, die Flasche", ["flasche"]),
        ("nimm die Tasse, nein, die blaue Flasche", ["blaue flasche"]),
    ],
)
def test_in_german_without_a_word_for_it(german, text, named):
    assert things(german.parse(text)) == named


def test_it_may_have_been_named_by_the_utterance_before():
    first = shipped().parse("pick up the red cup")
    assert things(shipped().parse("pick up the blue one", last=first)) == ["blue cup"]
    assert things(shipped().parse("and the blue one", last=first)) == ["blue cup"]


def test_a_colour_of_a_list_is_no_thing(engine_of):
    engine = engine_of(
        """
        language: en
        slots: {colour: [red, blue], thing: object}
        intents: {paint: {action: custom, sentences: ["paint [the] {thing} [the] {colour}"]}}
        """
    )
    (action,) = engine.parse("paint the old wall red, no, blue").actions
    assert dict(action.slots) == {"thing": "old wall", "colour": "blue"}


@given(st.sampled_from(QUALITIES), st.sampled_from(QUALITIES), st.sampled_from(NOUNS))
def test_said_with_its_noun_it_is_the_same(one, other, noun):
    short = shipped().parse(f"pick up the {one} {noun}, then pick up the {other} one")
    whole = shipped().parse(f"pick up the {one} {noun}, then pick up the {other} {noun.split()[-1]}")
    if short.actions and whole.actions:
        assert things(short) == things(whole)
