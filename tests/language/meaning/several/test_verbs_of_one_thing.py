"""Several verbs that are said of one thing: "open and close the hatch". And "both" of two things."""

from __future__ import annotations

import pytest

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  way: [open, close, lock]
  gate: {type: number, min: 1, max: 9, whole: true}
  nth: {type: ordinal, max: 5}
  thing: [hatch, lid, filter]
  any: {type: text, max_words: 3}
  time: duration
  side: [left, right]
intents:
  gate: {action: custom, sentences: ["{way} gate {gate} [for {time}]", "{way} the {nth} gate"]}
  thing: {action: custom, sentences: ["{way} the {thing} [for {time}]"]}
  empty: {action: custom, sentences: ["empty the {thing}"]}
  rinse: {action: custom, sentences: ["rinse (off|out) the {thing}"]}
  turn: {action: custom, sentences: ["turn {side}"]}
  go: {action: custom, sentences: ["go {side}"]}
  fetch: {action: custom, sentences: ["fetch the {any}"]}
  drop: {action: custom, sentences: ["drop the {any}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("open and close the hatch", "open the hatch, then close the hatch"),
        ("open and then close gate 3", "open gate 3, then close gate 3"),
        ("empty and rinse out the filter", "empty the filter, then rinse out the filter"),
        ("rinse out and empty the filter", "rinse out the filter, then empty the filter"),
        ("close and lock the second gate, please", "close the second gate, then lock the second gate"),
        ("empty the lid, then open and close the hatch", "empty the lid, open the hatch, then close the hatch"),
        ("open both the hatch and the lid", "open the hatch, then open the lid"),
        ("open both gates 3 and 4", "open gate 3, then open gate 4"),
        ("open both the hatch and the lid and lock gate 3", "open the hatch, open the lid, then lock gate 3"),
    ],
)
def test_each_is_done_to_it(engine: IntentEngine, said: str, meant: str) -> None:
    assert engine.parse(said).actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "turn and go left",  # where to may belong to the last alone
        "open and close the lid for ten minutes",  # each, or one of them?
        "fetch and drop the ball",  # free words
        "open and close",
        "open or close the lid",
        "open and don't close the lid",
        "don't open and close the lid",
        "open and close the lid?",
        "she opens and closes the lid",
        "open and shut the lid",  # no command of this grammar
        "open both the hatch, the lid and the filter",
        "open both the hatch or the lid",
        "open both the hatch",
        "don't open both the hatch and the lid",
    ],
)
def test_what_may_be_meant_otherwise_does_nothing(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions
