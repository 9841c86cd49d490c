"""What a grammar understands that says nothing of fillers: people put the same words around any command."""

from __future__ import annotations

import pytest

from intent_engine import IntentEngine, Status

GRAMMAR = """
language: en
slots:
  way: [ahead, back]
  time: duration
  far: distance
  count: {type: number, max: 20}
  subject: {type: text, max_words: 4}
intents:
  roll: {action: custom, sentences: ["roll {way}", "go {way}"]}
  ring: {action: custom, sentences: ["ring [for {time}]", "ring {count} bells", "ring at {far}"]}
  search: {action: custom, sentences: ["search {subject}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("go ahead and ring", [{}]),
        ("go ahead", [{"way": "ahead"}]),
        ("go ahead and go back", [{"way": "back"}]),
        ("so ring now", [{}]),
        ("okay now ring for me", [{}]),
        ("I want you to ring right away", [{}]),
        ("I'd like you to ring", [{}]),
        ("ring for about ten seconds", [{"time": 10}]),
        ("ring at two meters fifty, um", [{"far": 2.5}]),  # not fifty micrometers
        ("ring for approximately half a minute", [{"time": 30}]),
        ("ring exactly 3 bells", [{"count": 3}]),
        ("ring another five bells", [{"count": 5}]),
        ("search a book about cars", [{"subject": "book about cars"}]),
        ("search about cars", [{"subject": "about cars"}]),
        ("search my keys for now", [{"subject": "my keys"}]),
        ("go back for now", [{"way": "back"}]),
        ("go on and go back", [{"way": "back"}]),
        ("ring from now on", [{}]),
    ],
)
def test_what_people_put_around_a_command_says_nothing(engine: IntentEngine, said: str, slots: list) -> None:
    found = engine.parse(said)
    assert found.status is Status.ACCEPTED, found.reason
    assert [action.slots for action in found.actions] == slots


@pytest.mark.parametrize(
    "said",
    [
        "I wanted you to ring",
        "I don't want you to ring",
        "if you can ring",
        "ring about",
        "about ten seconds",
        "they rang for about ten seconds",
        "go ahead and don't ring",
    ],
)
def test_what_is_no_command_stays_none(engine: IntentEngine, said: str) -> None:
    assert engine.parse(said).actions == ()


def test_a_file_with_fillers_of_its_own_has_only_these(engine_of) -> None:
    engine = engine_of(GRAMMAR + "fillers: [please]\n")
    assert engine.parse("please ring").status is Status.ACCEPTED
    assert engine.parse("uh, ring").status is Status.REJECTED


def test_a_filler_of_a_file_that_stands_beside_numbers_elsewhere_stands_anywhere(engine_of) -> None:
    assert engine_of(GRAMMAR + "fillers: [about]\n").parse("about ring").status is Status.ACCEPTED
    assert engine_of(GRAMMAR + "fillers: [please]\n").parse("about ring").status is Status.REJECTED


FIELD = """
language: de
slots:
  time: duration
  far: distance
  row: {type: number, max: 40, whole: true}
  light: {type: boolean, values: {true: an, false: aus}}
intents:
  dig: {action: custom, sentences: ["grab [{time}]", "grab ein loch"]}
  hoot: {action: custom, sentences: ["hup [{row} mal]"]}
  light: {action: custom, sentences: ["mach das licht {light}"]}
"""


@pytest.fixture(scope="module")
def field(engine_of) -> IntentEngine:
    return engine_of(FIELD)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("mach bitte mal das Licht an", {"light": True}),
        ("mach doch mal das Licht aus", {"light": False}),
        ("kannst du jetzt mal das Licht an machen", {"light": True}),
        ("so, grab also ein Loch", {}),
        ("grab ungefähr drei Minuten", {"time": 180}),
        ("grab etwa eine halbe Minute", {"time": 30}),
        ("hup genau 2 mal", {"row": 2}),
        ("hup zwei mal", {"row": 2}),
        ("grab etwa", None),
        ("grab doch nicht", None),
        ("mach doch nicht das Licht aus", None),
        ("jetzt", None),
    ],
)
def test_germans_put_other_words_around_a_command(field: IntentEngine, said: str, slots: dict | None) -> None:
    assert [action.slots for action in field.parse(said).actions] == ([] if slots is None else [slots])
