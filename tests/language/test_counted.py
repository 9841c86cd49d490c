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
