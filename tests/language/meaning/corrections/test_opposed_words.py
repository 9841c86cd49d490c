"""A word of a sentence that is corrected to its opposite ("turn the lamp on, no, off"), and what stands for the noun of
what is corrected ("the red cup, no, the blue one")."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

ENGLISH = """
language: en
slots:
  device: [fan, pump]
  side: [left, right]
  limb: [hand, foot]
  room: [kitchen, hall]
  colour: [red, blue]
  title: {type: text, max_words: 3}
  n: {type: number, whole: true}
intents:
  "on": {action: custom, sentences: ["turn the {device} on", "turn on the {device}", "turn on the {device} in the {room}"]}
  "off": {action: custom, sentences: ["turn the {device} off", "turn off the {device}"]}
  raise: {action: custom, sentences: [{say: "(raise|move) the blind up", slots: {way: up}}, {say: "move the blind down", slots: {way: down}}]}
  shut: {action: custom, sentences: [{say: "shut the left door", slots: {door: 1}}, {say: "shut the right door", slots: {door: 2}}]}
  lift: {action: custom, sentences: ["lift (your|the) {side} {limb}"]}
  fetch: {action: custom, sentences: ["fetch (the|a) {title}", "fetch the {title} from the {room}"]}
  take: {action: custom, sentences: ["take the {colour} cup"]}
  play: {action: custom, sentences: ["play {title}"]}
  unlock: {action: custom, sentences: ["unlock drawer {n}"]}
"""  # noqa: E501
GERMAN = """
language: de
slots:
  gerät: [Lampe, Pumpe]
  seite: {type: choice, values: {links: "(linke|linken)", rechts: "(rechte|rechten)"}}
  glied: [Hand, Arm]
intents:
  an: {action: custom, sentences: ["mach die {gerät} an"]}
  aus: {action: custom, sentences: ["mach die {gerät} aus"]}
  auf: {action: custom, sentences: [{say: "fahr den Rollladen hoch", slots: {wohin: hoch}}, {say: "fahr den Rollladen runter", slots: {wohin: runter}}]}
  tor: {action: custom, sentences: [{say: "sperr das linke Tor ab", slots: {tor: 1}}, {say: "sperr das rechte Tor ab", slots: {tor: 2}}]}
  heben: {action: custom, sentences: ["heb (deine|deinen|die|den) {seite} {glied}"]}
"""  # noqa: E501
FRENCH = """
language: fr
slots: {appareil: [lampe, pompe], côté: [gauche, droite], membre: [main, jambe]}
intents:
  allumer: {action: custom, sentences: ["allume la {appareil}"]}
  éteindre: {action: custom, sentences: ["éteins la {appareil}"]}
  lever: {action: custom, sentences: ["lève (ta|la) {membre} {côté}"]}
"""
SPANISH = """
language: es
slots: {aparato: [lámpara, bomba], lado: [izquierda, derecha], miembro: [mano, pierna]}
intents:
  encender: {action: custom, sentences: ["enciende la {aparato}"]}
  apagar: {action: custom, sentences: ["apaga la {aparato}"]}
  levantar: {action: custom, sentences: ["levanta (tu|la) {miembro} {lado}"]}
"""
ITALIAN = """
language: it
slots: {apparecchio: [lampada, pompa], lato: [sinistra, destra], membro: [mano, gamba]}
intents:
  accendere: {action: custom, sentences: ["accendi la {apparecchio}"]}
  spegnere: {action: custom, sentences: ["spegni la {apparecchio}"]}
  alzare: {action: custom, sentences: ["alza la [tua] {membro} {lato}"]}
"""
GRAMMARS = {"en": ENGLISH, "de": GERMAN, "fr": FRENCH, "es": SPANISH, "it": ITALIAN}


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {language: engine_of(text) for language, text in GRAMMARS.items()}


OPPOSITES = {
    "en": {
        "turn the fan on, no, off": "turn the fan off",
        "turn on the fan, no, off": "turn off the fan",
        "turn the fan on, I mean off": "turn the fan off",
        "turn the fan on, no, the fan off": "turn the fan off",
        "turn on, no, off the fan": "turn off the fan",
        "move the blind up, no, down": "move the blind down",
        "shut the left door, no, the right door": "shut the right door",
        "shut the left door, no, the right": "shut the right door",
        "shut the left, no, the right door": "shut the right door",
        "shut the left, sorry, right door": "shut the right door",
    },
    "de": {
        "mach die Lampe an, nein, aus": "mach die Lampe aus",
        "mach die Lampe nicht an, sondern aus": "mach die Lampe aus",
        "fahr den Rollladen hoch, ich meine runter": "fahr den Rollladen runter",
        "sperr das linke Tor ab, nein, das rechte": "sperr das rechte Tor ab",
        "sperr das linke Tor ab, nein, das rechte Tor": "sperr das rechte Tor ab",
        "sperr das linke, nein, das rechte Tor ab": "sperr das rechte Tor ab",
    },
    "fr": {"allume la lampe, non, éteins": "éteins la lampe", "allume, non, éteins la pompe": "éteins la pompe"},
    "es": {"enciende la lámpara, no, apaga": "apaga la lámpara"},
    "it": {"accendi la lampada, no, spegni": "spegni la lampada"},
}
SIDES = {
    "en": {
        "lift your right hand, no, your left hand": "lift your left hand",
        "lift your right hand, no, your left": "lift your left hand",
        "lift your right hand, no, left": "lift your left hand",
        "lift your right, no, your left hand": "lift your left hand",
        "lift the right hand, no, the left one": "lift the left hand",
        "lift your right foot, I mean your left one": "lift your left foot",
        "take the red cup, no, the blue one": "take the blue cup",
        "fetch the red cup, no, the blue one": "fetch the blue cup",
        "fetch a red cup, no, the other one": "fetch the other cup",
    },
    "de": {
        "heb deine rechte Hand, nein, deine linke Hand": "heb deine linke Hand",
        "heb deine rechte Hand, nein, die linke": "heb die linke Hand",
        "heb deine rechte, nein, deine linke Hand": "heb deine linke Hand",
    },
    "fr": {
        "lève ta main droite, non, ta main gauche": "lève ta main gauche",
        "lève ta main droite, non, la gauche": "lève ta main gauche",
        "lève ta main droite, non, celle de gauche": "lève ta main gauche",
    },
    "es": {
        "levanta la mano derecha, no, la mano izquierda": "levanta la mano izquierda",
        "levanta la mano derecha, no, la izquierda": "levanta la mano izquierda",
        "levanta la mano derecha, no, la de la izquierda": "levanta la mano izquierda",
    },
    "it": {
        "alza la mano destra, no, la sinistra": "alza la mano sinistra",
        "alza la mano destra, no, quella sinistra": "alza la mano sinistra",
    },
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        (language, said, meant)
        for table in (OPPOSITES, SIDES)
        for language, rows in table.items()
        for said, meant in rows.items()
    ],
)
def test_the_last_word_counts(engines, language: str, said: str, meant: str) -> None:
    wanted = engines[language].parse(meant).actions
    assert wanted
    assert engines[language].parse(said).actions == wanted
    assert engines[language].parse(said, heard=True).actions in (wanted, ())


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "turn the fan on, off"),
        ("en", "turn the fan on, no, not off"),
        ("en", "turn on the fan in the kitchen, no, off"),  # no sentence turns it off there
        ("en", "turn the fan on, no, up"),
        ("en", "turn the fan on, no"),
        ("en", "turn the fan, no, off"),
        ("en", "if you turn the fan on, no, off"),
        ("en", "shut the left door, no, the kitchen door"),
        ("en", "shut the left door, no, the right window"),
        ("en", "lift your right hand, no, the right one or the left one"),
        ("en", "fetch the cup of tea, no, the hot one"),
        ("en", "fetch the red cup from the kitchen, no, the one"),
        ("de", "mach die Lampe an, aus"),
        ("de", "mach die Lampe an, nein, nicht aus"),
        ("de", "sperr das linke Tor ab, nein, das obere"),
        ("fr", "allume la lampe, non, n'éteins pas"),
        ("es", "enciende la lámpara, no, no apagues"),
        ("it", "accendi la lampada, no, non spegni"),
    ],
)
def test_what_is_not_clear_does_nothing(engines, language: str, said: str) -> None:
    assert not engines[language].parse(said).actions


def test_a_number_and_a_name_stay_what_they_are(engines) -> None:
    engine = engines["en"]
    assert engine.parse("unlock drawer three, no, drawer one").slots == {"n": 1}
    assert engine.parse("unlock drawer three, no, one").slots == {"n": 1}
    assert engine.parse("unlock drawer three, no, one hundred and one").slots == {"n": 101}
    assert engine.parse("unlock drawer three, no, a hundred and ninety one").slots == {"n": 191}
    assert engine.parse("fetch the crate two, no, the crate one").slots == {"title": "crate one"}
    assert engine.parse("play lights on, no, lights off").slots == {"title": "lights off"}
