"""Half of one more behind what is counted, and numbers that other words divide."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "fr": """
language: fr
slots: {n: number, loin: distance}
intents:
  charger: {action: custom, sentences: ["charge {n} tonnes [de blé]"]}
  avancer: {action: custom, sentences: ["avance de {loin}"]}
""",
    "it": """
language: it
slots: {n: number}
intents: {caricare: {action: custom, sentences: ["carica {n} chili"]}}
""",
    "es": """
language: es
slots: {n: number}
intents: {cargar: {action: custom, sentences: ["carga {n} kilos"]}}
""",
    "de": """
language: de
slots: {n: {type: number, whole: true}, weit: distance}
intents:
  heben: {action: custom, sentences: ["heb Tisch {n} [um] {weit} an"]}
  schalten: {action: custom, sentences: ["schalte Pumpe {n} ein"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("fr", "charge sept tonnes et demie", "charge 7,5 tonnes"),
        ("fr", "chargez deux tonnes et demie de blé", "charge 2,5 tonnes de blé"),
        ("fr", "avance d'environ deux mètres", "avance de deux mètres"),
        ("it", "carica settantadue chili e mezzo", "carica 72,5 chili"),
        ("es", "carga dos kilos y medio", "carga 2,5 kilos"),
        ("de", "heb Tisch sieben bitte zweieinhalb Meter an", "heb Tisch 7 um 2,5 Meter an"),
        ("de", "Pumpe Nummer zwei bitte einschalten", "schalte Pumpe 2 ein"),
    ],
)
def test_it_is_the_amount(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("fr", "charge sept tonnes, et demie"),
        ("fr", "il charge sept tonnes et demie"),
        ("it", "carica chili e mezzo"),
        ("es", "carga dos cajas y media"),
        ("de", "heb Tisch zwanzig, äh, fünf zwei Meter an"),
        ("de", "heb Tisch drei bitte vier an"),
        ("de", "Nummer zwei bitte einschalten"),
    ],
)
def test_what_is_none_does_nothing(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions
