"""What counts something is an int for the program that gets it, wherever it comes from."""

from __future__ import annotations

import pytest

GRAMMAR = """
language: en
slots:
  times: {type: number, whole: true, max: 9}
  share: {type: number}
intents:
  snap:
    action: custom
    defaults: {times: 1}
    sentences: ["snap [{times} times]", {say: "snap twice", slots: {times: 2}}, "give {share}"]
    examples:
      - "snap three times": {times: 3}
      - "snap 4 times": {times: "4"}
"""
PIPETTE = """
language: en
slots:
  volume: {type: number, max: 1000}
  rack: {type: number, max: 9}
intents:
  draw: {action: custom, sentences: ["draw {volume} (microliter|microliters) [of water]"]}
  rack: {action: custom, sentences: ["rack {rack}"]}
"""


@pytest.mark.parametrize(
    ("said", "value"),
    [("snap", 1), ("snap twice", 2), ("snap three times", 3), ("snap 2.0 times", 2), ("snap two times, no, five", 5)],
)
def test_what_is_counted_is_an_int(engine_of, said: str, value: int) -> None:
    (action,) = engine_of(GRAMMAR).parse(said).actions
    assert action.slots["times"] == value
    assert type(action.slots["times"]) is int


def test_any_other_number_is_a_float(engine_of) -> None:
    (action,) = engine_of(GRAMMAR).parse("give three").actions
    assert type(action.slots["share"]) is float


@pytest.mark.parametrize(
    ("said", "value"),
    [
        ("draw half a microliter", 0.5),
        ("draw a half microliter", 0.5),
        ("draw three quarters of a microliter of water", 0.75),
        ("draw fifty, no, half a microliter", 0.5),
        ("draw half a microliter, no, two microliters", 2.0),
        ("draw half a dozen microliters", 6.0),
    ],
)
def test_a_part_of_one_is_a_number_before_a_word(engine_of, said: str, value: float) -> None:
    engine = engine_of(PIPETTE)
    assert engine.parse(said).slots["volume"] == value


@pytest.mark.parametrize("said", ["draw half a", "draw two of a microliter", "rack half a", "rack half a tube"])
def test_a_part_of_one_is_no_number_by_itself(engine_of, said: str) -> None:
    assert not engine_of(PIPETTE).parse(said).actions
