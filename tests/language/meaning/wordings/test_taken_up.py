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


AGAIN = {
    "fr": """
language: fr
slots: {chose: [porte, fenêtre, volet], pièce: [cuisine, salon]}
intents:
  ouvrir: {action: custom, sentences: ["ouvre (la|le) {chose}"]}
  fermer: {action: custom, sentences: ["ferme (la|le) {chose}"]}
  nettoyer: {action: custom, sentences: ["nettoie (la|le) {pièce}"]}
  poser: {action: custom, sentences: ["pose (la|le) {chose} (devant|dans) (la|le) {pièce}"]}
""",
    "es": """
language: es
slots: {cosa: [puerta, ventana, grifo]}
intents:
  abrir: {action: custom, sentences: ["abre (la|el) {cosa}"]}
  cerrar: {action: custom, sentences: ["cierra (la|el) {cosa}"]}
""",
    "it": """
language: it
slots: {cosa: [porta, finestra]}
intents:
  aprire: {action: custom, sentences: ["apri la {cosa}"]}
  chiudere: {action: custom, sentences: ["chiudi la {cosa}"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("fr", "ouvre la porte et ferme-la", "ouvre la porte et ferme la porte"),
        ("fr", "ouvrez la fenêtre, puis fermez-la", "ouvre la fenêtre puis ferme la fenêtre"),
        ("fr", "ouvre le volet et ferme-le", "ouvre le volet et ferme le volet"),
        ("fr", "ouvre la porte et pose-la devant le salon", "ouvre la porte et pose la porte devant le salon"),
        ("fr", "la porte, ouvre-la et pose-la dans la cuisine", "ouvre la porte et pose la porte dans la cuisine"),
        ("es", "abre la puerta y ciérrala", "abre la puerta y cierra la puerta"),
        ("es", "abra el grifo y luego ciérrelo", "abre el grifo y luego cierra el grifo"),
        ("it", "apri la porta e poi chiudila", "apri la porta e poi chiudi la porta"),
    ],
)
def test_a_later_verb_takes_it_up(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(AGAIN[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("fr", "ouvre le volet et ferme-la"),  # no such thing was named
        ("fr", "ouvre la porte et nettoie-la"),
        ("fr", "ouvre la porte et ne la ferme pas"),
        ("fr", "ouvre la porte, ouvre la fenêtre et ferme-la"),  # which?
        ("fr", "ferme-la"),
        ("fr", "ouvre la porte et ne la pose pas devant le salon"),
        ("fr", "ouvre le volet et pose-la devant le salon"),
        ("es", "abre la puerta y ciérralo"),
        ("es", "abre la puerta y no la cierres"),
        ("es", "la puerta y la ventana ciérrala"),
        ("it", "apri la porta e la chiude Mario"),
        ("it", "chiudila"),
    ],
)
def test_what_was_not_named_is_not_taken_up(engine_of, language: str, said: str) -> None:
    assert not engine_of(AGAIN[language]).parse(said).actions
