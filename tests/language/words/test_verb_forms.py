"""A list of verbs: what somebody does or did is no command, however near it is to one."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.language.words.verb_forms import told_forms_of

LAB = """
language: en
slots:
  act: {type: choice, values: {enable: [enable, activate], pause: pause, open: open, close: [close, shut], void: empty}}
  what: [laser, pump, light, gripper]
  state: boolean
intents:
  act: {action: custom, sentences: ["{act} [the] {what}"]}
  switch: {action: custom, sentences: ["{what} {state}", "turn {state} [the] {what}"]}
"""


@pytest.fixture(scope="module")
def lab(engine_of) -> IntentEngine:
    return engine_of(LAB)


@pytest.mark.parametrize(
    "said",
    [
        "opens the gripper", "shuts the gripper", "closes gripper", "enables the laser", "activated the pump",
        "and pauses the pump", "empties the pump", "turn on the light and opens the gripper", "Activated the pump.",
        "activates the pump, then opens the gripper",
    ],
)  # fmt: skip
def test_what_somebody_does_is_no_command(lab, said):
    assert not lab.parse(said).actions


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("open the gripper", {"act": "open", "what": "gripper"}),
        ("enabel the laser", {"act": "enable", "what": "laser"}),
        ("lights on", {"what": "light", "state": True}),
        ("the lights off", {"what": "light", "state": False}),
        ("open the grippers", {"act": "open", "what": "gripper"}),
    ],
)
def test_a_slip_and_more_of_a_thing_are_understood(lab, said, slots):
    assert lab.parse(said).slots == slots


@pytest.mark.parametrize(
    ("word", "verb"),
    [
        ("opens", "open"),
        ("closes", "close"),
        ("empties", "empty"),
        ("pausing", "pause"),
        ("gripped", "grip"),
        ("took", "take"),
        ("led", "lead"),
    ],
)
def test_the_verb_of_a_form(word, verb):
    assert verb in told_forms_of(word, "en")
    assert not list(told_forms_of(word, "de"))
