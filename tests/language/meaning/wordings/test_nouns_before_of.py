"""A second thing of the kind that was named is told by whose it is alone."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMAR = """
language: {language}
slots: {{room: [{rooms}]}}
intents:
  open: {{action: custom, sentences: ["{open}"]}}
  close: {{action: custom, sentences: ["{close}"]}}
"""
WORDS = {
    "en": ("cellar, attic", "open the door of the {room}", "close the door of the {room}"),
    "de": ("Keller, Flur", "öffne die Tür vom {room}", "sperr die Tür vom {room} zu"),
    "fr": ("cave, grenier", "ouvre la porte (de la|du) {room}", "ferme la porte (de la|du) {room}"),
    "es": ("entrada, salida", "abre la puerta de [la] {room}", "cierra la puerta de [la] {room}"),
    "it": ("cantina, soffitta", "apri la porta della {room}", "chiudi la porta della {room}"),
}
CASES = [
    ("en", "open the door of the cellar and that of the attic",
     "open the door of the cellar and open the door of the attic"),
    ("de", "öffne die Tür vom Keller und die vom Flur", "öffne die Tür vom Keller und öffne die Tür vom Flur"),
    ("fr", "ouvre la porte de la cave et celle du grenier",
     "ouvre la porte de la cave et ouvre la porte du grenier"),
    ("fr", "ouvre la porte de la cave et ferme celle du grenier",
     "ouvre la porte de la cave et ferme la porte du grenier"),
    ("es", "abre la puerta de entrada y la de salida", "abre la puerta de entrada y abre la puerta de salida"),
    ("es", "abre la puerta de la entrada y cierra la de la salida",
     "abre la puerta de la entrada y cierra la puerta de la salida"),
    ("it", "apri la porta della cantina e quella della soffitta",
     "apri la porta della cantina e apri la porta della soffitta"),
]  # fmt: skip
NOTHING = [
    ("en", "open the door of the cellar or that of the attic"),
    ("en", "open that of the attic"),
    ("de", "die vom Flur"),
    ("fr", "n'ouvre pas la porte de la cave ni celle du grenier"),
    ("fr", "ouvre celle du grenier"),
    ("fr", "ouvre la porte de la cave et celui du grenier"),
    ("es", "abre la de salida"),
    ("es", "abre la puerta de entrada o la de salida"),
    ("es", "abre la puerta de entrada y no abras la de salida"),
    ("es", "abre la puerta de entrada y el de salida"),
    ("it", "apri quella della soffitta"),
]


def grammar_of(language: str) -> str:
    rooms, opening, closing = WORDS[language]
    return GRAMMAR.format(language=language, rooms=rooms, open=opening, close=closing)


@pytest.mark.parametrize(("language", "said", "meant"), CASES)
def test_the_noun_is_put_in(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(grammar_of(language)), said, meant)


@pytest.mark.parametrize(("language", "said"), NOTHING)
def test_without_such_a_noun_nothing_is_done(engine_of, language: str, said: str) -> None:
    assert not engine_of(grammar_of(language)).parse(said).actions
