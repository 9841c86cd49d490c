"""Why something is to be done, told beside it: it changes nothing, and is told apart from what does."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

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
    "her old car smells funny", "we have guests",
)  # fmt: skip
COMMANDS = ("turn the lamp on", "climb two meters", "fetch the cup", "go to the kitchen", "sing")


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@given(st.sampled_from(REASONS), st.sampled_from(COMMANDS), st.sampled_from([", ", ". ", " - ", ", so ", ", please "]))
def test_before_a_command_it_changes_nothing(engine: IntentEngine, reason: str, command: str, pause: str) -> None:
    assert engine.parse(f"{reason}{pause}{command}").actions == engine.parse(command).actions != ()


@given(st.sampled_from(REASONS), st.sampled_from(COMMANDS), st.sampled_from([", ", ". ", ", since ", " because "]))
def test_behind_a_command_it_changes_nothing(engine: IntentEngine, reason: str, command: str, pause: str) -> None:
    assert engine.parse(f"{command}{pause}{reason}").actions == engine.parse(command).actions != ()


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
        ("it's dark, could you switch on your lamp?", "switch on the lamp"),
        ("the guests are in the kitchen, go to the bathroom", "go to the bathroom"),
        ("turn on the lamp, the lamp is new", "turn on the lamp"),
        ("my feet are cold, switch that heater on", "switch the heater on"),
        ("it's dark, turn the lamp on, then go to the kitchen", "turn the lamp on, then go to the kitchen"),
    ],
)
def test_it_is_the_same(engine: IntentEngine, said: str, command: str) -> None:
    assert engine.parse(said).actions == engine.parse(command).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        # Somebody repeats, takes back or tells a tale.
        "he is saying turn left", "he's saying, turn left", "turn left, she is joking", "turn left, it's a joke",
        "turn left, I'm kidding", "turn left, that's wrong", "turn left, that is what he said",
        "the sign is clear, turn left", "turn left, you are supposed to", "the teacher is shouting, sing",
        "turn left, I'm sorry",
        # It may be what the command is about, or its opposite.
        "go to the kitchen, it's the bathroom", "go to the kitchen, it's bathroom", "go to the kitchen, it's room two",
        "turn left, it's right", "turn left, you're right", "climb two meters, it's three",
        "turn the lamp on, it's the fan",
        # Another command, a condition, a denial.
        "it's so switch the fan", "turn left, it's dark when I come", "turn the lamp on, it's dark if you leave",
        "turn the lamp on, it's not dark", "it's dark, don't turn the lamp on", "it's late sing, turn left",
        "you are to turn right, turn left", "turn the lamp on, it was dark",
        # A pronoun may stand for what the reason is told of.
        "the lamp is dark, turn it on", "turn it on, the lamp is dark",
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


FOREIGN = {
    "de": """
language: de
slots: {teil: [Lampe, Heizung], raum: [Küche, Bad]}
intents:
  an: {action: custom, sentences: ["schalte die {teil} ein"]}
  fahren: {action: custom, sentences: ["fahr in (die|das) {raum}"]}
""",
    "fr": """
language: fr
slots: {lieu: [cave, cuisine]}
intents:
  allumer: {action: custom, sentences: ["allume la lampe"]}
  aller: {action: custom, sentences: ["va à la {lieu}"]}
""",
    "es": """
language: es
slots: {zona: [cocina, terraza]}
intents:
  encender: {action: custom, sentences: ["enciende la luz"]}
  ir: {action: custom, sentences: ["ve a la {zona}"]}
""",
    "it": """
language: it
slots: {luogo: [cantina, cucina]}
intents:
  accendere: {action: custom, sentences: ["accendi la luce"]}
  andare: {action: custom, sentences: ["vai in {luogo}"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "command"),
    [
        ("de", "es ist dunkel, schalte die Lampe ein", "schalte die Lampe ein"),
        ("de", "schalte die Heizung ein, mir ist kalt", "schalte die Heizung ein"),
        ("de", "schalte bitte die Lampe ein, damit ich etwas sehe", "schalte die Lampe ein"),
        ("de", "fahr in die Küche, weil das Bad voll ist", "fahr in die Küche"),
        ("de", "meine Füße sind kalt, schalte mal die Heizung ein", "schalte die Heizung ein"),
        ("de", "schalte die Lampe ein, denn es wird dunkel", "schalte die Lampe ein"),
        ("de", "fahr in die Küche, es ist das Bad", None),
        ("de", "fahr in die Küche, sagt er", None),
        ("de", "es ist ein Witz, fahr in die Küche", None),
        ("de", "schalte die Lampe ein, wenn es dunkel ist", None),
        ("de", "es ist nicht dunkel, schalte die Lampe ein", None),
        ("de", "weil es dunkel ist", None),
        ("fr", "c'est trop sombre, allume la lampe", "allume la lampe"),
        ("fr", "allume la lampe parce qu'il fait nuit", "allume la lampe"),
        ("fr", "j'ai froid, va à la cave", "va à la cave"),
        ("fr", "mes pieds sont froids, va à la cave", "va à la cave"),
        ("fr", "va à la cuisine, c'est la cave", None),
        ("fr", "il dit va à la cave", None),
        ("fr", "allume la lampe quand il fait nuit", None),
        ("fr", "ce n'est pas sombre, allume la lampe", None),
        ("es", "está muy oscuro, enciende la luz", "enciende la luz"),
        ("es", "enciende la luz, porque tengo frío", "enciende la luz"),
        ("es", "enciende la luz, así puedo ver", "enciende la luz"),
        ("es", "la puerta está abierta, ve a la terraza", "ve a la terraza"),
        ("es", "ve a la cocina, es la terraza", None),
        ("es", "dice que enciende la luz", None),
        ("es", "enciende la luz cuando esté oscuro", None),
        ("it", "è troppo buio, accendi la luce", "accendi la luce"),
        ("it", "accendi la luce perché ho freddo", "accendi la luce"),
        ("it", "c'è gente alla porta, vai in cucina", "vai in cucina"),
        ("it", "vai in cucina, è la cantina", None),
        ("it", "vai in cucina, è cantina", None),
        ("it", "mio padre dice vai in cucina", None),
    ],
)
def test_in_other_languages(engine_of, language: str, said: str, command: str | None) -> None:
    engine = engine_of(FOREIGN[language])
    assert engine.parse(said).actions == (engine.parse(command).actions if command else ())
    assert command is None or engine.parse(command).actions
