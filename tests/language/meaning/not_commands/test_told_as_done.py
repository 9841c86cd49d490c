"""Who types "turned left" tells what somebody did. A recogniser may have written it for "turn left"."""

from __future__ import annotations

import pytest
from meanings import does, done, shipped

from intent_engine import IntentEngine

GUIDE = """
language: en
slots: {room: [cafe, hall]}
intents:
  guide: {action: custom, sentences: ["lead us to the {room}"]}
  led: {action: custom, sentences: ["switch the led on"]}
"""
TOLD = {
    "turned left": "left 43",
    "turned right ninety degrees": "right 90",
    "moved back two meters": "back 2",
    "go forward and turned left": "forward 1, left 43",
}


@pytest.mark.parametrize("said", [*TOLD, "1. turned left"])
def test_a_form_that_tells_of_something_is_no_command(said: str) -> None:
    assert does(said) == "rejected"


@pytest.mark.parametrize(("said", "meant"), TOLD.items())
def test_a_recogniser_writes_it_for_one(said: str, meant: str) -> None:
    assert done(shipped().parse(said, heard=True)) == meant
    assert done(shipped().parse(said, spoken=True)) == meant
    assert done(shipped().explain(said, heard=True).interpretation) == meant


def test_other_words_that_sound_alike_are_understood_however_they_came() -> None:
    assert does("go forward for meters") == "forward 4"


def test_a_stop_is_heard_all_the_same() -> None:
    assert does("stopped") == "stop"


def test_nor_is_a_form_that_sounds_like_another_word(engine_of) -> None:
    engine: IntentEngine = engine_of(GUIDE)
    assert not engine.parse("led us to the cafe").actions
    assert engine.parse("lead us to the cafe").actions
    assert engine.parse("switch the led on").actions


def test_the_reason_names_both_words() -> None:
    reason = shipped().parse("turned left").reason
    assert "'turned'" in reason
    assert "'turn'" in reason
