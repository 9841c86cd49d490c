"""Sentences from trees: the meaning is known before a word is spelled."""

from __future__ import annotations

import math

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError
from intent_engine.language import quantities
from intent_engine.language.grammar import QUANTITY_KINDS
from intent_engine.language.locations import LocationMap
from intent_engine.language.normalize import tokenize
from intent_engine.language.quantities import Relative
from intent_engine.language.sampler import RandomChoices, Sampler, sample
from intent_engine.language.spoken_quantities import spoken_forms
from intent_engine.language.thing_words import thing_words

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


@pytest.mark.parametrize("language", ["en", "de", "es", "fr", "it"])
@pytest.mark.parametrize("kind", QUANTITY_KINDS)
def test_every_spelling_of_a_quantity_has_its_value(kind, language):
    unit = {"distance": "m", "angle": "deg"}.get(kind)
    forms = spoken_forms(kind, language, unit, None, None)
    assert forms
    wrong = []
    for form in forms:
        for text, value in form[:: 1 if len(form) < 300 else 7]:
            found = quantities.evaluate([token.word for token in tokenize(text)], kind, language, unit)
            if isinstance(value, Relative) or isinstance(found, Relative) or found is None:
                same = found == value
            else:
                same = math.isclose(found, value, rel_tol=1e-9)
            if not same:
                wrong.append((text, value, found))
    assert not wrong


def test_limits_hold_for_spellings():
    for form in spoken_forms("distance", "en", None, 0.5, 3.0):
        assert all(0.5 <= value <= 3.0 for _, value in form)
    assert spoken_forms("distance", "tlh", None, None, None) == ()


@pytest.mark.parametrize("language", ["en", "de", "fr", "es", "it"])
def test_things_are_called_in_the_language_of_the_grammar(tmp_path, language):
    path = tmp_path / "things.yaml"
    path.write_text(
        f"language: {language}\nslots: {{thing: object}}\n"
        "intents: {a: {action: custom, sentences: ['xyz {thing}']}}\n"
    )
    engine = IntentEngine.from_files(path)
    drawn = sample(engine.grammar, None, 400)
    assert {one.slots["thing"] for one in drawn} == set(thing_words(language).examples)
    assert all(engine.parse(one.text).slots == one.slots for one in drawn)
