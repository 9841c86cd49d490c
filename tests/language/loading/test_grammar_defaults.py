"""What holds where nothing was said: defaults and conditions, of one file and of one that includes another."""

from __future__ import annotations

from pathlib import Path

import pytest

from intent_engine.actions import Move, Turn
from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError

BASE = """
slots: {{direction: [forward, backward], side: [left, right], distance: distance, n: number, share: percent}}
intents:
  go:
    action: move
    defaults: {{{move}}}
    {more}
    sentences: ["go [{{direction}}] [{{distance}}]"]
  spin:
    action: {{type: turn, direction: "{{side}}"}}
    defaults: {{{turn}}}
    sentences: ["spin [{{side}}]"]
  count:
    action: custom
    when: [{{slots: {{{asked}}}, defaults: {{met: true}}}}]
    sentences: ["count {{n}}", "fill {{share}}"]
"""


@pytest.fixture(autouse=True)
def _folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def engine(
    move: str = "direction: forward", turn: str = "side: left", asked: str = "n: 1", more: str = "", own: str = ""
) -> IntentEngine:
    Path("base.yaml").write_text(BASE.format(move=move, turn=turn, asked=asked, more=more))
    Path("own.yaml").write_text(f"include: base.yaml\n{own}")
    return IntentEngine.from_files("own.yaml")


@pytest.mark.parametrize("value", ["2 m", "200 cm", "2", "two meters"])
def test_a_condition_holds_for_a_value_with_its_unit(value):
    slow = engine(more=f"when: [{{slots: {{distance: {value}}}, defaults: {{speed: 0.1}}}}]")
    assert slow.parse("go forward two meters").actions == (Move(0.1, 2.0, 20.0),)
    assert slow.parse("go forward three meters").actions == (Move(0.5, 3.0, 6.0),)


@pytest.mark.parametrize(("asked", "text"), [("n: '3'", "count 3"), ("share: 50 %", "fill fifty percent")])
def test_a_condition_holds_for_a_number_however_it_is_written(asked, text):
    (action,) = engine(asked=asked).parse(text).actions
    assert action.slots["met"] is True


@pytest.mark.parametrize(
    ("first", "later", "done"),
    [
        ("duration: 2 s", "distance: 50 cm", Move(0.5, 0.5, 1.0)),
        ("distance: 50 cm", "duration: 2 s", Move(0.5, 1.0, 2.0)),
        ("distance: 50 cm", "speed: 0.1 m/s", Move(0.1, 0.5, 5.0)),
    ],
)
def test_of_how_far_and_how_long_the_later_default_holds(first, later, done):
    own = f"intents:\n  go: {{action: move, defaults: {{{later}}}}}\n"
    assert engine(first, own=own).parse("go forward").actions == (done,)
    more = f"when: [{{slots: {{direction: forward}}, defaults: {{{later}}}}}]"
    assert engine(first, more=more).parse("go forward").actions == (done,)


def test_a_turn_takes_the_later_default_as_well():
    own = "intents:\n  spin: {action: {type: turn, direction: '{side}'}, defaults: {duration: 2 s}}\n"
    assert engine(turn="angle: 1").parse("spin left").actions == (Turn(1.0, 0.5, 2.0),)
    assert engine(turn="angle: 0.5", own=own).parse("spin left").actions == (Turn(1.0, 0.5, 2.0),)


def test_the_sign_of_a_default_is_the_direction_where_nothing_else_is():
    text = "intents:\n  retreat: {action: move, defaults: {distance: -1 m}, sentences: [retreat]}\n"
    Path("retreat.yaml").write_text(text + "  back: {action: {type: move, distance: -2 m}, sentences: [shrink back]}\n")
    found = IntentEngine.from_files("retreat.yaml")
    assert found.parse("retreat").actions == (Move(-0.5, 1.0, 2.0),)
    assert found.parse("shrink back").actions == (Move(-0.5, 2.0, 4.0),)


@pytest.mark.parametrize("value", ["-1 m", "0"])
@pytest.mark.parametrize("where", ["default", "condition", "fixed"])
def test_what_turns_the_direction_round_or_goes_nowhere_is_refused(where, value):
    more = {
        "default": "",
        "condition": f"when: [{{slots: {{direction: forward}}, defaults: {{distance: {value}}}}}]",
        "fixed": f"then: [{{say: 'on {{direction}}', slots: {{distance: {value}}}}}]",
    }[where]
    with pytest.raises(ConfigError, match=r"base\.yaml:\d+:\d+: a distance (below zero would turn|of 0 cannot)"):
        engine(f"distance: {value}" if where == "default" else "direction: forward", more=more)


PRIORITIES = "intents:\n  wave: {{action: custom, priority: {first}, sentences: [wave]}}\n"


@pytest.mark.parametrize(("own", "wins"), [("", "wave"), (", priority: 0", "bow"), (", priority: 9", "wave")])
def test_a_file_may_give_an_intent_another_priority_also_none(own, wins):
    Path("a.yaml").write_text(PRIORITIES.format(first=7))
    bow = "  bow: {action: custom, priority: 5, sentences: ['wave [now]']}\n"
    Path("b.yaml").write_text(f"include: a.yaml\nintents:\n  wave: {{action: custom{own}}}\n{bow}")
    assert IntentEngine.from_files("b.yaml").parse("wave").intent == wins


def test_a_sentence_of_an_included_file_is_taken_by_an_intent_of_a_higher_priority():
    Path("a.yaml").write_text(PRIORITIES.format(first=0))
    Path("b.yaml").write_text("include: a.yaml\nintents: {hop: {action: custom, priority: 1, sentences: [wave]}}\n")
    assert IntentEngine.from_files("b.yaml").parse("wave").intent == "hop"
