"""Commands as they are told to a stranger, of a grammar that has them as they are told to a friend."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

GERMAN = """
language: de
slots: {gerät: [Lampe, Pumpe], n: {type: number, whole: true}, anteil: percent, ding: [Hammer, Becher]}
intents:
  ein: {action: custom, sentences: ["schalte die {gerät} ein"]}
  aus: {action: custom, sentences: ["schalte die {gerät} aus"]}
  fach: {action: custom, sentences: ["öffne Fach {n}"]}
  nehmen: {action: custom, sentences: ["nimm den {ding}"]}
  wärmen: {action: custom, sentences: ["wärme den {ding} auf"]}
  wackeln: {action: custom, sentences: ["wackle mit dem {ding}"]}
  drehen: {action: custom, sentences: ["dreh dich um"]}
"""
FRENCH = """
language: fr
slots: {appareil: [lampe, pompe], n: {type: number, whole: true}}
intents:
  allumer: {action: custom, sentences: ["allume la {appareil}"]}
  éteindre: {action: custom, sentences: ["éteins la {appareil}"]}
  ouvrir: {action: custom, sentences: ["ouvre le tiroir {n}"]}
  finir: {action: custom, sentences: ["finis le tour {n}"]}
  prendre: {action: custom, sentences: ["prends la {appareil}"]}
"""
GRAMMARS = {"de": GERMAN, "fr": FRENCH}


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {language: engine_of(text) for language, text in GRAMMARS.items()}


@pytest.mark.parametrize(
    ("language", "formal", "friendly"),
    [
        ("de", "Schalten Sie die Lampe ein", "schalte die Lampe ein"),
        ("de", "Schalten Sie bitte die Lampe aus.", "schalte die Lampe aus"),
        ("de", "Bitte öffnen Sie Fach 3!", "öffne Fach 3"),
        ("de", "Nehmen Sie den Hammer", "nimm den Hammer"),
        ("de", "Wärmen Sie den Becher auf", "wärme den Becher auf"),
        ("de", "Wackeln Sie mit dem Hammer", "wackle mit dem Hammer"),
        ("de", "Drehen Sie sich um", "dreh dich um"),
        ("de", "Öffnen Sie Fach 3 und schalten Sie dann die Pumpe ein", "öffne Fach 3 und schalte dann die Pumpe ein"),
        ("de", "Öffnen Sie Fach 3 und 4", "öffne Fach 3 und 4"),
        ("de", "Öffnen Sie Fach 3, nein, 5", "öffne Fach 5"),
        ("fr", "allumez la lampe", "allume la lampe"),
        ("fr", "éteignez la pompe", "éteins la pompe"),
        ("fr", "ouvrez le tiroir 3, s'il vous plaît", "ouvre le tiroir 3"),
        ("fr", "finissez le tour 3 et prenez la pompe", "finis le tour 3 et prends la pompe"),
    ],
)
def test_it_is_what_is_told_to_a_friend(engines, language: str, formal: str, friendly: str) -> None:
    wanted = engines[language].parse(friendly).actions
    assert wanted
    assert engines[language].parse(formal).actions == wanted


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("de", "Schalten Sie die Lampe ein?"),
        ("de", "Sie schalten die Lampe ein"),
        ("de", "Schalten wir die Lampe ein"),
        ("de", "Schalten Sie die Lampe nicht ein"),
        ("de", "Schalten Sie die Lampe ein oder aus"),
        ("de", "wenn Sie die Lampe einschalten"),
        ("de", "Schalten Sie die Heizung ein"),
        ("de", "Haben Sie Fach 3 geöffnet"),
        ("fr", "allumez-vous la lampe"),
        ("fr", "vous allumez la lampe"),
        ("fr", "n'allumez pas la lampe"),
        ("fr", "si vous allumez la lampe"),
    ],
)
def test_what_asks_or_tells_or_forbids_does_nothing(engines, language: str, said: str) -> None:
    assert not engines[language].parse(said).actions


def test_a_grammar_with_forms_of_its_own_says_of_which_verbs(engine_of) -> None:
    engine = engine_of("""
language: de
slots: {raum: [Küche, Bad], wie: [schön, groß]}
intents:
  suchen: {action: custom, sentences: ["(suche|suchen sie|finde) die {raum} [{wie}]"]}
""")
    assert engine.parse("Suchen Sie die Küche").actions
    assert engine.parse("finde die Küche").actions
    assert not engine.parse("Finden Sie die Küche schön").actions
