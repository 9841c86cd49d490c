"""A pronoun with the verb, for a thing of an earlier order in the same utterance or in the one before."""

from __future__ import annotations

import pytest

GRAMMARS = {
    "fr": """
language: fr
slots:
  four: {type: number, min: 1, max: 6, whole: true}
  poisson: [raies, requins]
  durée: duration
intents:
  ouvrir: {action: custom, sentences: ["ouvre le four [{four}]"]}
  fermer: {action: custom, sentences: ["ferme le four [{four}]"]}
  allumer: {action: custom, sentences: ["allume la pompe [du four {four}]"]}
  éteindre: {action: custom, sentences: ["éteins la pompe [du four {four}]"]}
  filmer: {action: custom, sentences: ["filme les {poisson} [pendant {durée}]"]}
  nourrir: {action: custom, sentences: ["nourris les {poisson} [pendant {durée}]"]}
""",
    "es": """
language: es
slots:
  n: {type: number, min: 1, max: 40, whole: true}
  puerta: {type: ordinal, max: 6}
  pista: [la pista azul, la pista negra]
  tiempo: duration
intents:
  encender: {action: custom, sentences: ["enciende el cañón {n}", "enciende la sirena"]}
  apagar: {action: custom, sentences: ["apaga el cañón {n}", "apaga la sirena"]}
  abrir: {action: custom, sentences: ["abre la {puerta} puerta", "abre {pista} [durante {tiempo}]"]}
  cerrar: {action: custom, sentences: ["cierra la {puerta} puerta", "cierra {pista} [durante {tiempo}]"]}
""",
    "it": """
language: it
slots: {cosa: [ago, piedino]}
intents:
  alzare: {action: custom, sentences: ["alza (il |l'){cosa}"]}
  abbassare: {action: custom, sentences: ["abbassa (il |l'){cosa}"]}
""",
}


@pytest.mark.parametrize(
    ("language", "before", "said", "meant"),
    [
        ("fr", "ouvre le four 1", "ferme-le", "ferme le four 1"),
        ("fr", "ouvre le four", "ferme-le, s'il te plaît", "ferme le four"),
        ("fr", "ouvre le four 2", "ferme-le !", "ferme le four 2"),
        ("fr", "éteins la pompe du four 2", "allume-la", "allume la pompe du four 2"),
        ("fr", "filme les raies pendant dix minutes", "nourris-les", "nourris les raies"),
        ("fr", "filme les raies", "nourris-les pendant dix minutes", "nourris les raies pendant dix minutes"),
        ("es", "enciende el cañón 3", "apágalo", "apaga el cañón 3"),
        ("es", "enciende la sirena", "apágala, por favor", "apaga la sirena"),
        ("es", "abre la segunda puerta", "ciérrala", "cierra la segunda puerta"),
        ("es", "abre la pista azul durante una hora", "ciérrala", "cierra la pista azul"),
        ("es", "abre la pista azul", "ciérrala durante dos horas", "cierra la pista azul durante dos horas"),
        ("it", "alza il piedino", "abbassalo", "abbassa il piedino"),
        ("it", "alza l'ago", "abbassalo", "abbassa l'ago"),
    ],
)
def test_it_is_the_thing_of_the_command_before(engine_of, language: str, before: str, said: str, meant: str) -> None:
    engine = engine_of(GRAMMARS[language])
    last = engine.parse(before)
    assert last.actions
    assert engine.parse(said, last=last).actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize(
    ("language", "before", "said"),
    [
        ("fr", "ouvre le four 1", "ferme le"),  # "ferme le four", of which the rest was not heard
        ("fr", "ouvre le four 1", "ferme-la"),
        ("fr", "filme les raies, puis filme les requins", "nourris-les"),
        ("fr", "ouvre le four 1", "ne le ferme pas"),
        ("fr", "ouvre le four 1", "il a dit ferme-le"),
        ("es", "enciende el cañón 3", "apágala"),
        ("es", "enciende el cañón 3", "no lo apagues"),
        ("es", "abre la pista azul", "cierra la"),
        ("es", "abre la segunda puerta", "apágala"),
        ("it", "alza il piedino", "abbassala"),
        ("it", "alza il piedino", "non abbassarlo"),
    ],
)
def test_else_nothing_is_done(engine_of, language: str, before: str, said: str) -> None:
    engine = engine_of(GRAMMARS[language])
    last = engine.parse(before)
    assert last.actions
    assert not engine.parse(said, last=last).actions


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("fr", "ouvre le four 1 et ferme-le", "ouvre le four 1 et ferme le four 1"),
        ("fr", "éteins la pompe du four 2 et allume-la", "éteins la pompe du four 2 et allume la pompe du four 2"),
        ("fr", "filme les raies pendant dix minutes et nourris-les",
         "filme les raies pendant dix minutes et nourris les raies"),
        ("es", "enciende el cañón 3 y apágalo", "enciende el cañón 3 y apaga el cañón 3"),
    ],
)  # fmt: skip
def test_a_name_is_all_that_tells_which_it_is(engine_of, language: str, said: str, meant: str) -> None:
    engine = engine_of(GRAMMARS[language])
    assert engine.parse(said).actions == engine.parse(meant).actions != ()
