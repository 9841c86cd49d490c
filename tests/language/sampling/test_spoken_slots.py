"""Slots to words."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.language.locations import LocationMap
from intent_engine.language.sampler import sample
from intent_engine.language.sampling.spoken_slots import SpokenSlots
from intent_engine.language.words.thing_words import thing_words

GRAMMAR = """
slots:
  bay: {type: location, tags: [bay]}
  far: {type: distance, min: 1 m, max: 2 m}
  thing: {type: text, max_words: 1}
  note: {type: text, max_words: 2, without: [blick]}
intents:
  go: {action: custom, sentences: ["go {far} to {bay}"]}
  take: {action: custom, sentences: ["take {thing}", "note {note}"]}
"""
PLACES = LocationMap.from_mapping(
    {
        "bay 1": {"x": 1.0, "y": 2.0, "aliases": ["first bay"], "tags": ["bay"]},
        "kitchen": {"x": 5.0, "y": 2.0},
    }
)


def test_each_way_has_its_value_and_the_shortest_is_first(engine_of):
    grammar = engine_of(GRAMMAR).grammar
    slots = SpokenSlots(grammar, PLACES, {"thing": ["lamp", "box"]})
    (places,) = slots.ways(grammar.slots["bay"])
    assert [tuple(place) for place in places] == [("bay 1", "bay 1"), ("first bay", "bay 1")]
    (things,) = slots.ways(grammar.slots["thing"])
    assert [tuple(thing) for thing in things] == [("box", "box"), ("lamp", "lamp")]
    assert all(1 <= value <= 2 for form in slots.ways(grammar.slots["far"]) for _, value in form)


def test_there_is_no_way_to_say_a_place_without_a_map(engine_of):
    grammar = engine_of(GRAMMAR).grammar
    assert SpokenSlots(grammar, None).ways(grammar.slots["bay"]) == ()


def test_free_text_keeps_the_bounds_of_its_slot(engine_of):
    grammar = engine_of(GRAMMAR).grammar
    for name, most in (("thing", 1), ("note", 2)):
        said = [text for form in SpokenSlots(grammar, None).ways(grammar.slots[name]) for text, _ in form]
        assert said
        assert max(len(text.removeprefix("the ").split()) for text in said) <= most, "an article does not count"
        assert not any("blick" in text.split() for text in said)


def test_free_text_has_no_word_that_the_grammar_uses_itself(engine_of):
    word = next(text for text in thing_words("en").examples if " " not in text)
    for sentence, avoided in (("take {thing}", False), (f"hug the {word} or {{thing}}", True)):
        grammar = engine_of(
            f"slots: {{thing: text}}\nintents: {{a: {{action: custom, sentences: ['{sentence}']}}}}"
        ).grammar
        (said,) = SpokenSlots(grammar, None).ways(grammar.slots["thing"])
        assert all(word not in text.split() for text, _ in said) is avoided


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
