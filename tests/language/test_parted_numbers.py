"""Free words take no half of what is counted: of "two or three eggs" nobody knows how many."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine, Status

GRAMMAR = """
language: en
slots:
  thing: text
  count: {type: number, max: 99}
  time: duration
intents:
  stir: {action: custom, sentences: ["stir [[the] {thing}] [for {time}]"]}
  add: {action: custom, sentences: ["add {count} {thing}"]}
  play: {action: custom, sentences: ["play {thing} [for {time}]"]}
"""
NUMBERS = ("two", "3", "seven", "twelve", "40", "twenty one")


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@given(
    first=st.sampled_from(NUMBERS),
    joint=st.sampled_from([" or ", " to ", ", ", " maybe ", ", perhaps "]),
    other=st.sampled_from(NUMBERS),
)
def test_of_two_numbers_none_is_taken(engine: IntentEngine, first: str, joint: str, other: str) -> None:
    for said in (f"add {first}{joint}{other} eggs", f"stir the soup for {first}{joint}{other} minutes"):
        assert not engine.parse(said).actions, said


@pytest.mark.parametrize(
    "said", ["stir for two", "stir for ages", "stir for 2-3 minutes", "stir for two to three minutes"]
)
def test_what_a_sentence_has_itself_begins_no_name(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("add two eggs", {"count": 2, "thing": "eggs"}),
        ("add two three meter cables", {"count": 2, "thing": "three meter cables"}),
        ("add 2 3-inch nails", {"count": 2, "thing": "3 inch nails"}),
        ("add twenty one eggs", {"count": 21, "thing": "eggs"}),
        ("stir the soup for two minutes", {"thing": "soup", "time": 120}),
        ("play seven to three for two minutes", {"thing": "seven to three", "time": 120}),
        ("play for the road", {"thing": "for the road"}),
    ],
)
def test_a_number_in_a_name_is_part_of_it(engine: IntentEngine, said: str, slots: dict[str, object]) -> None:
    found = engine.parse(said)
    assert found.status is Status.ACCEPTED, found.reason
    assert found.slots == slots


def test_a_slot_that_allows_the_word_begins_with_it(engine_of) -> None:
    grammar = GRAMMAR.replace("thing: text", "thing: {type: text, allow: [for]}")
    assert engine_of(grammar).parse("stir for ages").slots == {"thing": "for ages"}


def test_german_ranges_are_none_either(engine_of) -> None:
    slots = "language: de\nslots: {count: number, thing: text}\n"
    engine = engine_of(slots + 'intents:\n  nimm: {action: custom, sentences: ["nimm {count} {thing}"]}\n')
    assert engine.parse("nimm zwei Eier").actions
    for said in ("nimm zwei oder drei Eier", "nimm zwei bis drei Eier"):
        assert not engine.parse(said).actions, said
