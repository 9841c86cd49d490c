"""Free words keep nothing for which a sentence has a place of its own."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine import IntentEngine

FARM = """
language: en
slots:
  file: {type: text, max_words: 4, known: [bracket, gear, vase]}
  song: {type: text, max_words: 6}
  stuff: [PLA, nylon]
  printer: {type: number, min: 1, max: 20, whole: true}
  copies: {type: number, min: 1, max: 9, whole: true}
  room: [kitchen, hall]
intents:
  print:
    action: custom
    sentences:
      - "print [the|a] {file} [in {stuff}] [on printer {printer}]"
      - "print {copies} copies of [the] {file} [in {stuff}]"
  play: {action: custom, sentences: ["play {song} [in the {room}]"]}
"""


@pytest.fixture(scope="module")
def farm(engine_of) -> IntentEngine:
    return engine_of(FARM)


@pytest.mark.parametrize(
    "said",
    [
        "print the bracket in black PLA", "print two copies of the vase in black PLA", "print the gear on it",
        "print the gear in it", "print the gear on the big printer 3", "play hello in the old kitchen",
    ],
)  # fmt: skip
def test_what_has_a_place_is_no_name(farm: IntentEngine, said: str) -> None:
    assert not farm.parse(said).actions


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("print the bracket in PLA on printer 3", {"file": "bracket", "stuff": "PLA", "printer": 3}),
        ("print the box with a lid", {"file": "box with a lid"}),
        ("print a vase in red", {"file": "vase in red"}),
        ("play singing in the rain", {"song": "singing in the rain"}),
        ("play singing in the rain in the hall", {"song": "singing in the rain", "room": "hall"}),
        ("play money on it", {"song": "money on it"}),
    ],
)
def test_a_name_may_have_such_words(farm: IntentEngine, said: str, slots: dict[str, object]) -> None:
    (action,) = farm.parse(said).actions
    assert dict(action.slots) == slots


@pytest.mark.parametrize("said", ["print a copy of the vase", "print another copy of the vase"])
def test_one_of_what_is_counted(farm: IntentEngine, said: str) -> None:
    assert_same(farm, said, "print one copy of the vase")


def test_an_article_counts_nothing_where_any_thing_follows(engine_of) -> None:
    grammar = """
language: en
slots: {count: {type: number, whole: true, max: 9}, thing: {type: text, max_words: 3}}
intents:
  bring: {action: custom, sentences: ["bring {thing}", "bring {count} {thing}"]}
"""
    (action,) = engine_of(grammar).parse("bring a box").actions
    assert dict(action.slots) == {"thing": "box"}


def test_the_reason_tells_which_words(farm: IntentEngine) -> None:
    assert "'in black pla' is no part of a name" in farm.parse("print the bracket in black PLA").reason
