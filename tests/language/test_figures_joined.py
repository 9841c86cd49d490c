"""Figures of two numbers with an "and" between them: two, where the grammar has two and they are none together."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

TABLES = """
language: en
slots:
  one: {type: number, min: 1, max: 300, whole: true}
  other: {type: number, min: 1, max: 300, whole: true}
  side: {type: number, max: 300}
intents:
  clear: {action: custom, sentences: ["clear table {one} [and [table] {other}]"]}
  turn: {action: custom, sentences: ["turn {side}"]}
"""


@pytest.fixture(scope="module")
def tables(engine_of) -> IntentEngine:
    return engine_of(TABLES)


@pytest.mark.parametrize("said", ["3 and 14", "3, and 14", "three and 14", "3 and fourteen", "three and fourteen"])
def test_however_two_numbers_are_written(tables, said):
    assert tables.parse(f"clear table {said}").slots == {"one": 3, "other": 14}


def test_one_number_stays_one(tables):
    assert tables.parse("clear table 100 and 4").slots == {"one": 104}
    assert tables.parse("turn 3 and 1/2").slots == {"side": 3.5}


def test_two_commands_have_a_number_each(tables):
    steps = tables.parse("clear table 3 and 14 and turn 20").slots["steps"]
    assert [step["slots"] for step in steps] == [{"one": 3, "other": 14}, {"side": 20}]


@pytest.mark.parametrize("said", ["turn 3 and 14", "clear table 3 and 4 and 5", "clear table 3 or 14", "turn 3, 14"])
def test_nothing_is_done_where_there_is_one_number(tables, said):
    assert not tables.parse(said).actions
