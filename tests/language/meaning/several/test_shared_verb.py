"""One verb for several things: "open the first and the third window", "fade A to 20 percent and B to 30 percent"."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status

ENGLISH = """
language: en
slots:
  room: [kitchen, hall, lab]
  device: [fan, pump, lamp]
  drink: [coffee, tea]
  colour: [red, blue, white]
  fader: {type: choice, values: {A: a, B: b, C: c}}
  share: {type: percent}
  row: {type: ordinal, max: 90}
  time: duration
  heat: {type: number, min: 5, max: 90}
  count: {type: number, whole: true, max: 50}
  bin: {type: number, whole: true, max: 99}
  part: {type: text, max_words: 2, known: [screws, nuts]}
  person: [Anna, Ben]
  side: [left, right]
  limb: [hand, foot]
  gauge: [weight, level, noise]
intents:
  "on": {action: custom, sentences: ["turn the {device} on", "turn on [the] {device} [in the {room}]"]}
  "off": {action: custom, sentences: ["turn the {device} off", "turn off the {device}"]}
  open: {action: custom, sentences: ["open the {row} window"]}
  bring: {action: custom, sentences: ["bring [the] {drink} to the {room}", "bring [the] {drink} to {person}"]}
  paint: {action: custom, sentences: ["paint the fence {colour}"]}
  fade: {action: custom, sentences: ["fade [channel] {fader} to {share}"]}
  water: {action: custom, sentences: ["water the {row} bed [for {time}]"]}
  heat: {action: custom, sentences: ["heat the {room} to {heat} degrees"]}
  sort: {action: custom, sentences: ["put {count} {part} in bin {bin}"]}
  mix: {action: custom, sentences: ["mix {colour} [and {colour:other}]"]}
  stir: {action: custom, sentences: ["stir the {colour} paint"]}
  light: {action: custom, sentences: ["light the {room} for {time}"]}
  read: {action: custom, sentences: ["read the {gauge} of tank {bin}", "read the {gauge} of {count} liters"]}
  lift: {action: custom, sentences: ["lift your {side} {limb}"]}
  drive: {action: custom, sentences: ["drive to the {room}"]}
  stop: {action: stop, sentences: [stop]}
"""
GERMAN = """
language: de
slots:
  raum: [Küche, Flur, Bad]
  gerät: [Lampe, Pumpe, Ventilator]
  anteil: {type: percent}
  ventil: {type: ordinal, max: 20}
  dauer: duration
intents:
  ein: {action: custom, sentences: ["schalte (die|den) {gerät} [(in der|im) {raum}] ein"]}
  aus: {action: custom, sentences: ["schalte (die|den) {gerät} [(in der|im) {raum}] aus"]}
  licht: {action: custom, sentences: ["mach das Licht (in der|im) {raum} an"]}
  dimmen: {action: custom, sentences: ["dimme das Licht (in der|im) {raum} auf {anteil}"]}
  öffnen: {action: custom, sentences: ["öffne das {ventil} Ventil"]}
  bringen: {action: custom, sentences: ["bring die {gerät} [(in die|in den|ins) {raum}]"]}
  lüften: {action: custom, sentences: ["lüfte (die|den|das) {raum} für {dauer}"]}
"""
FRENCH = """
language: fr
slots: {pièce: [cuisine, salon], appareil: [lampe, pompe], vanne: {type: ordinal, max: 20}, part: {type: percent}}
intents:
  allumer: {action: custom, sentences: ["allume la {appareil}"]}
  régler: {action: custom, sentences: ["règle (la|le) {pièce} à {part}"]}
  ouvrir: {action: custom, sentences: ["ouvre la {vanne} vanne"]}
"""
SPANISH = """
language: es
slots: {sala: [cocina, sala], aparato: [lámpara, bomba], puerta: {type: ordinal, max: 20}, parte: {type: percent}}
intents:
  encender: {action: custom, sentences: ["enciende la {aparato} [en la {sala}]"]}
  regular: {action: custom, sentences: ["regula la {sala} al {parte}"]}
  abrir: {action: custom, sentences: ["abre la {puerta} puerta"]}
"""
ITALIAN = """
language: it
slots: {stanza: [cucina, sala], apparecchio: [lampada, pompa], porta: {type: ordinal, max: 20}, parte: {type: percent}}
intents:
  accendere: {action: custom, sentences: ["accendi la {apparecchio}"]}
  regolare: {action: custom, sentences: ["regola la {stanza} al {parte}"]}
  aprire: {action: custom, sentences: ["apri la {porta} porta"]}
"""
GRAMMARS = {"en": ENGLISH, "de": GERMAN, "fr": FRENCH, "es": SPANISH, "it": ITALIAN}


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {language: engine_of(text) for language, text in GRAMMARS.items()}


SINGLY = {
    "en": {
        "open the first and the third window": ["open the first window", "open the third window"],
        "open the first and third window": ["open the first window", "open the third window"],
        "open the first, the second and the last window": [
            "open the first window", "open the second window", "open the last window",
        ],
        "can you open the first and the third window?": ["open the first window", "open the third window"],
        "turn on the fan and the pump": ["turn on the fan", "turn on the pump"],
        "turn on the fan and pump": ["turn on the fan", "turn on the pump"],
        "turn on the fan, the pump and the lamp": ["turn on the fan", "turn on the pump", "turn on the lamp"],
        "turn the fan on and the pump off": ["turn the fan on", "turn the pump off"],
        "turn the fan on and then the pump off": ["turn the fan on", "turn the pump off"],
        "fade A to 20 percent and B to 30 percent": ["fade A to 20 percent", "fade B to 30 percent"],
        "fade channel A to 20 percent, B to 30 percent and C to 40 percent": [
            "fade A to 20 percent", "fade B to 30 percent", "fade C to 40 percent",
        ],
        "water the first bed for five minutes and the third bed for ten": [
            "water the first bed for five minutes", "water the third bed for ten minutes",
        ],
        "light the lab for 2 hours, the hall for 3 and the kitchen for 4": [
            "light the lab for 2 hours", "light the hall for 3 hours", "light the kitchen for 4 hours",
        ],
        "heat the kitchen to 20 degrees and the hall to 25 degrees": [
            "heat the kitchen to 20 degrees", "heat the hall to 25 degrees",
        ],
        "heat the kitchen and the hall to 20 degrees": [
            "heat the kitchen to 20 degrees", "heat the hall to 20 degrees",
        ],
        "read the weight and the noise of tank 3": ["read the weight of tank 3", "read the noise of tank 3"],
        "read the weight, the level and the noise of tank 3": [
            "read the weight of tank 3", "read the level of tank 3", "read the noise of tank 3",
        ],
        "put 5 screws in bin 3 and 2 nuts in bin 4": ["put 5 screws in bin 3", "put 2 nuts in bin 4"],
        "bring coffee to Anna and tea to Ben": ["bring coffee to Anna", "bring tea to Ben"],
        "turn on the fan in the kitchen and the pump in the hall": [
            "turn on the fan in the kitchen", "turn on the pump in the hall",
        ],
        "lift your left and your right hand": ["lift your left hand", "lift your right hand"],
        "lift your left hand and your right foot": ["lift your left hand", "lift your right foot"],
        "drive to the kitchen and the hall": ["drive to the kitchen", "drive to the hall"],
        "stir the red and the blue paint": ["stir the red paint", "stir the blue paint"],
        "paint the fence red, then blue": ["paint the fence red", "paint the fence blue"],
        "paint the fence red and then blue and then white": [
            "paint the fence red", "paint the fence blue", "paint the fence white",
        ],
        "lift your left hand then foot": ["lift your left hand", "lift your left foot"],
        "turn the fan on and the pump off, then open the first and the third window": [
            "turn the fan on", "turn the pump off", "open the first window", "open the third window",
        ],
        "please turn on the fan and, uh, the pump": ["turn on the fan", "turn on the pump"],
    },
    "de": {
        "Schalte die Lampe in der Küche und im Flur ein": [
            "Schalte die Lampe in der Küche ein", "Schalte die Lampe im Flur ein",
        ],
        "schalte die Lampe in der Küche, im Bad und im Flur aus": [
            "schalte die Lampe in der Küche aus", "schalte die Lampe im Bad aus", "schalte die Lampe im Flur aus",
        ],
        "schalte den Ventilator ein und die Pumpe aus": ["schalte den Ventilator ein", "schalte die Pumpe aus"],
        "schalte den Ventilator und die Pumpe ein": ["schalte den Ventilator ein", "schalte die Pumpe ein"],
        "mach das Licht im Flur und im Bad an": ["mach das Licht im Flur an", "mach das Licht im Bad an"],
        "mach das Licht im Flur und Bad an": ["mach das Licht im Flur an", "mach das Licht im Bad an"],
        "dimme das Licht im Flur auf 20 Prozent und in der Küche auf 50 Prozent": [
            "dimme das Licht im Flur auf 20 Prozent", "dimme das Licht in der Küche auf 50 Prozent",
        ],
        "öffne das erste und das dritte Ventil": ["öffne das erste Ventil", "öffne das dritte Ventil"],
    },
    "fr": {
        "ouvre la première et la troisième vanne": ["ouvre la première vanne", "ouvre la troisième vanne"],
        "allume la lampe et la pompe": ["allume la lampe", "allume la pompe"],
        "règle la cuisine à 20 pour cent et le salon à 30 pour cent": [
            "règle la cuisine à 20 pour cent", "règle le salon à 30 pour cent",
        ],
    },
    "es": {
        "abre la primera y la tercera puerta": ["abre la primera puerta", "abre la tercera puerta"],
        "enciende la lámpara y la bomba": ["enciende la lámpara", "enciende la bomba"],
        "enciende la lámpara en la cocina y en la sala": [
            "enciende la lámpara en la cocina", "enciende la lámpara en la sala",
        ],
    },
    "it": {
        "apri la prima e la terza porta": ["apri la prima porta", "apri la terza porta"],
        "regola la cucina al 20 per cento e la sala al 30 per cento": [
            "regola la cucina al 20 per cento", "regola la sala al 30 per cento",
        ],
    },
}  # fmt: skip


@pytest.mark.parametrize(
    ("language", "said", "singly"),
    [(language, said, singly) for language, rows in SINGLY.items() for said, singly in rows.items()],
)
def test_the_verb_is_of_each(engines, language: str, said: str, singly: list[str]) -> None:
    alone = [engines[language].parse(one).actions for one in singly]
    assert all(alone)
    assert engines[language].parse(said).actions == tuple(action for actions in alone for action in actions)


NOTHING = {
    "en": [
        "light the lab for 2 hours and the hall at 3",
        "light the lab for 2 hours and the hall",
        "light the lab for 2 hours or the hall for 3",
        "open the first or the third window",
        "open the first to the third window",
        "open the first, the third window",
        "open the first and the first window",
        "open the first and the third",
        "open the first and the third window is broken",
        "open the first and not the third window",
        "open the twenty first and third window",
        "open the first and a half",
        "don't open the first and the third window",
        "Anna opened the first and the third window",
        "should I open the first and the third window",
        "open the first and the third window if it rains",
        "open the first and the third window, never mind",
        "open the first and the ninety ninth window",
        "turn the fan on and off",
        "turn the fan on and the fan off",
        "turn the fan on and the pump",
        "turn the fan on and the lights are off",
        "fade A to 20 percent and A to 30 percent",
        "fade A to 20 percent and B",
        "fade A to 20 percent, B to 30 percent",
        "heat the kitchen to 20 degrees and the kitchen to 25 degrees",
        "put 5 screws in bin 3 and 2 apples in bin 4",
        "put 5 screws and 2 nuts in bin 4",
        "put 5 screws in bin 20 and 2 nuts in bin 4",
        "mix red and blue and white",
    ],
    "de": [
        "schalte die Lampe in der Küche oder im Flur ein",
        "schalte die Lampe in der Küche und im Flur nicht ein",
        "schalte die Lampe in der Küche und in der Küche ein",
        "schalte die Lampe ein und aus",
        "mach das Licht im Flur und im Bad",
        "ich schalte die Lampe in der Küche und im Flur ein",
        "wenn du die Lampe in der Küche und im Flur einschaltest",
        "öffne das erste bis dritte Ventil",
    ],
    "fr": ["ouvre la première ou la troisième vanne", "n'allume pas la lampe et la pompe"],
    "es": ["abre la primera o la tercera puerta", "no enciendas la lámpara y la bomba"],
    "it": ["apri la prima o la terza porta", "non accendere la lampada e la pompa"],
}


@pytest.mark.parametrize(
    ("language", "said"), [(language, said) for language, rows in NOTHING.items() for said in rows]
)
def test_what_may_be_meant_otherwise_does_nothing(engines, language: str, said: str) -> None:
    assert not engines[language].parse(said).actions
    assert not engines[language].parse(said, heard=True).actions


@pytest.mark.parametrize(
    ("language", "said", "told"),
    [
        ("en", "paint the fence red and blue", "'red and blue' may be for each of them, or for all together"),
        ("en", "stir the red and blue paint", "'red and blue' may be for each of them, or for all together"),
        ("en", "turn on fan and pump", "'fan and pump' may be for each of them"),
        ("en", "bring coffee to the lab and to the hall", "may be of one thing, or of one for each"),
        ("en", "turn on the fan in the kitchen and in the hall", "may be of one thing, or of one for each"),
        ("en", "water the first and the second bed for ten minutes", "for the last, or for all together"),
        ("en", "light the kitchen and the hall for ten minutes", "for the last, or for all together"),
        ("en", "turn on the fan and the pump in the kitchen", "'in the kitchen' may be meant for each"),
        ("en", "read the weight and the noise of 3 liters", "'of 3 liters' may be meant for each"),
        ("de", "bring die Lampe in die Küche und in den Flur", "may be of one thing, or of one for each"),
        ("de", "lüfte die Küche und das Bad für zehn Minuten", "for the last, or for all together"),
    ],
)
def test_what_is_not_clear_is_told(engines, language: str, said: str, told: str) -> None:
    found = engines[language].parse(said)
    assert (found.status, found.actions) == (Status.AMBIGUOUS, ())
    assert told in found.reason
    assert found.reason.endswith("say each command in full")


def test_a_stop_beside_it_stops(engines) -> None:
    for said in ("turn on the fan and the pump and stop", "open the first and the third window, stop"):
        assert engines["en"].parse(said).stops


laws = settings(max_examples=100, deadline=None, derandomize=True)
SAID = {
    "en": ("open ", "the {}", " window", " and ", ["first", "third", "fifth", "last"]),
    "de": ("schalte die Lampe ", "{}", " ein", " und ", ["in der Küche", "im Flur", "im Bad"]),
    "fr": ("ouvre ", "la {}", " vanne", " et ", ["première", "troisième", "cinquième"]),
    "es": ("abre ", "la {}", " puerta", " y ", ["primera", "tercera", "quinta"]),
    "it": ("apri ", "la {}", " porta", " e ", ["prima", "terza", "quinta"]),
}
"""What is said before each thing, how each is named, what is said behind all, the joint, and names."""


@laws
@given(st.sampled_from(sorted(SAID)), st.data())
def test_a_list_is_the_commands_said_singly(engines, language: str, data) -> None:
    before, name, behind, joint, names = SAID[language]
    listed = data.draw(st.lists(st.sampled_from(names), min_size=2, max_size=4, unique=True))
    *first, last = map(name.format, listed)
    found = engines[language].parse(f"{before}{', '.join(first)}{joint}{last}{behind}")
    singly = [engines[language].parse(f"{before}{name.format(one)}{behind}") for one in listed]
    assert found.actions == tuple(action for one in singly for action in one.actions)
    assert len(found.actions) == len(listed)


@laws
@given(
    st.sampled_from(sorted(SAID)), st.sampled_from([" or ", " oder ", " ou ", " o ", ", ", " to ", " - "]), st.data()
)
def test_no_other_joint_makes_several_of_it(engines, language: str, joint: str, data) -> None:
    before, name, behind, _, names = SAID[language]
    one, other = data.draw(st.permutations(names))[:2]
    assert not engines[language].parse(f"{before}{name.format(one)}{joint}{name.format(other)}{behind}").actions


LISTED = """
language: en
slots:
  room: [kitchen, hall, bedroom]
  way: ["on", "off"]
  does: [open, close]
  what: [door, window, gate]
  color: [red, blue]
  toy: [box, ball]
intents:
  lamp: {action: custom, sentences: ["turn {way} the lamp in the {room}"]}
  door: {action: custom, sentences: ["{does} the {what}"]}
  toy: {action: custom, sentences: ["{color} the {toy}"]}
  bring: {action: custom, sentences: ["bring the {toy} to the {room}"]}
"""


@pytest.mark.parametrize(
    ("said", "each"),
    [
        ("open the door and the window", [{"does": "open", "what": "door"}, {"does": "open", "what": "window"}]),
        (
            "close the gate, the door and the window",
            [{"does": "close", "what": one} for one in ("gate", "door", "window")],
        ),
        (
            "turn on the lamp in the hall and in the kitchen",
            [{"way": "on", "room": one} for one in ("hall", "kitchen")],
        ),
    ],
)
def test_a_verb_may_be_a_value_of_a_list(engine_of, said, each) -> None:
    assert [dict(action.slots) for action in engine_of(LISTED).parse(said).actions] == each


@pytest.mark.parametrize(
    "said",
    [
        "open door and window",
        "open and close door",
        "don't open the door and the window",
        "open the door or the window",
        "bring the box to the hall and to the kitchen",
        "did you open the door and the window",
        "open the door and the",
    ],
)
def test_what_is_not_clear_of_listed_verbs_does_nothing(engine_of, said) -> None:
    assert not engine_of(LISTED).parse(said).actions


ARTS = """
language: {language}
slots: {{art: [{arts}]}}
intents: {{show: {{action: custom, sentences: ["{show} {{art}}"]}}}}
"""


@pytest.mark.parametrize(
    ("language", "arts", "show", "said", "meant"),
    [
        ("en", "the Kiss, the Thinker", "show", "show the Kiss and the Thinker", "show the Kiss and show the Thinker"),
        (
            "fr",
            "la Vénus, le Penseur",
            "montre",
            "montre la Vénus et le Penseur",
            "montre la Vénus et montre le Penseur",
        ),
    ],
)
def test_the_article_of_a_name_is_one(engine_of, language: str, arts: str, show: str, said: str, meant: str) -> None:
    engine = engine_of(ARTS.format(language=language, arts=arts, show=show))
    wanted = engine.parse(meant).actions
    assert len(wanted) == 2
    assert engine.parse(said).actions == wanted
    assert not engine.parse(said.replace(" et ", " ou ").replace(" and ", " or ")).actions
