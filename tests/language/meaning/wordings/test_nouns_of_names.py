"""Names of a list that share their noun, said without it behind one that was named."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "en": """
language: en
slots:
  bin: [left bin, right bin, middle bin]
  lamp: [red lamp, desk lamp]
  part: [cube, ball]
intents:
  put: {action: custom, sentences: ["put the {part} in the {bin}"]}
  open: {action: custom, sentences: ["open the {bin}"]}
  close: {action: custom, sentences: ["close the {bin}"]}
  light: {action: custom, sentences: ["light the {lamp}"]}
""",
    "de": """
language: de
slots: {lampe: [linke Lampe, rechte Lampe, rote Lampe]}
intents:
  an: {action: custom, sentences: ["schalte die {lampe} an"]}
  aus: {action: custom, sentences: ["schalte die {lampe} aus"]}
  dimmen: {action: custom, sentences: ["dimm die {lampe}"]}
""",
    "fr": """
language: fr
slots: {tapis: [tapis d'entrée, tapis de sortie, tapis principal]}
intents:
  avancer: {action: custom, sentences: ["avance le {tapis}"]}
  reculer: {action: custom, sentences: ["recule le {tapis}"]}
""",
    "es": """
language: es
slots: {pista: [la pista azul, la pista negra, el parque]}
intents:
  abrir: {action: custom, sentences: ["abre {pista}"]}
  cerrar: {action: custom, sentences: ["cierra {pista}"]}
""",
    "it": """
language: it
slots: {vasca: [vasca grande, vasca piccola]}
intents:
  riempire: {action: custom, sentences: ["riempi la {vasca}"]}
  svuotare: {action: custom, sentences: ["svuota la {vasca}"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("en", "open the left bin and close the right one", "open the left bin and close the right bin"),
        ("en", "open the left bin and the right one", "open the left bin and the right bin"),
        ("en", "open the left bin, close the right one and open the middle one",
         "open the left bin, close the right bin and open the middle bin"),
        ("en", "put the cube in the left bin and the ball in the right one",
         "put the cube in the left bin and the ball in the right bin"),
        ("en", "light the red lamp and the desk one", "light the red lamp and the desk lamp"),
        ("de", "schalte die linke Lampe an und die rechte aus", "schalte die linke Lampe an und die rechte Lampe aus"),
        ("de", "dimm die linke Lampe, die rechte und die rote",
         "dimm die linke Lampe, die rechte Lampe und die rote Lampe"),
        ("fr", "avance le tapis d'entrée et recule le principal",
         "avance le tapis d'entrée et recule le tapis principal"),
        ("es", "abre la pista azul y cierra la negra", "abre la pista azul y cierra la pista negra"),
        ("es", "abre la pista azul, no, la negra", "abre la pista negra"),
        ("it", "riempi la vasca grande e svuota la piccola", "riempi la vasca grande e svuota la vasca piccola"),
    ],
)  # fmt: skip
def test_the_noun_is_that_of_the_name_before(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "close the right one"),
        ("en", "open the left bin and close the right"),  # a side, or it broke off
        ("en", "open the left bin and close the left one"),
        ("en", "open the left bin and close the top one"),
        ("en", "light the red lamp and close the right one"),
        ("en", "open the left bin and don't close the right one"),
        ("en", "open the left bin, the right one is full of it"),
        ("en", "open the left bin or the right one"),
        ("de", "dimm die linke Lampe und die grüne"),
        ("de", "dimm die linke Lampe, die rechte ist kaputt"),
        ("de", "dimm die linke Lampe oder die rechte"),
        ("fr", "avance le tapis d'entrée et recule le grand"),
        ("es", "abre el parque y cierra la negra"),
        ("es", "abre la pista azul o la negra"),
        ("it", "la vasca grande è piena e svuota la piccola"),
    ],
)
def test_else_nothing_is_done(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions
