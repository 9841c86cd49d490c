"""Where something is, said before it: "mach im Flur das Licht an"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine.engine import IntentEngine

GERMAN = """
language: de
slots:
  raum: [Flur, Bad, großer Saal]
  gerät: [Lampe, Pumpe]
  anteil: percent
  zeit: duration
  n: {type: number, whole: true}
  ding: {type: text, max_words: 3}
intents:
  an: {action: custom, sentences: ["mach das Licht [(im|in der) {raum}] an"]}
  ein: {action: custom, sentences: ["schalte die {gerät} [(im|in der) {raum}] ein"]}
  dimmen: {action: custom, sentences: ["dimme das Licht im {raum} auf {anteil}"]}
  rühren: {action: custom, sentences: ["rühr den Brei [{zeit} lang]", "rühr den Topf in {zeit} um"]}
  gießen: {action: custom, sentences: ["gieße die Pflanzen am Fenster {n}"]}
  stellen: {action: custom, sentences: ["stell die {gerät} in den {raum}"]}
  holen: {action: custom, sentences: ["hol {ding}"]}
  bringen: {action: custom, sentences: ["bring die {gerät} in den {raum}", "bring {ding} in den {raum}"]}
"""
SPANISH = """
language: es
slots: {sala: [cocina, sala], aparato: [lámpara, bomba], tiempo: duration, ritmo: [despacio, rápido], n: number}
intents:
  mover: {action: custom, sentences: ["mueve la {aparato} [{ritmo}] [durante {tiempo}]"]}
  llevar: {action: custom, sentences: ["lleva {n} cajas a la {sala}"]}
  encender: {action: custom, sentences: ["enciende la {aparato} [en la {sala}]"]}
"""
ENGLISH = """
language: en
slots: {side: [left, right], far: {type: angle, unit: deg}, time: duration, n: number, m: number, thing: text,
  room: [hall, bath], share: percent, shelf: [A, B]}
intents:
  rotate: {action: custom, sentences: ["rotate the mirror [to the] {side} [by] [{far}]"]}
  pan: {action: custom, sentences: ["pan [to the] {side} [by] [{far}]"]}
  dim: {action: custom, sentences: ["dim the light in the {room} to {share}"]}
  wait: {action: custom, sentences: ["wait outside room {n} [for {time}]"]}
  mix: {action: custom, sentences: ["mix {n} with {m}"]}
  hide: {action: custom, sentences: ["hide {thing} for {time}"]}
  store: {action: custom, sentences: ["store the box (on|in) shelf {shelf}"]}
"""
GRAMMARS = {"de": GERMAN, "es": SPANISH, "en": ENGLISH}


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {language: engine_of(text) for language, text in GRAMMARS.items()}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("de", "Mach im Flur das Licht an", "mach das Licht im Flur an"),
        ("de", "mach bitte im Bad das Licht an", "mach das Licht im Bad an"),
        ("de", "schalte im Flur die Pumpe ein", "schalte die Pumpe im Flur ein"),
        ("de", "dimme im Flur das Licht auf 20 Prozent", "dimme das Licht im Flur auf 20 Prozent"),
        ("de", "im Flur dimme das Licht auf 20 Prozent", "dimme das Licht im Flur auf 20 Prozent"),
        ("de", "im Bad mach das Licht an", "mach das Licht im Bad an"),
        ("de", "im Flur schalte bitte die Pumpe ein", "schalte die Pumpe im Flur ein"),
        ("de", "rühr zehn Minuten lang den Brei", "rühr den Brei zehn Minuten lang"),
        ("de", "zehn Minuten lang den Brei rühren", "rühr den Brei zehn Minuten lang"),
        ("en", "in the hall dim the light to ten percent", "dim the light in the hall to ten percent"),
        ("de", "gieße am Fenster 3 die Pflanzen", "gieße die Pflanzen am Fenster 3"),
        ("es", "enciende en la cocina la bomba", "enciende la bomba en la cocina"),
        ("es", "mueve durante diez minutos la bomba", "mueve la bomba durante diez minutos"),
        ("es", "mueve despacio la bomba", "mueve la bomba despacio"),
        ("es", "lleva a la cocina diez cajas", "lleva diez cajas a la cocina"),
        ("de", "bring in den Flur die Pumpe", "bring die Pumpe in den Flur"),
        ("en", "pan thirty degrees to the left", "pan to the left thirty degrees"),
        ("en", "pan 15 degrees right", "pan right 15 degrees"),
        ("en", "pan 15 right", "pan right 15"),
        ("en", "rotate the mirror thirty degrees to the left", "rotate the mirror to the left thirty degrees"),
        ("en", "wait for five minutes outside room 14", "wait outside room 14 for five minutes"),
        ("en", "store the box on the b shelf", "store the box on shelf b"),
    ],
)
def test_it_is_said_behind_it(engines, language: str, said: str, meant: str) -> None:
    assert_same(engines[language], said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("de", "mach im Flur nicht das Licht an"),
        ("de", "mach im Flur das Licht an oder aus"),
        ("de", "mach in den Flur das Licht an"),
        ("de", "mach im Garten das Licht an"),
        ("de", "mach im Flur im Bad das Licht an"),
        ("de", "mach im Flur, das Licht an"),
        ("de", "im Flur dimme im Bad das Licht auf 20 Prozent"),
        ("de", "im Flur mach das Licht im Bad an"),
        ("de", "im Flur ist das Licht an"),
        ("de", "im Flur dimme nicht das Licht auf 20 Prozent"),
        ("de", "in zehn Minuten rühr den Brei"),
        ("de", "rühr zehn Minuten breit den Brei"),
        ("de", "stell im Flur die Lampe"),
        ("de", "ich mach im Flur das Licht an"),
        ("de", "wenn im Flur das Licht an ist"),
        ("es", "no enciendas en la cocina la bomba"),
        ("es", "enciende a la cocina la bomba"),
        ("es", "mueve despacio, la bomba"),
        ("es", "mueve despacio y la bomba"),
        ("de", "bring in den Flur Wasser"),
        ("en", "store the box on a shelf"),
        ("en", "store the box in a shelf"),
        ("en", "pan thirty degrees to the left or right"),
        ("en", "mix with 3 5"),
        ("en", "pan left to the"),
        ("en", "pan 5 degrees uh 5 left"),
        ("en", "pan 5 degrees uh 6 left"),
        ("en", "rotate the mirror by to the left"),
        ("en", "pan one pan left"),
        ("en", "hide for ten minutes the cup"),
    ],
)
def test_what_may_be_meant_otherwise_does_nothing(engines, language: str, said: str) -> None:
    assert not engines[language].parse(said).actions


def test_free_words_take_it_as_it_was_said(engines) -> None:
    assert engines["de"].parse("hol im Flur Wasser").slots in ({}, {"ding": "im flur wasser"})
