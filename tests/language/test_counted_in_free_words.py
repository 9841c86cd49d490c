"""Who says "two towels" where a sentence counts each "towel" means no thing called "two towels"."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

PORTER = """
language: en
slots:
  count: {type: number, max: 9, whole: true}
  room: {type: number, min: 100, max: 899, whole: true}
  item: [towel, pillow]
  bag: {type: text, max_words: 3, known: [suitcase]}
intents:
  deliver: {action: custom, sentences: ["bring {count} {item} to room {room}"]}
  carry: {action: custom, sentences: ["bring [the] {bag} to room {room}"]}
"""


@pytest.fixture(scope="module")
def porter(engine_of) -> IntentEngine:
    return engine_of(PORTER)


@pytest.mark.parametrize(
    ("said", "counted"),
    [
        ("bring two towels to room 305", "bring two towel to room 305"),
        ("bring 3 more pillows to room 305", "bring 3 pillow to room 305"),
        ("bring two towels to room 305, no, 306", "bring two towel to room 306"),
        ("bring two towels to room 305 and 3 pillows to room 306",
         "bring two towel to room 305 and bring 3 pillow to room 306"),
    ],
)  # fmt: skip
def test_they_are_counted(porter: IntentEngine, said: str, counted: str) -> None:
    assert porter.parse(said).actions == porter.parse(counted).actions != ()
    assert {action.name for action in porter.parse(said).actions} == {"deliver"}


def test_more_than_there_may_be_are_no_thing(porter: IntentEngine) -> None:
    assert porter.parse("bring fifty towels to room 305").beyond_limits


def test_what_no_list_names_is_a_thing(porter: IntentEngine) -> None:
    assert porter.parse("bring two suitcases to room 305").slots["bag"] == "two suitcases"
