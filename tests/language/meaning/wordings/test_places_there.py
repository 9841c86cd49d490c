"""The place of the command before, pointed to: "go to the archive and fetch the boxes from there"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  room: [archive, lab, hall]
  item: [boxes, books]
  person: [Anna, Ben]
intents:
  go: {action: custom, sentences: ["go to the {room}"]}
  fetch: {action: custom, sentences: ["fetch the {item} from the {room}"]}
  take: {action: custom, sentences: ["take the {item} from the {room} to the {room:to}"]}
  wave: {action: custom, sentences: ["wave"]}
  call: {action: custom, sentences: ["call {person}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("go to the lab and fetch the boxes from there", "go to the lab and fetch the boxes from the lab"),
        (
            "go to the lab, then go to the hall and fetch the books from there",
            "go to the lab, then go to the hall, then fetch the books from the hall",
        ),
        (
            "go to the lab, fetch the books from there, then go to the hall",
            "go to the lab, then fetch the books from the lab, then go to the hall",
        ),
        ("go to the lab and from there to the hall", "go to the lab and to the hall"),
        ("go to the lab and then from there go to the hall", "go to the lab, then go to the hall"),
    ],
)
def test_it_is_that_place(engine: IntentEngine, said: str, command: str) -> None:
    assert_same(engine, said, command)


@pytest.mark.parametrize(
    "said",
    [
        "fetch the boxes from there", "wave and fetch the boxes from there", "call Anna and fetch the boxes from there",
        # Which of two?
        "take the boxes from the lab to the hall and fetch the books from there",
        # It goes on, or is one of two.
        "go to the lab and fetch the boxes from there on", "go to the lab and fetch the boxes from there or here",
        "go to the lab and fetch the boxes from there when I wave", "go to the lab and from there",
        "go to the lab and call Ben from there", "go to the lab and fetch the boxes there",
        # It was not said that it goes there.
        "don't go to the lab and fetch the boxes from there", "if you go to the lab, fetch the boxes from there",
        "I was in the lab, fetch the boxes from there", "go to the lab or the hall and fetch the boxes from there",
        "he goes to the lab and fetches the boxes from there",
    ],
)  # fmt: skip
def test_what_may_mean_something_else_does_nothing(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions
