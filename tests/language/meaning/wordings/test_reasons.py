"""Why something is to be done, told beside it: it changes nothing, and is told apart from what does."""

from __future__ import annotations

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from meanings import assert_same, does, done, german

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  part: [lamp, heater, fan, wide lens]
  on: boolean
  height: distance
  room: [kitchen, bathroom, room two]
  side: [left, right]
  item: {type: object, max_words: 4}
  note: {type: text, dictation: true}
intents:
  switch: {action: custom, sentences: ["(turn|switch) {on} [the] {part}", "(turn|switch) [the] {part} {on}"]}
  climb: {action: custom, sentences: ["climb [by] {height}"]}
  fetch: {action: custom, sentences: ["fetch [the] {item}"]}
  sing: {action: custom, sentences: [sing]}
  go: {action: custom, sentences: ["go to the {room}", "turn {side}"]}
  water: {action: custom, sentences: ["water the beds"]}
  say: {action: custom, sentences: ["tell Anna that {note}"]}
"""
REASONS = (
    "it's dark", "it is getting late", "there's sand everywhere", "I'm tired", "my feet are cold", "the lid is broken",
    "you're too loud", "battery is low", "somebody is at the door", "people are walking around here",
    "her old car smells funny", "we have guests", "they look hungry", "we're leaving", "someone feels cold",
    "I think it's a bit cold", "I guess the lid is loose", "that's too bright",
)  # fmt: skip
COMMANDS = ("turn the lamp on", "climb two meters", "fetch the cup", "go to the kitchen", "sing")


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@given(st.sampled_from(REASONS), st.sampled_from(COMMANDS), st.sampled_from([", ", ". ", " - ", ", so ", ", please "]))
def test_before_a_command_it_changes_nothing(engine: IntentEngine, reason: str, command: str, pause: str) -> None:
    assert_same(engine, f"{reason}{pause}{command}", command)


@given(st.sampled_from(REASONS), st.sampled_from(COMMANDS), st.sampled_from([", ", ". ", ", since ", " because "]))
@example("it's dark", "fetch the cup", " since ")
def test_behind_a_command_it_changes_nothing(engine: IntentEngine, reason: str, command: str, pause: str) -> None:
    assert_same(engine, f"{command}{pause}{reason}", command)


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("it's her birthday so sing", "sing"),
        ("climb two meters because of the trees", "climb two meters"),
        ("turn the lamp on so I can see", "turn the lamp on"),
        ("turn the lamp on so that we can see the steps", "turn the lamp on"),
        ("It's too tight in here, let's switch that wide lens on", "switch the wide lens on"),
        ("there is water on the floor, sing", "sing"),
        ("the switch is broken, turn on the lamp", "turn on the lamp"),
        ("we have to be quick, turn left", "turn left"),
        ("the party is over, turn off the fan", "turn off the fan"),
        ("it's dark, could you switch on your lamp?", "switch on the lamp"),
        ("the guests are in the kitchen, go to the bathroom", "go to the bathroom"),
        ("turn on the lamp, the lamp is new", "turn on the lamp"),
        ("my feet are cold, switch that heater on", "switch the heater on"),
        ("it's dark, turn the lamp on, then go to the kitchen", "turn the lamp on, then go to the kitchen"),
    ],
)
def test_it_is_the_same(engine: IntentEngine, said: str, command: str) -> None:
    assert_same(engine, said, command)


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("the lamp is off, turn it on", "turn the lamp on"),
        ("the lamp is on, so could you turn it off?", "turn the lamp off"),
        ("my lamp is too dark, turn it on please", "turn the lamp on"),
        ("I think the wide lens is dirty, switch it off", "switch off the wide lens"),
        ("the beds are dry, water them", "water the beds"),
        ("the lamp looks dim, turn it on and go to the kitchen", "turn the lamp on, then go to the kitchen"),
    ],
)
def test_what_it_is_told_of_is_what_a_pronoun_stands_for(engine: IntentEngine, said: str, command: str) -> None:
    assert_same(engine, said, command)


@pytest.mark.parametrize(
    "said",
    [
        # Somebody repeats, takes back or tells a tale.
        "he is saying turn left", "he's saying, turn left", "turn left, she is joking", "turn left, it's a joke",
        "turn left, I'm kidding", "turn left, that's wrong", "turn left, that is what he said",
        "the sign is clear, turn left", "turn left, you are supposed to", "the teacher is shouting, sing",
        "turn left, I'm sorry",
        "turn left, I have changed my mind", "turn left, it is forbidden", "it's forbidden, turn left",
        "sing, it's for later",
        "turn left, I am only teasing", "turn left, the trip is cancelled", "turn left, it is unnecessary",
        # What is left out may be a command.
        "sing, he has to", "they have to, sing", "turn left, we are going to",
        # It may be what the command is about, or its opposite.
        "go to the kitchen, it's the bathroom", "go to the kitchen, it's bathroom", "go to the kitchen, it's room two",
        "turn left, it's right", "turn left, you're right", "climb two meters, it's three",
        "turn the lamp on, it's the fan",
        # Another command, a condition, a denial.
        "it's so switch the fan", "turn left, it's dark when I come", "turn the lamp on, it's dark if you leave",
        "turn the lamp on, it's not dark", "it's dark, don't turn the lamp on", "it's late sing, turn left",
        "you are to turn right, turn left", "turn the lamp on, it was dark",
        # Something else is what it tells of, or what the pronoun stands for.
        "turn it on, the lamp is dark", "the lid is dark, turn it on", "the lamp is dark, turn them on",
        "the lamp is on, turn it on", "the lamp is on the fan, turn it off", "the lamp and the fan are on, turn it off",
        "the lamp is on, don't turn it off", "the lamp is not on, turn it on", "the lamp was on, turn it off",
        "if the lamp is on, turn it off", "is the lamp on, turn it off", "he says the lamp is on, turn it off",
        "the lamp is on, he says turn it off", "the lamp is on, turn it off when I leave",
        "Anna's lamp is on, turn it off",
        "the lamp is dark, go to the kitchen and turn it on", "the lamp is dark, turn on the fan and turn it off",
        "the lamp is dark turn it on", "the lamp is dark, I turned it on", "the lamp is dark, did you turn it on?",
        # Nobody says how it is, but what somebody is to do, or thinks of it.
        "we have to, uh, turn left", "I think you have to, uh, turn left", "I think, turn left",
        "I think it's right, turn left", "I guess it's the bathroom, go to the kitchen", "we get the cup, turn left",
        "they look like he told me, turn left", "that is what I said, turn left",
        "that is the bathroom, go to the kitchen",
        "they feel that we should, turn left", "were leaving, turn left", "were you leaving, turn left", "we'll sing",
        "we're turning left", "we're told to, turn left",
        # No pause, and nothing that says why.
        "it's dark turn the lamp on", "fetch the cup it's hot", "I am here to turn left",
        # No command.
        "it's dark, I'm tired", "it's dark, the lamp on the table", "because it's dark",
        "my feet are cold, your feet are cold",
    ],
)  # fmt: skip
def test_what_may_mean_something_else_does_nothing(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


def test_what_is_dictated_keeps_it(engine: IntentEngine) -> None:
    assert engine.parse("tell Anna that it's dark, I'm tired").slots == {"note": "it's dark, I'm tired"}
    assert engine.parse("tell Anna that I wait because it's dark").slots == {"note": "I wait because it's dark"}


def test_no_place_of_the_map_is_a_reason(engine_of) -> None:
    grammar = "slots: {location: location}\nintents: {go: {action: navigate, sentences: ['go to the {location}']}}"
    engine = engine_of(grammar, locations={"lab": (0, 0, 0), "old mill": (1, 0, 0)})
    assert not engine.parse("go to the lab, it's old mill").actions
    assert engine.parse("go to the lab, it's late").actions


@pytest.mark.parametrize("said", ["we have it just right", "I have it about right", "we are late so left"])
def test_in_one_breath_only_a_verb_begins_a_command(said: str) -> None:
    """A small word that says nothing is no pause: what is told may go on."""
    assert does(said) == "rejected"
    assert does(f"{said.rsplit(None, 2)[0]}, turn left") == "left 43"


@pytest.mark.parametrize(
    "said", ["wir haben es noch links", "wir haben Hunger noch links", "wir haben das noch zurück"]
)
def test_in_one_breath_in_german(said: str) -> None:
    assert not german().parse(said).actions
    assert done(german().parse("es ist spät also fahr nach links")) == "left 43"
