"""Commands that do the opposite of another."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.language.words.opposites import opposed
from intent_engine.speech.hypotheses.opposing import MOST_OPPOSED, opposing
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.ways import opposite_ways


def against(grammar: SpokenGrammar, text: str, heard: str | None = None, language: str | None = None) -> list[str]:
    words = text.split()
    return [" ".join(one) for one in grammar.opposing(words, [(heard or text).split()], language)]


@pytest.mark.parametrize(
    ("text", "opposite"),
    [
        ("move forward one meter", "move backward one meter"),
        ("step up six inches", "step back six inches"),
        ("turn right for two seconds", "turn left for two seconds"),
        ("go to the kitchen and turn left", "go to the kitchen and turn right"),
    ],
)
def test_a_motion_the_other_way_is_one(engine, grammar, text, opposite):
    found = against(grammar, text, opposite)
    assert found[0] == opposite, "the likest to what was heard comes first"
    actions = engine.parse(text).actions
    assert all(opposite_ways(actions, engine.parse(one).actions) for one in found)
    assert len(found) <= MOST_OPPOSED


@pytest.mark.parametrize("text", ["stop", "wait", "don't move", "go to the kitchen", "hello there", "follow me"])
def test_what_goes_no_way_has_none(grammar, text):
    assert against(grammar, text) == []


LAMP = """
language: en
slots: {level: {type: number, min: 0, max: 10}}
intents:
  switch: {action: custom, sentences: ["turn the lamp {state}"]}
  open: {action: custom, sentences: ["(open|close) the valve", "(raise|wash) the blind"]}
  level: {action: custom, sentences: ["dim to {level}"]}
"""


def test_words_that_mean_the_opposite_are_so_in_any_domain(engine_of):
    lamp = SpokenGrammar(
        engine_of(LAMP.replace("slots: {", "slots: {state: {type: choice, values: {'on': ['on'], 'off': ['off']}}, "))
    )
    assert against(lamp, "turn the lamp on") == ["turn the lamp off"]
    assert against(lamp, "dim to five") == []
    assert "close" in opposed("open")
    # Both are one command that takes no slot of it, so that neither does anything else.
    assert against(lamp, "open the valve") == []
    assert against(lamp, "raise the blind") == []


def test_in_german_too(root):
    engine = IntentEngine.from_files(root / "grammars/de.yaml", locations=root / "locations/zuhause.yaml")
    assert "fahr zurück" in against(SpokenGrammar(engine), "fahr vorwärts", "fahr zurück", "de")


def test_how_far_says_nothing_of_which_way(engine, grammar):
    """To ask of every number and unit that may be said what it means took up to a second."""
    words = ["go", "back", "two", "meters", "at", "half", "speed"]
    asked = []

    def parse(text):
        asked.append(text.split())
        return engine.parse(text)

    assert opposing(grammar.search(), parse, words, [words])
    assert {"two", "meters", "half", "speed"} <= set.intersection(*map(set, asked))
