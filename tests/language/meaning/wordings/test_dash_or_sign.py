"""Dashes before numbers that may be signs: who says "Z minus five" must not be driven to plus five."""

from __future__ import annotations

import pytest
from meanings import does

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status

MILL = """
language: en
slots:
  axis: [x, y, z]
  far: {type: distance, max: 500 mm}
  at: {type: number, min: -999, max: 999}
  anywhere: number
  offset: {type: number, whole: true}
  angle: {type: angle, unit: deg, min: -360 deg}
  side: [left, right]
  whom: {type: text, max_words: 3}
  bay: {type: number, min: 1, max: 20}
  row: [A, B, C]
intents:
  jog: {action: custom, sentences: ["jog {axis} [by] {far}"]}
  go: {action: custom, sentences: ["go to x {at:x} [y {at:y}] [z {at:z}]", "go to {at:x} {at:y}"]}
  shift: {action: custom, sentences: ["shift to x {anywhere}"]}
  select: {action: custom, sentences: ["select offset {offset}"]}
  rotate: {action: custom, sentences: ["rotate the table {angle}", "rotate {side} {angle}"]}
  bay: {action: custom, sentences: ["open bay {bay}", "open row {row} {bay}", "open gate {row} {anywhere}"]}
  tell: {action: custom, sentences: ["tell {whom}"]}
  index:
    action: custom
    lark: |
      start: "index z " at
      at: /-?[0-9]+/
"""

OVEN = """
language: en
slots: {heat: {type: number, min: -40, max: 40}, note: {type: text, max_words: 6, dictation: true}}
intents:
  keep: {action: custom, sentences: ["keep it at {heat} degrees", "cool it to {heat} degrees"]}
  write: {action: custom, sentences: ["write {note}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(MILL)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("jog z-5 mm", {"axis": "z", "far": -0.005}),
        ("Jog Z\u22125 mm.", {"axis": "z", "far": -0.005}),
        ("jog z\u20135mm", {"axis": "z", "far": -0.005}),
        ("jog z-.5 mm", {"axis": "z", "far": -0.0005}),
        ("jog x by-5 mm", {"axis": "x", "far": -0.005}),
        ("jog x by - 5 mm", {"axis": "x", "far": -0.005}),
        ("jog x by \u2013 5 mm, please", {"axis": "x", "far": -0.005}),
        ("go to X10 Y20 Z-5", {"x": 10, "y": 20, "z": -5}),
        ("go to x10,y-20,z-5.5", {"x": 10, "y": -20, "z": -5.5}),
        ("go to X - 10, Y - 20", {"x": -10, "y": -20}),
        ("go to x-20 y-20", {"x": -20, "y": -20}),
        ("go to x = - 10", {"x": -10}),
        ("go to 10,-20", {"x": 10, "y": -20}),
        ("go to 10 \u221220", {"x": 10, "y": -20}),
        ("go to 10, -20", {"x": 10, "y": -20}),
        ("go to -10 -20", {"x": -10, "y": -20}),
        ("go to -1.5 -20.5", {"x": -1.5, "y": -20.5}),
        ("go to -10 20", {"x": -10, "y": 20}),
        ("shift to x\u22125", {"anywhere": -5}),
        ("index z-5", {"at": -5}),
        ("jog z-5 mm, no, z-3 mm", {"axis": "z", "far": -0.003}),
    ],
)
def test_it_is_a_sign_where_a_number_may_be_below(engine: IntentEngine, said: str, slots: dict[str, object]) -> None:
    found = engine.parse(said)
    assert (found.status, found.text) == (Status.ACCEPTED, said)
    assert found.slots == pytest.approx(slots)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("open bay-3", {"bay": 3}),
        ("open bay - 3", {"bay": 3}),
        ("open row B-3", {"row": "B", "bay": 3}),
        ("open gate B-3", {"row": "B", "anywhere": 3}),
        ("select offset-3", {"offset": 3}),
        ("rotate left - 90 degrees", {"side": "left", "angle": 1.5707963}),
        ("tell room B-3", {"whom": "room b 3"}),
    ],
)
def test_it_is_none_in_a_name_and_as_a_pause(engine: IntentEngine, said: str, slots: dict[str, object]) -> None:
    found = engine.parse(said)
    assert found.status is Status.ACCEPTED
    assert found.slots == pytest.approx(slots)


@pytest.mark.parametrize(
    "said",
    [
        "rotate the table-90",
        "rotate the table - 90 degrees",
        "shift to x-5",
        "go to 10 -20",
        "go to 10 - 20",
        "go to 10 \u201320",
        "go to -10 - 20",
        "go to -10-20",
        "go to -1.5-20",
    ],
)
def test_what_may_be_either_is_not_done(engine: IntentEngine, said: str) -> None:
    found = engine.parse(said)
    assert (found.status, found.actions) == (Status.REJECTED, ())
    assert "say 'minus'" in found.reason


@pytest.mark.parametrize("said", ["don't jog z-5 mm", "he said jog z-5 mm", "did you jog z-5 mm?", "jog z-900 mm"])
def test_a_sign_makes_no_command_of_talk(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


def test_a_stop_beside_it_is_a_stop(engine: IntentEngine) -> None:
    assert engine.parse("rotate the table-90, stop").stops


def test_each_of_several_commands_has_its_own(engine: IntentEngine) -> None:
    found = engine.parse("jog z-5 mm and open bay-3 and jog x-5 mm")
    assert [action.slots for action in found.actions] == [
        {"axis": "z", "far": -0.005},
        {"bay": 3},
        {"axis": "x", "far": -0.005},
    ]


@pytest.fixture(scope="module")
def oven(engine_of) -> IntentEngine:
    return engine_of(OVEN)


@pytest.mark.parametrize(
    "said",
    [
        "keep it at --20 degrees",
        "keep it at— 20 degrees",
        "keep it at - twenty degrees",
        "keep it at minus -20 degrees",
    ],
)
def test_a_value_that_may_be_below_zero_is_not_above(oven: IntentEngine, said: str) -> None:
    assert not oven.parse(said).actions


@pytest.mark.parametrize(
    ("said", "heat"),
    [
        ("keep it at -20 degrees", -20),
        ("keep it at −20 degrees", -20),
        ("keep it at - 20 degrees", -20),
        ("cool it to – 20 degrees", -20),
        ("keep it at minus 20 degrees", -20),
        ("keep it - at 20 degrees", 20),
        ("keep it at 20 degrees", 20),
        ("keep it at 10 - no - 20 degrees", 20),
    ],
)
def test_a_value_is_clear_with_a_sign_or_in_words(oven: IntentEngine, said: str, heat: float) -> None:
    found = oven.parse(said)
    assert found.slots == {"heat": heat}, found.reason


def test_other_dashes_are_pauses(oven: IntentEngine) -> None:
    assert oven.parse("write they won at - 20").actions
    assert does("turn left - 20 degrees") == "left 20"


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "hold 1 hour - 5 minutes"),
        ("en", "hold 5 minutes \u2013 20 seconds"),
        ("de", "hold 1 Stunde - 5 Minuten"),
        ("fr", "hold 1 heure - 5 minutes"),
        ("es", "hold 1 hora - 5 minutos"),
        ("it", "hold 1 ora - 5 minuti"),
    ],
)
def test_between_two_amounts_it_may_be_a_minus(engine_of, language: str, said: str) -> None:
    engine = engine_of(f"language: {language}\nslots: {{t: duration}}\nintents:\n  hold: "
                       '{action: custom, sentences: ["hold {t}"]}\n')  # fmt: skip
    assert not engine.parse(said).actions
    assert engine.parse(said.replace(" - ", " ").replace(" \u2013 ", " ")).actions


def test_german_dashes_before_values(engine_of) -> None:
    engine = engine_of(
        "language: de\nslots: {heat: {type: number, min: -40}}\n"
        'intents:\n  kühl: {action: custom, sentences: ["kühl es auf {heat} grad"]}\n'
    )
    assert not engine.parse("kühl es auf -- 20 Grad").actions
    assert engine.parse("kühl es auf - 20 Grad").slots == {"heat": -20}
    assert engine.parse("kühl es auf -20 Grad").slots == {"heat": -20}
    cold = engine_of(
        "language: de\nslots: {heat: {type: number, min: 4}}\n"
        'intents:\n  kühl: {action: custom, sentences: ["kühl es auf {heat} grad"]}\n'
    )
    assert not cold.parse("kühl es auf - 20 Grad").actions, "which cannot be below zero"


@pytest.mark.parametrize(
    ("said", "done"), [("x", True), ("-x", False), ("\u2212x", False), ("- x", True), ("axis-x", True)]
)
def test_an_axis_with_a_sign_may_be_the_other_way(engine_of, said: str, done: bool) -> None:
    engine = engine_of(
        "slots: {axis: [x, z], far: {type: distance, min: 0 m}}\n"
        'intents:\n  jog: {action: custom, sentences: ["jog {far} along [axis] {axis}"]}\n'
    )
    assert bool(engine.parse(f"jog 5 mm along {said}").actions) is done
