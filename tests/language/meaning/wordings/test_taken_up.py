"""A thing that is said first and taken up by a pronoun with the verb."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "fr": """
language: fr
slots: {quoi: [pelle, caisse, râteau], loin: distance}
intents:
  ouvrir: {action: custom, sentences: ["ouvre (la|le) {quoi}"]}
  monter: {action: custom, sentences: ["monte (la|le) {quoi} de {loin}"]}
""",
    "es": """
language: es
slots: {cosa: [pala, caja], nivel: {type: percent, unit: percent}}
intents:
  traer: {action: custom, sentences: ["trae la {cosa}"]}
  poner: {action: custom, sentences: ["pon la luz a {nivel}"]}
""",
    "it": """
language: it
slots: {cosa: [pala, cassa], livello: {type: percent, unit: percent}}
intents:
  portare: {action: custom, sentences: ["porta la {cosa}"]}
  mettere: {action: custom, sentences: ["metti il volume a {livello}"]}
""",
    "de": """
language: de
slots: {was: [Tür, Pumpe]}
intents:
  öffnen: {action: custom, sentences: ["öffne die {was}"]}
  schalten: {action: custom, sentences: ["schalte die {was} ein"]}
  drücken: {action: custom, sentences: ["drück den Knopf"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("fr", "la caisse, ouvre-la", "ouvre la caisse"),
        ("fr", "le râteau, montez-le de deux mètres", "monte le râteau de deux mètres"),
        ("es", "la pala, tráemela", "trae la pala"),
        ("es", "la luz ponla al veinte por ciento", "pon la luz a veinte por ciento"),
        ("it", "la cassa, portamela per favore", "porta la cassa"),
        ("it", "il volume mettilo al venti per cento", "metti il volume a venti per cento"),
        ("it", "metti il volume all'otto per cento", "metti il volume a otto per cento"),
        ("de", "die Tür, öffne sie bitte", "öffne die Tür"),
        ("de", "die Pumpe, schalten Sie die ein", "schalte die Pumpe ein"),
        ("de", "der Knopf, drück ihn", "drück den Knopf"),
    ],
)
def test_it_is_the_order(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("fr", "la caisse, ne l'ouvre pas"),
        ("fr", "la caisse, ouvre-le"),
        ("fr", "la caisse, la pelle, ouvre-la"),
        ("fr", "la caisse et la pelle, ouvre-la"),
        ("fr", "la caisse, Paul l'ouvre"),
        ("fr", "la porte, ouvre-la"),
        ("es", "la pala, no la traigas"),
        ("es", "la pala la trae Pablo"),
        ("it", "la cassa, non portarla"),
        ("it", "la cassa, portalo"),
        ("de", "die Tür, öffne ihn"),
        ("de", "die Tür, Paul öffnet sie"),
        ("de", "die Tür, öffne sie nicht"),
    ],
)
def test_what_tells_forbids_or_is_not_clear_does_nothing(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions
