"""An article before a name, of which the grammar writes none."""

from __future__ import annotations

import pytest

from intent_engine.language.led_names import led
from intent_engine.language.template import parse_template
from intent_engine.language.template_tree import template_text
from intent_engine.language.thing_words import thing_words
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
        ("[the] ([{thing}] light)", "[the] ([{thing}] light)"),
        ("see [{thing}] (now;at {thing:other})", "see [[the] {thing}] (now; at ([the] {thing:other}))"),
    ],
)
def test_it_stands_where_none_is_written_and_no_number(template, with_articles):
    assert template_text(led(parse_template(template), {"thing"}, {"count"}, thing_words("en"))) == with_articles


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


def test_no_other_article_is_part_of_a_sentence(engine_of):
    assert not engine_of(WARD).parse("get a saline from some lab and bring it to the lab").actions
