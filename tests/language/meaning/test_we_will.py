"""Who says "we'll lock the door" tells what he does himself; "well, lock the door" is an order."""

from __future__ import annotations

import pytest
from meanings import does

from intent_engine.engine import IntentEngine

GRAMMAR = """
language: en
slots: {note: {type: text, max_words: 6}}
intents:
  lock: {action: custom, sentences: ["lock the door", "write {note}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize("spoken", [False, True])
@pytest.mark.parametrize(
    "said",
    [
        "we'll lock the door",
        "We’ll lock the door.",
        "okay, we'll lock the door",
        "and we'll lock the door",
        "so we'll lock the door",
    ],
)
def test_what_we_do_is_no_order(engine: IntentEngine, said: str, spoken: bool) -> None:
    assert not engine.parse(said, spoken=spoken).actions


@pytest.mark.parametrize(
    "said", ["well lock the door", "well, lock the door", "let's lock the door", "write we'll be late", "write well"]
)
def test_what_is_an_order(engine: IntentEngine, said: str) -> None:
    assert engine.parse(said).actions


def test_a_stop_is_heard() -> None:
    assert does("we'll stop") == "stop"
    assert does("we'll go to the kitchen") == "rejected"
    assert does("well go to the kitchen") == "to kitchen"
