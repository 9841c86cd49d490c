"""A question mark within a command says that nobody knows what it stands behind: "go 1? meters"."""

from __future__ import annotations

import pytest
from meanings import does

from intent_engine.engine import IntentEngine

PORTER = """
language: en
slots:
  count: {type: number, max: 9, whole: true}
  room: {type: number, min: 100, max: 899, whole: true}
  share: percent
  bag: {type: text, max_words: 3, known: [suitcase]}
intents:
  bring: {action: custom, sentences: ["bring {count} towels to room {room}"]}
  volume: {action: custom, sentences: ["set the volume to {share}"]}
  load: {action: custom, sentences: ["load the {bag}"]}
  unlock: {action: custom, sentences: ["unlock room {room}"]}
"""


@pytest.fixture(scope="module")
def porter(engine_of) -> IntentEngine:
    return engine_of(PORTER)


@pytest.mark.parametrize(
    "said", ["bring 2? towels to room 305", "set the volume to 1? percent", "load the red? suitcase"]
)
def test_what_is_asked_is_not_done(porter: IntentEngine, said: str) -> None:
    assert porter.parse(said.replace("?", "")).actions != ()
    assert porter.parse(said).actions == ()


@pytest.mark.parametrize("said", ["unlock room 305? thanks", "unlock room 305?", "can you? unlock room 305"])
def test_an_order_that_is_asked_for_is_done(porter: IntentEngine, said: str) -> None:
    assert porter.parse(said).actions == porter.parse("unlock room 305").actions != ()


def test_how_far_is_asked() -> None:
    assert does("go forward 1? meters") == does("turn left ninety? degrees") == "rejected"
    assert does("turn left? and go forward 1 meter") == "left 43, forward 1"
