"""What is called by a number: "row number seven" is row seven."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

FARM = """
language: en
slots:
  row: {type: number, whole: true, max: 99, digits: true}
  litres: {type: number, max: 9}
  times: {type: number, max: 5}
intents:
  water: {action: custom, sentences: ["water row {row} [with {litres} liters]"]}
  knock: {action: custom, sentences: ["knock [on the door] [{times} times]"]}
  take: {action: custom, sentences: ["take {litres}"]}
"""


@pytest.fixture(scope="module")
def farm(engine_of) -> IntentEngine:
    return engine_of(FARM)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("water row number seven", {"row": 7}),
        ("please water row number 7 with three liters", {"row": 7, "litres": 3.0}),
        ("water row number one two", {"row": 12}),
        ("water row seven", {"row": 7}),
    ],
)
def test_the_word_number_before_a_number(farm, said, slots) -> None:
    assert farm.parse(said).slots == slots


@pytest.mark.parametrize(
    "said",
    ["knock on the door number three times", "knock number three times", "take number seven", "water row number",
     "water number seven", "water row, number seven", "water row number hundred", "do not water row number seven"],
)  # fmt: skip
def test_what_is_not_called_so(farm, said) -> None:
    assert not farm.parse(said).actions
