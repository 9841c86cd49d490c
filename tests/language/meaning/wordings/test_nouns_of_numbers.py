"""A number behind its article has the noun of the number before: "baja la bici 4 y sube la 5"."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "es": """
language: es
slots: {n: {type: number, whole: true}}
intents:
  lava: {action: custom, sentences: ["lava la bici {n}"]}
  cuelga: {action: custom, sentences: ["cuelga la bici {n}"]}
  guarda: {action: custom, sentences: ["guarda los {n} cascos"]}
""",
    "fr": """
language: fr
slots: {n: {type: number, whole: true}}
intents:
  ouvre: {action: custom, sentences: ["ouvre la vanne {n}"]}
  ferme: {action: custom, sentences: ["ferme la vanne {n}"]}
""",
    "it": """
language: it
slots: {n: {type: number, whole: true}}
intents:
  alza: {action: custom, sentences: ["alza il ponte {n}"]}
  blocca: {action: custom, sentences: ["blocca il ponte {n}"]}
""",
    "de": """
language: de
slots: {n: {type: number, whole: true}}
intents:
  starte: {action: custom, sentences: ["starte Presse {n}"]}
  stoppe: {action: custom, sentences: ["stoppe die Presse {n}"]}
  fahr: {action: custom, sentences: ["fahr Presse {n} hoch"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("es", "lava la bici 4 y la 5", "lava la bici 4 y lava la bici 5"),
        ("es", "lava la bici veinte y cuelga la veintiuno", "lava la bici 20 y cuelga la bici 21"),
        ("fr", "ouvre la vanne deux et ferme la trois", "ouvre la vanne 2 et ferme la vanne 3"),
        ("fr", "ouvre la vanne deux, et puis la trois aussi", "ouvre la vanne 2 et puis ouvre la vanne 3"),
        ("it", "alza il ponte 2 e blocca il 3", "alza il ponte 2 e blocca il ponte 3"),
        ("de", "starte Presse 3 und stoppe die 4", "starte Presse 3 und stoppe die Presse 4"),
        ("de", "starte Presse 3 und die vier auch", "starte Presse 3 und starte Presse 4"),
        ("de", "fahr Presse 3 hoch und die vier auch", "fahr Presse 3 hoch und fahr Presse 4 hoch"),
        ("de", "fahr Presse 3 hoch und Presse 4 auch", "fahr Presse 3 hoch und fahr Presse 4 hoch"),
    ],
)
def test_it_has_the_noun_of_the_one_before(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("es", "lava la bici 4 y el 5"),
        ("es", "lava la bici 4 y a la una"),
        ("es", "lava la bici 4 y a las 5"),
        ("es", "lava la bici 4 y guarda los 5"),
        ("es", "lava la bici 4 y la 5 no"),
        ("es", "lava la bici 4 o la 5"),
        ("fr", "ouvre la vanne deux ou la trois"),
        ("fr", "ouvre la vanne deux et ne ferme pas la trois"),
        ("it", "alza il ponte 2 e alle 3"),
        ("it", "alza il ponte 2 e il 3 scende"),
        ("de", "starte Presse 3 und um die 4"),
        ("de", "starte Presse 3 und die 4 steht schon"),
        ("de", "fahr Presse 3 hoch und Presse 4"),
        ("de", "fahr Presse 3 hoch und Presse 4 auch nicht"),
    ],
)
def test_where_it_may_be_something_else_nothing_is_done(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions
