"""An article before a name, of which the grammar writes none."""

from __future__ import annotations

import pytest

from intent_engine.language.locations import LocationMap
from intent_engine.language.template import parse_template
from intent_engine.language.templates.led_names import led
from intent_engine.language.templates.template_tree import template_text
from intent_engine.language.words.thing_words import ARTICLES
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

CAMERA = """
language: en
phrases: {at: "of {thing}"}
slots:
  thing: [crack, roof, solar panel]
  count: {type: number, whole: true}
  side: [left, right]
intents:
  photograph: {action: custom, sentences: ["photograph {thing}", "take {count} pictures {at}"]}
  turn: {action: {type: turn, direction: "{side}"}, sentences: ["turn {side}"]}
"""


@pytest.mark.parametrize(
    ("template", "with_articles"),
    [
        ("see {thing}", "see ([the] {thing})"),
        ("see [a] {thing}", "see [a] {thing}"),
        ("see [the] [big] {thing}", "see [the] [big] {thing}"),
        ("see (the|some) ({thing}|{count})", "see (the|some) ({thing}|{count})"),
        ("see {count} {thing}", "see {count} {thing}"),
        ("[a] ([big];[red]) {thing}", "[a] ([big]; [red]) {thing}"),
        ("see [{count}] {thing}", "see (([the] {thing})|{count} ({thing}))"),
        ("[the] ([{thing}] light)", "[the] ([{thing}] light)"),
        ("see [{thing}] (now;at {thing:other})", "see [[the] {thing}] (now; at ([the] {thing:other}))"),
    ],
)
def test_it_stands_where_none_is_written_and_no_number(template, with_articles):
    assert template_text(led(parse_template(template), {"thing": {"the"}}, {"count"}, ARTICLES)) == with_articles


@pytest.mark.parametrize(
    ("heard", "said"),
    [
        ("fold the graph the crack", "photograph the crack"),
        ("take three pictures on the roof", "take three pictures of the roof"),
        ("turn left", "turn left"),
    ],
)
def test_speech_is_compared_with_names_that_have_one(engine_of, heard, said):
    assert tuple(said.split()) in SpokenGrammar(engine_of(CAMERA)).near(heard.split())


def test_a_direction_has_none(engine_of):
    the_left = ["turn", "the", "left"]
    assert tuple(the_left) not in SpokenGrammar(engine_of(CAMERA)).near(the_left)


DRINKS = """
language: en
slots:
  drink: [coffee, milk, orange juice]
  size: [small, large]
intents:
  bring: {action: custom, sentences: ["i would like {drink}", "i want {size} {drink}"]}
"""
WARD = """
language: en
slots:
  place: [lab, intensive care unit, main pharmacy store room]
  item: [saline, bandages]
intents:
  fetch:
    action: custom
    sentences: ["go to {place}", "get {item} from {place:origin} and bring it to {place}"]
"""


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("go to the intensive care unit", {"place": "intensive care unit"}),
        ("go to the intensiv care unit", {"place": "intensive care unit"}),
        ("go to the main farmacy store room", {"place": "main pharmacy store room"}),
        (
            "get the saline from the lab and bring it to the intensive care unit",
            {"item": "saline", "origin": "lab", "place": "intensive care unit"},
        ),
    ],
)
def test_a_name_is_understood_with_an_article_however_long_and_wherever(engine_of, said, slots):
    assert dict(engine_of(WARD).parse(said).slots) == slots


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("i would like a coffee", True),
        ("i would like an orange juice", True),
        ("i would like a cofee", True),
        ("i would not like a cofee", False),
        ("if i would like a cofee", False),
        ("i would like some milk", True),
        ("i would like two milk", False),
        ("i would like no milk", False),
        ("i want a large milk", True),
    ],
)
def test_whatever_the_article_is_and_where_nothing_is_guessed(engine_of, said, done):
    assert bool(engine_of(DRINKS).parse(said).actions) is done


def test_an_article_that_a_value_begins_with_is_its_own(engine_of):
    latte = engine_of(
        "language: en\nslots: {milk: [milk, some milk]}\nintents:\n  order: {action: custom, sentences: "
        "['i want {milk}']}\n"
    )
    for said in ("milk", "some milk"):
        assert latte.parse(f"i want {said}").slots == {"milk": said}
    assert latte.parse("i want the milk").slots == {"milk": "milk"}


def test_nor_one_that_a_place_begins_with(engine_of):
    bays = LocationMap.from_mapping({name: (float(at), 0.0) for at, name in enumerate(("12", "a 12", "office"))})
    engine = engine_of(
        "language: en\nslots: {location: location}\nintents:\n  go: {action: navigate, sentences: "
        "['visit {location}']}\n",
        locations=bays,
    )
    for said in ("12", "a 12", "office"):
        assert engine.parse(f"visit {said}").slots == {"location": said}
    assert engine.parse("visit the office").slots == {"location": "office"}


def test_german_articles(engine_of):
    german = engine_of(
        "language: de\nslots: {getränk: [kaffee, milch]}\nintents:\n  bring: {action: custom, sentences: "
        "['ich möchte {getränk}']}\n"
    )
    assert german.parse("ich möchte einen Kaffee").actions
    assert not german.parse("ich möchte keinen Kaffee").actions
