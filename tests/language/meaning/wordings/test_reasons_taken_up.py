"""A reason told of the thing for which the pronoun of the order behind it stands."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "de": """
language: de
slots: {ding: [Pumpe, Heizung, Orchideen], l: {type: number, max: 9}}
intents:
  an: {action: custom, sentences: ["schalte die {ding} ein"]}
  aus: {action: custom, sentences: ["schalte die {ding} aus"]}
  gießen: {action: custom, sentences: ["gieß die {ding} [mit {l} Litern]"]}
""",
    "fr": """
language: fr
slots: {appareil: [pompe, lampe]}
intents:
  éteindre: {action: custom, sentences: ["éteins la {appareil}"]}
""",
    "es": """
language: es
slots: {pista: [la pista azul, la pista negra]}
intents:
  cerrar: {action: custom, sentences: ["cierra {pista}", "apaga la sirena"]}
""",
    "it": """
language: it
intents:
  spegnere: {action: custom, sentences: ["spegni la luce"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("de", "die Orchideen sind trocken, gieß sie bitte mit zwei Litern", "gieß die Orchideen mit zwei Litern"),
        ("de", "die Orchideen welken, gieß sie", "gieß die Orchideen"),
        ("de", "die Pumpe ist zu laut, schalte sie aus", "schalte die Pumpe aus"),
        ("de", "die Pumpe ist aus, schalte sie ein", "schalte die Pumpe ein"),
        ("fr", "la pompe est trop bruyante, éteins-la", "éteins la pompe"),
        ("es", "la sirena está muy alta, apágala", "apaga la sirena"),
        ("es", "la pista azul está helada, ciérrala", "cierra la pista azul"),
        ("it", "la luce è troppo forte, spegnila", "spegni la luce"),
    ],
)
def test_it_is_that_thing(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("de", "die Orchideen sind trocken, gieß ihn"),
        ("de", "die Pumpe war zu laut, schalte sie aus"),
        ("de", "die Pumpe ist nicht zu laut, schalte sie aus"),
        ("de", "die Pumpe ist neben der Heizung, schalte sie aus"),
        ("de", "die Pumpe kann laut sein, schalte sie aus"),
        ("de", "die Pumpe ist laut und die Heizung auch, schalte sie aus"),
        ("de", "die Pumpe ist laut, schalte sie nicht aus"),
        ("fr", "la pompe est trop bruyante, éteins-le"),
        ("es", "la sirena está alta, no la apagues"),
        ("it", "la luce era troppo forte, spegnila"),
    ],
)
def test_else_nothing_is_done(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions
