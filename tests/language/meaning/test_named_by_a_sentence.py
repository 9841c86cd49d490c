"""What sentences name themselves, "the lid", and the things of free words, whatever their slot is called, are pointed
back to as any thing is."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.runtime.last_said import LastSaid

PORTER = """
language: en
slots:
  bag: {type: text, max_words: 3, known: [suitcase, golf bag]}
  box: {type: object, max_words: 2}
  guest: {type: text, max_words: 2}
  place: [lobby, bar]
  open: boolean
  far: {type: distance, max: 8 m}
intents:
  lid:
    action: custom
    sentences: [{say: "open the lid", slots: {open: true}}, {say: "close the lid", slots: {open: false}}]
  light:
    action: custom
    sentences: [{say: "turn on the light", slots: {open: true}}, {say: "turn off the light", slots: {open: false}}]
  raise: {action: custom, sentences: ["raise the camera by {far}"]}
  lower: {action: custom, sentences: ["lower the camera by {far}"]}
  load: {action: custom, sentences: ["(load|pick up) the {bag}"]}
  carry: {action: custom, sentences: ["bring [the] {bag} to the {place}"]}
  stack: {action: custom, sentences: ["stack the {box}"]}
  shift: {action: custom, sentences: ["shift [the] {box} to the {place}"]}
  follow: {action: custom, sentences: ["follow {guest}"]}
  drive: {action: custom, sentences: ["drive to the {place}"]}
"""


@pytest.fixture(scope="module")
def porter(engine_of) -> IntentEngine:
    return engine_of(PORTER)


@pytest.mark.parametrize(
    ("said", "in_full"),
    [
        ("open the lid and then close it", "open the lid and then close the lid"),
        ("open the lid, drive to the bar and close it", "open the lid, drive to the bar and close the lid"),
        ("open the lid, no, close it", "close the lid"),
        ("turn on the light, no, turn it off", "turn off the light"),
        ("raise the camera by two meters and then lower it by one meter",
         "raise the camera by two meters and then lower the camera by one meter"),
        ("pick up the golf bag and bring it to the lobby", "pick up the golf bag and bring the golf bag to the lobby"),
        ("stack the red crate and shift it to the bar", "stack the red crate and shift the red crate to the bar"),
    ],
)  # fmt: skip
def test_what_was_named_is_meant(porter: IntentEngine, said: str, in_full: str) -> None:
    assert porter.parse(said).actions == porter.parse(in_full).actions != ()


@pytest.mark.parametrize("said", ["close it", "open the lid and lower it", "drive to the bar and close it"])
def test_nothing_that_fits_was_named(porter: IntentEngine, said: str) -> None:
    assert porter.parse(said).actions == ()


def test_a_thing_is_remembered_over_commands_that_name_none(porter: IntentEngine) -> None:
    last = LastSaid(lambda: porter.grammars)
    for said in ("load the golf bag", "drive to the lobby"):
        last.take(porter.parse(said, last=last.meaning))
    (action,) = porter.parse("bring it to the bar", last=last.meaning).actions
    assert action.slots == {"bag": "golf bag", "place": "bar"}
