"""Sentences from trees: the meaning is known before a word is spelled."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError
from intent_engine.language.locations import LocationMap
from intent_engine.language.sampler import RandomChoices, Sampler, sample

GRAMMAR = """
language: en
phrases:
  go: (go|drive)
slots:
  side: {type: choice, values: {left: [left, "to the left"], right: [right]}}
  distance: {type: distance, min: 1 m, max: 2 m}
  bay: {type: location, tags: [bay]}
  thing: {type: text, max_words: 3}
intents:
  slide:
    action: {type: custom, name: slide}
    sentences: ["{go} {side} [{distance}]", "({side};{distance};now)"]
  dock:
    action: {type: navigate, location: "{bay}"}
    sentences: ["{go} to {bay}"]
  take:
    action: {type: pick, object: "{thing}"}
    sentences: ["take the {thing}"]
  back:
    action: move
    sentences: [{say: "back [{distance}]", slots: {direction: backward}}]
"""
PLACES = {
    "bay 1": {"x": 1.0, "y": 2.0, "yaw": 0.0, "aliases": ["first bay"], "tags": ["bay"]},
    "kitchen": {"x": 5.0, "y": 2.0, "yaw": 0.0},
}


@pytest.fixture(scope="module")
def engine(engine_of):
    return engine_of(GRAMMAR, locations=PLACES)


def test_the_same_seed_gives_the_same_sentences(engine):
    first = sample(engine.grammar, engine.locations, 30, seed=7)
    assert first == sample(engine.grammar, engine.locations, 30, seed=7)
    assert first != sample(engine.grammar, engine.locations, 30, seed=8)


def test_every_part_of_the_grammar_is_said_with_its_meaning(engine):
    drawn = sample(engine.grammar, engine.locations, 400)
    assert {each.intent for each in drawn} == {"slide", "dock", "take", "back"}
    assert {each.sentence.text for each in drawn} == {
        sentence.text for intent in engine.grammar.intents.values() for sentence in intent.sentences
    }
    assert {each.slots["side"] for each in drawn if "side" in each.slots} == {"left", "right"}
    for each in drawn:
        assert each.text == " ".join(piece.text for piece in each.pieces)
        assert ("right" in each.text) == (each.slots.get("side") == "right")
        if "distance" in each.slots:
            assert 1.0 <= each.slots["distance"] <= 2.0, "the limits of the slot"
        if each.intent == "dock":
            assert each.slots["bay"] == "bay 1", "places of other tags are left out"
            assert each.actions[0].location == "bay 1"
        if each.intent == "take":
            assert each.slots["thing"] == each.actions[0].object == each.text.removeprefix("take the ")
        if each.intent == "back":
            assert each.slots["direction"] == "backward"
            assert each.actions[0].linear_velocity < 0


def test_parts_in_any_order(engine):
    drawn = [each for each in sample(engine.grammar, count=300, intent="slide") if "now" in each.text.split()]
    assert {each.text.split().index("now") == 0 for each in drawn} == {True, False}
    assert all({"side", "distance"} <= each.slots.keys() for each in drawn)


def test_the_parser_is_not_asked(engine, monkeypatch):
    from intent_engine.language.automaton import Automaton
    from intent_engine.language.meaning import Interpreter

    def asked(*_: object, **__: object) -> None:
        raise AssertionError("a sample that the parser made proves nothing about the parser")

    for owner, name in ((Interpreter, "interpret"), (Automaton, "walk"), (Automaton, "read"), (Automaton, "start")):
        monkeypatch.setattr(owner, name, asked)
    assert sample(engine.grammar, engine.locations, 50, seed=1)


def test_what_needs_a_map_is_left_out_without_one(engine):
    assert {each.intent for each in sample(engine.grammar, count=100)} == {"slide", "take", "back"}
    with pytest.raises(ConfigError, match="is a map missing"):
        sample(engine.grammar, intent="dock")
    assert sample(engine.grammar, LocationMap.from_mapping(PLACES), 1, intent="dock")


def test_free_text_avoids_the_words_of_the_grammar(root):
    engine = IntentEngine.from_files(root / "grammars" / "en.yaml")
    own = {"left", "right", "and", "stop", "please", "turn", "uh", "not"}
    for each in sample(engine.grammar, count=200, intent="pick"):
        for slots in [step["slots"] for step in each.slots.get("steps", ())] or [each.slots]:
            assert own.isdisjoint(str(slots["thing"]).split())


def test_the_first_choice_is_the_shortest(root):
    class First:
        def below(self, count: int) -> int:
            return 0

    engine = IntentEngine.from_files(root / "grammars" / "en.yaml")
    sampler = Sampler(engine.grammar)
    shortest = sampler.draw(First())
    drawn = [sampler.draw(RandomChoices(seed)) for seed in range(300)]
    assert all(len(shortest.text.split()) <= len(each.text.split()) for each in drawn)
