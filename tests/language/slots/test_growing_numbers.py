"""A number that no word can make another one is over: after "table fourteen" of forty there is nothing to wait for."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.language.numbers.spelled import in_words

TABLES = """
language: en
slots:
  table: {type: number, min: 1, max: 40, whole: true}
  room: {type: number, min: 100, max: 499, whole: true}
  level: {type: number, min: 0, max: 10}
  floor: {type: number, min: -30, max: 30, whole: true}
  turns: {type: number, min: 1, max: 99, whole: true}
intents:
  clear: {action: custom, sentences: ["clear table {table}"]}
  clean: {action: custom, sentences: ["clean room {room}"]}
  dim: {action: custom, sentences: ["dim to {level}"]}
  heat: {action: custom, sentences: ["heat table {table} [to {level}]"]}
  ride: {action: custom, sentences: ["ride to {floor}"]}
  wind: {action: custom, sentences: ["wind it {turns} [times]"]}
"""
TISCHE = """
language: de
slots: {tisch: {type: number, min: 1, max: 40, whole: true}}
intents: {raeume: {action: custom, sentences: ["räume tisch {tisch} ab", "decke tisch {tisch}"]}}
"""


@pytest.fixture(scope="module")
def tables(engine_of) -> IntentEngine:
    return engine_of(TABLES)


@pytest.mark.parametrize(
    ("text", "over"),
    [
        ("clear table fourteen", True),
        ("clear table 14", True),
        ("clear table eight", True),  # "eight quarters" are two, and nobody rests in them
        ("clear table forty", True),
        ("clear table twenty two", True),
        ("clear table twenty", False),
        ("clear table 20", False),
        ("clear table two", True),  # "two dozen" is said in one piece
        ("clear table", False),
        ("clean room two hundred", False),
        ("clean room two thirty", False),
        ("clean room two fourteen", True),
        ("clean room two hundred thirty one", True),
        ("clean room 118", True),
        ("ride to minus twenty", False),
        ("ride to minus twelve", True),
        ("dim to eight", False),  # "eight point five"
        ("heat table fourteen", False),
        ("wind it twelve", True),  # "times" changes nothing
        ("clear table fourteen for me", True),
    ],
)
def test_a_number_is_over_when_no_word_makes_another_of_it(tables: IntentEngine, text: str, over: bool) -> None:
    assert tables.prefix(text).settled is over


@pytest.mark.parametrize(
    ("text", "over"), [("decke tisch zwölf", True), ("decke tisch einunddreißig", True), ("räume tisch zwölf", False)]
)
def test_so_it_is_in_other_languages(engine_of, text: str, over: bool) -> None:
    assert engine_of(TISCHE).prefix(text).settled is over


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(["clear table", "clean room"]), st.integers(1, 499), st.integers(1, 499))
def test_no_number_is_over_that_is_the_beginning_of_another(
    tables: IntentEngine, verb: str, one: int, other: int
) -> None:
    begun, whole = (in_words([str(number)]) for number in (one, other))
    said = [tables.parse(f"{verb} {' '.join(words)}").actions for words in (begun, whole)]
    if all(said) and whole[: len(begun)] == begun and len(whole) > len(begun):
        assert not tables.prefix(f"{verb} {' '.join(begun)}").settled
