"""What belongs to a thing, behind it with an "of": "set the speed of the belt to sixty percent"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine.engine import IntentEngine

ENGLISH = """
language: en
slots:
  part: [bed, headrest, left arm]
  flap: [damper, oven door]
  rise: {type: distance}
  pace: {type: percent, min: 0 %, max: 100 %}
  side: [left, right]
  axis: [joint, grip]
  what: {type: text, max_words: 4}
  cup: [tea cup, coffee mug]
  n: {type: number, whole: true, min: 1, max: 9}
intents:
  raise: {action: custom, sentences: ["(raise|lift) [the] {part} height by {rise}"]}
  speed: {action: custom, sentences: ["set [the] belt [speed] to {pace}"]}
  cabin: {action: custom, sentences: ["open [the] cabin door"]}
  flap: {action: custom, sentences: ["open [the] {flap}"]}
  show: {action: custom, sentences: ["show {what}"]}
  get: {action: custom, sentences: ["get [the|a] {cup}"]}
  arm: {action: custom, sentences: ["move [the] arm {side}", "move [the] arm {axis}", "move arm {n}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(ENGLISH)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("set the speed of the belt to sixty percent", "set the belt speed to sixty percent"),
        ("could you set the speed of that belt to 60 percent", "set the belt speed to sixty percent"),
        ("set the speed of the belt at 60 percent", "set the belt speed to sixty percent"),
        ("open the door of the cabin", "open the cabin door"),
        ("open the door of the oven", "open the oven door"),
        ("raise the height of the headrest by 3 cm", "raise the headrest height by 3 cm"),
        ("please lift the height of the left arm by 3 cm", "lift the left arm height by 3 cm"),
        ("move the joint of the arm", "move the arm joint"),
        ("set the speed of the belt to 60 percent and open the door of the cabin", "set the belt speed to sixty percent"
         " and open the cabin door"),
    ],
)  # fmt: skip
def test_it_is_the_noun_before_the_other(engine, said: str, meant: str) -> None:
    assert_same(engine, said, meant)


@pytest.mark.parametrize(
    "said",
    [
        # Others than the grammar has side by side, or the other way round.
        "set the belt of the speed to 60 percent",
        "set the height of the belt to 60 percent",
        "set the speed of the main belt to 60 percent",
        "set the speed of the oven to 60 percent",
        "raise the headrest of the height by 3 cm",
        # Any one, a part, a way, a number.
        "set a speed of the belt to 60 percent",
        "get a cup of tea",
        "get a cup of the tea",
        "move the left of the arm",
        "move the two of the arm",
        "set the speed, of the belt to 60 percent",
        # Less than a command, and no command.
        "set the speed of the belt",
        "the speed of the belt",
        "what is the speed of the belt",
        "the speed of the belt was set to 60 percent",
        "don't set the speed of the belt to 60 percent",
        "if the speed of the belt is low set it to 10 percent",
    ],
)
def test_what_is_not_that_is_refused(engine, said: str) -> None:
    assert not engine.parse(said).actions, said


def test_free_words_keep_it(engine) -> None:
    found = engine.parse("show me the height of the bed")
    assert not any("bed height" in str(action.slots) for action in found.actions)
