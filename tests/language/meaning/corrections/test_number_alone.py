"""A number corrected that is said without its noun, and what goes on behind it: "two boxes, no, three on the cart"."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "en": """
language: en
slots:
  n: {type: number, whole: true}
  place: [shelf, cart]
  thing: {type: text, max_words: 2}
  angle: angle
  time: duration
intents:
  put: {action: custom, sentences: ["put {n} boxes [on the {place}]"]}
  hide: {action: custom, sentences: ["hide {n} boxes [behind the {thing}]"]}
  tilt: {action: custom, sentences: ["tilt the {place} by {angle} [for {time}]"]}
""",
    "es": """
language: es
slots: {n: {type: number, whole: true}, sitio: [bodega, cocina], modo: [despacio, rápido], tiempo: duration}
intents:
  podar: {action: custom, sentences: ["poda la hilera {n} [{modo}]"]}
  llevar: {action: custom, sentences: ["lleva {n} cajas a la {sitio}"]}
  iluminar: {action: custom, sentences: ["ilumina la {sitio} durante {tiempo}"]}
  cenar: {action: custom, sentences: ["lleva la cena a la habitación {n}"]}
""",
    "de": """
language: de
slots: {weg: distance}
intents:
  senken: {action: custom, sentences: ["senke den Arm [um {weg}]"]}
""",
    "fr": """
language: fr
slots: {temps: duration}
intents:
  filmer: {action: custom, sentences: ["filme la salle [pendant {temps}]"]}
""",
    "it": """
language: it
slots: {tempo: duration}
intents:
  lavare: {action: custom, sentences: ["lava il telaio [per {tempo}]"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("en", "put ten boxes, no, twelve on the shelf", "put twelve boxes on the shelf"),
        ("es", "poda la hilera 14, no, la 15", "poda la hilera 15"),
        ("es", "lleva la cena a la habitación 14, no, a la 15", "lleva la cena a la habitación 15"),
        ("es", "lleva diez cajas, no, doce a la bodega", "lleva doce cajas a la bodega"),
        ("es", "poda la hilera 14, perdón, la quince despacio", "poda la hilera 15 despacio"),
        ("en", "tilt the shelf by ten degrees, no, by twenty", "tilt the shelf by twenty degrees"),
        ("es", "ilumina la bodega durante diez minutos, no, durante 20", "ilumina la bodega durante veinte minutos"),
        ("de", "senke den Arm um zwanzig Zentimeter, nein, um dreißig", "senke den Arm um dreißig Zentimeter"),
        ("fr", "filme la salle pendant dix minutes, non, pendant vingt", "filme la salle pendant vingt minutes"),
        ("it", "lava il telaio per dieci minuti, anzi, per venti", "lava il telaio per venti minuti"),
    ],
)
def test_it_takes_the_place_of_the_number(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "put ten boxes on the cart, no, twelve on the shelf"),
        ("en", "put ten boxes, no, twelve on the floor"),
        ("en", "hide ten boxes, no, twelve behind the old tree"),
        ("es", "lleva diez cajas a la bodega, no, la 15"),
        ("es", "lleva diez cajas a la bodega, no, a la 15"),
        ("es", "poda la hilera 14, no, el 15"),
        ("en", "tilt the shelf by ten degrees, no, for twenty"),
        ("en", "tilt the shelf by ten degrees for two minutes, no, by three"),
        ("en", "tilt the shelf by ten degrees for two minutes, no, for three"),
        ("de", "senke den Arm um zwanzig Zentimeter, nein, auf dreißig"),
    ],
)
def test_what_may_be_of_something_else_is_asked_about(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions
