"""What stands after a pause and is a command by itself is no part of a name; a pause alone parts no name."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import does, german

from intent_engine import IntentEngine, Status

GRAMMAR = """
language: en
slots:
  song: {type: text}
  thing: {type: object, max_words: 6}
  room: [kitchen, lab]
intents:
  play: {action: custom, sentences: ["play {song}"]}
  fetch: {action: custom, sentences: ["(fetch|bring me) {thing}"]}
  louder: {action: custom, sentences: [louder, "much louder"]}
  home: {action: custom, sentences: ["[go] home"]}
  room: {action: custom, sentences: ["{room}"]}
"""
GERMAN = """
language: de
slots:
  ding: {type: object, max_words: 4}
intents:
  holen: {action: custom, sentences: ["hol {ding}"]}
  lauter: {action: custom, sentences: [lauter, "viel lauter"]}
  heim: {action: custom, sentences: [heim]}
"""
NAMES = st.sampled_from(["cup", "red cup", "thunder road", "old tin box"])
COMMANDS = {"louder": "louder", "much louder": "louder", "home": "home", "kitchen": "room", "lab": "room"}


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@given(
    st.sampled_from([("fetch the", "fetch"), ("bring me", "fetch"), ("uh play", "play")]),
    NAMES,
    st.sampled_from([", ", "; ", " - ", ". ", ", uh, "]),
    st.sampled_from(sorted(COMMANDS)),
)
def test_a_command_after_a_pause_is_done_and_no_part_of_a_name(
    engine: IntentEngine, verb: tuple[str, str], name: str, pause: str, command: str
) -> None:
    found = engine.parse(f"{verb[0]} {name}{pause}{command}")
    assert [action.name for action in found.actions] == [verb[1], COMMANDS[command]]
    assert name in found.actions[0].slots.values()


@given(NAMES, st.sampled_from(["big", "shiny", "green"]))
def test_a_pause_alone_parts_no_name(engine: IntentEngine, name: str, more: str) -> None:
    assert engine.parse(f"fetch the {more}, {name}").slots == {"thing": f"{more} {name}"}


@given(NAMES, st.sampled_from(sorted(COMMANDS)))
def test_nothing_is_done_by_halves(engine: IntentEngine, name: str, command: str) -> None:
    """It may be two commands with something between, or one name in pieces: nobody knows."""
    assert not engine.parse(f"fetch the big, {command}, {name}").actions


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("bring me the ball, left", "bring, left 43"),
        ("pick up the ball, back", "pick ball, back 0.6"),
        ("bring me the ball, back", "ambiguous"),  # or the way back
        ("release the cup, faster", "rejected"),
        ("grab the ball, a bit slower", "rejected"),
        ("pick up the big, fast, car", "rejected"),
        ("pick up the big, red cup", "pick big red cup"),
        ("grab the ball, the cup and the box", "pick ball, pick cup, pick box"),
        ("pick up the cup, turn left", "pick cup, left 43"),
        ("grab the ball, stop", "stop"),
    ],
)
def test_of_the_shipped_grammar(said: str, done: str) -> None:
    found = does(said)
    assert found.split(", ")[0] == done.split(", ")[0]
    assert len(found.split(", ")) == len(done.split(", "))


@pytest.mark.parametrize(("pause", "command"), [(", ", "lauter"), (". ", "viel lauter"), (", äh, ", "heim")])
def test_in_german(engine_of, pause: str, command: str) -> None:
    found = engine_of(GERMAN).parse(f"hol den alten Becher{pause}{command}")
    assert [action.name for action in found.actions] == ["holen", command.split()[-1]]
    assert found.actions[0].slots == {"ding": "alten becher"}


@pytest.mark.parametrize("said", ["nimm den Becher, schneller", "nimm den Becher, ganz langsam"])
def test_no_manner_is_a_thing_in_german(said: str) -> None:
    assert german().parse(said).status is Status.REJECTED


@given(NAMES, NAMES, st.sampled_from(sorted(COMMANDS)), st.sampled_from(["no", "I mean", "sorry"]))
def test_nor_is_it_part_of_a_name_that_was_corrected(
    engine: IntentEngine, first: str, name: str, command: str, correction: str
) -> None:
    for said in (f"fetch the {first}, {correction}, the {name}, {command}", f"fetch {first}, {command}, no, {name}"):
        for action in engine.parse(said).actions:
            assert not any(command in str(value) for value in action.slots.values()) or action.name == "room"
    assert [one.name for one in engine.parse(f"fetch {first}, {command}, no, go home").actions][-1:] == ["home"]
    found = engine.parse(f"fetch the {first}, {correction}, the shiny, {name}")
    assert found.slots == {"thing": f"shiny {name}"}
