"""Words to readings: which sentence, what its slots hold, and which reading is the best."""

from __future__ import annotations

import math
import textwrap
from pathlib import Path

import pytest

from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.interpretation import Status
from intent_engine.language.matcher import Matcher
from intent_engine.language.networks.nearest import Nearest
from intent_engine.language.reading import Reading

GRAMMAR = """
language: en
fillers: [please]
phrases:
  go: (go|drive)
slots:
  distance: {type: distance, min: 0.1 m, max: 5 m}
  angle: {type: angle, unit: deg}
  plain: {type: angle}
  colour: {type: choice, values: {red: [red, "dark red", scarlet], blue: blue}}
  exact: {type: choice, values: {on: "on", off: "off"}, fuzzy: false}
  loud: {type: boolean}
  thing: {type: text, max_words: 3, without: [picture]}
  pair: {type: text, max_words: 5, allow: [and]}
  nth: {type: ordinal}
  place: {type: location}
  room: {type: location, tags: [room]}
intents:
  go: {action: move, sentences: ["{go} {distance}"]}
  turn: {action: turn, sentences: ["turn {angle}", "rotate {plain:angle}"]}
  paint: {action: {type: custom, name: paint}, sentences: ["paint {thing} {colour}", "paint it [{colour}]"]}
  switch: {action: {type: custom, name: switch}, sentences: ["switch {exact}", "beep {loud}"]}
  join: {action: {type: custom, name: join}, sentences: ["join {pair}"]}
  choose: {action: {type: custom, name: choose}, sentences: ["take the {nth} {thing}"]}
  visit: {action: {type: navigate, location: "{place}"}, sentences: ["visit [the] {place}"]}
  clean: {action: {type: navigate, location: "{room}"}, sentences: ["clean [the] {room}"]}
  low: {action: {type: custom, name: low}, sentences: ["say {thing}"]}
  high: {action: {type: custom, name: high}, sentences: ["say cheese"], priority: 1}
  docked: {action: {type: custom, name: leave}, sentences: ["leave"], requires: [docked], excludes: [charging]}
sound_alikes:
  fee: [feet]
"""
MAP = """
locations:
  kitchen: {x: 1, y: 2, tags: [room]}
  bedroom: {x: 3, y: 4, tags: [room], aliases: [sleeping room]}
  bay 3: {x: 5, y: 6}
  bay 13: {x: 7, y: 8}
"""


@pytest.fixture(scope="module")
def engine(tmp_path_factory: pytest.TempPathFactory) -> IntentEngine:
    folder = tmp_path_factory.mktemp("matcher")
    (folder / "grammar.yaml").write_text(textwrap.dedent(GRAMMAR), "utf-8")
    (folder / "map.yaml").write_text(textwrap.dedent(MAP), "utf-8")
    return IntentEngine.from_files(folder / "grammar.yaml", locations=folder / "map.yaml")


@pytest.fixture(scope="module")
def matcher(engine: IntentEngine) -> Matcher:
    return engine.matcher()


def best(matcher: Matcher, text: str, *, loose: bool = False) -> Reading:
    return matcher.read(text.split(), loose=loose)[0]


@pytest.mark.parametrize(
    ("text", "intent", "values"),
    [
        ("go two meters", "go", {"distance": 2.0}),
        ("drive 2.5 m", "go", {"distance": 2.5}),
        ("turn ninety", "turn", {"angle": math.pi / 2}),
        ("turn 2 radians", "turn", {"angle": 2.0}),
        ("rotate ninety degrees", "turn", {"angle": math.pi / 2}),
        ("paint the old door dark red", "paint", {"thing": "old door", "colour": "red"}),
        ("paint it", "paint", {}),
        ("paint it scarlet", "paint", {"colour": "red"}),
        ("switch off", "switch", {"exact": "off"}),
        ("join red and blue wire", "join", {"pair": "red and blue wire"}),
        ("take the third cup", "choose", {"nth": 3.0, "thing": "cup"}),
        ("take the twenty first red cup", "choose", {"nth": 21.0, "thing": "red cup"}),
        ("visit the bay 3", "visit", {"place": "bay 3"}),
        ("visit sleeping room", "visit", {"place": "bedroom"}),
        ("say cheese", "high", {}),
        ("say hello", "low", {"thing": "hello"}),
    ],
)
def test_exact_words(matcher: Matcher, text: str, intent: str, values: dict[str, object]) -> None:
    found = best(matcher, text)
    assert (found.intent.name, found.values(), found.problem) == (intent, values, "")
    assert found.score == 1.0


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("go six meters", "more than the largest, 5"),
        ("go one cm", "less than the smallest, 0.1"),
        ("go minus two meters", "less than the smallest, 0.1"),
        ("paint a picture red", "'picture' is nothing for slot 'thing'"),
    ],
)
def test_words_that_fit_and_have_no_value(matcher: Matcher, text: str, problem: str) -> None:
    assert problem in best(matcher, text).problem


@pytest.mark.parametrize(
    "text",
    [
        "go two",
        "rotate ninety",
        "switch of",
        "go",
        "join",
        "paint one two three four red",
        "clean bay three",
        "say not",
    ],
)
def test_words_that_are_no_sentence(matcher: Matcher, text: str) -> None:
    assert [reading for reading in matcher.read(text.split()) if not reading.problem] == []


@pytest.mark.parametrize(
    ("text", "label", "value", "status"),
    [
        ("paint the door scarlett", "colour", "red", "fuzzy"),
        ("visit the bay three", "place", "bay 3", "exact"),
        ("visit the kichen", "place", "kitchen", "fuzzy"),
        ("visit the atlantis", "place", None, "unknown"),
        ("clean the bed room", "room", "bedroom", "fuzzy"),
    ],
)
def test_misheard_names(matcher: Matcher, text: str, label: str, value: str | None, status: str) -> None:
    readings = [
        reading
        for reading in matcher.read(text.split(), loose=True)
        if any(slot.label == label for slot in reading.slots)
    ]
    slot = next(slot for slot in readings[0].slots if slot.label == label)
    assert (slot.value, slot.status) == (value, status)
    assert bool(slot.problem) == (value is None)
    assert readings[0].score == (1.0 if status == "exact" else 0.0 if value is None else slot.score)


def test_a_name_may_hold_a_sound_alike(matcher: Matcher) -> None:
    reading = matcher.read(["visit", "the", "bay", "tree"], loose=True)[0]
    assert [(slot.value, slot.status) for slot in reading.slots] == [("bay 3", "exact")]
    assert (reading.words[-1], reading.alikes, reading.score) == ("three", 1, pytest.approx(0.97))


def test_a_slot_that_is_not_fuzzy_is_never_guessed(matcher: Matcher) -> None:
    assert matcher.read(["switch", "of"], loose=True) == []


def test_a_sound_alike_is_reported_and_costs_something(matcher: Matcher) -> None:
    found = best(matcher, "go two fee", loose=True)
    assert found.words == ("go", "two", "feet")
    assert found.alikes == 1
    assert found.score == pytest.approx(0.97)
    assert found.values() == {"distance": pytest.approx(0.6096)}


def test_the_state_of_the_robot_decides(engine: IntentEngine) -> None:
    assert engine.parse("leave", state=["docked"]).status is Status.ACCEPTED
    assert engine.parse("leave").reason == "docked needs the robot to be docked"
    both = engine.parse("leave", state=["docked", "charging"])
    assert both.reason == "docked cannot be done while the robot is charging"


# -- looking ahead --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "status", "following"),
    [
        ("", PrefixStatus.INCOMPLETE, {"go", "turn", "paint", "please"}),
        ("go", PrefixStatus.INCOMPLETE, {"two", "a", "<number>"}),
        ("go two", PrefixStatus.INCOMPLETE, {"meters", "hundred", "point"}),
        ("go two meters", PrefixStatus.EXTENDABLE, {"and", "twenty"}),
        ("please go", PrefixStatus.INCOMPLETE, {"two"}),
        ("paint it", PrefixStatus.EXTENDABLE, {"red", "dark", "blue"}),
        ("paint it blue", PrefixStatus.EXTENDABLE, {"and", "please", "red"}),  # a thing called "it blue"
        ("switch off please", PrefixStatus.COMPLETE, {"and", "please"}),
        ("switch off and go two meters", PrefixStatus.EXTENDABLE, {"and", "twenty"}),
        ("paint it dark", PrefixStatus.INCOMPLETE, {"red"}),
        ("switch off", PrefixStatus.COMPLETE, {"and"}),
        ("switch off and", PrefixStatus.INCOMPLETE, {"go", "switch"}),
        ("visit the", PrefixStatus.INCOMPLETE, {"kitchen", "bay", "sleeping"}),
        ("visit kitchen", PrefixStatus.COMPLETE, {"and"}),
        ("join", PrefixStatus.INCOMPLETE, {"<any>"}),
        ("go kitchen", PrefixStatus.IMPOSSIBLE, set()),
        ("xyzzy", PrefixStatus.IMPOSSIBLE, set()),
    ],
)
def test_how_far_a_beginning_has_come(
    engine: IntentEngine, text: str, status: PrefixStatus, following: set[str]
) -> None:
    found = engine.prefix(text)
    assert found.status is status
    assert following <= set(found.next_words)
    assert found.next_words == tuple(dict.fromkeys(found.next_words))


def test_how_many_words_could_be_followed(engine: IntentEngine) -> None:
    assert engine.prefix("go two kitchens now").known_words == 2
    assert engine.prefix("a" * 1_000_000).status is PrefixStatus.IMPOSSIBLE


# -- did you mean ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "nearest"),
    [
        ("turn around", "turn {angle}"),
        ("paint the", "paint it"),
        ("switch it off", "switch {exact}"),
    ],
)
def test_the_nearest_sentence(matcher: Matcher, text: str, nearest: str) -> None:
    found = Nearest(matcher).sentences(text.split())
    assert nearest in found
    assert len(found) <= 3


def test_nothing_is_near_to_noise(matcher: Matcher) -> None:
    assert Nearest(matcher).sentences(["qwxyz", "vbnm"]) == ()
    assert Nearest(matcher).sentences([]) == ()
    Nearest(matcher).sentences(["a" * 2000] * 50)


@pytest.mark.parametrize("number", ["7", "seven", "42", "forty two", "one hundred and one"])
def test_a_numeral_of_a_template_may_be_said_in_words(engine_of, number: str) -> None:
    engine = engine_of("language: en\nintents:\n  run: {action: custom, sentences: ['run program {#}']}\n")
    assert engine.parse(f"run program {number}").intent == "run"
    assert engine.parse("run program seven seven").intent is None
    assert engine.parse("run program").intent is None


def test_a_grammar_that_can_be_said_in_a_million_ways_has_few_outlines(tmp_path: Path) -> None:
    path = tmp_path / "many.yaml"
    words = " ".join(f"[(a{n}|b{n}|c{n})]" for n in range(12))
    path.write_text(f'language: en\nintents:\n  a: {{action: stop, sentences: ["say {words}", "{{#}} times"]}}\n')
    nearest = Nearest(IntentEngine.from_files(path).matcher())
    assert 0 < len(nearest._outlines) <= 24
    assert nearest.sentences(["three", "times"]) == ("<number> times",)
