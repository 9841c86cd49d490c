"""A number corrected that is said without its noun, and what goes on behind it: "two boxes, no, three on the cart"."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "en": """
language: en
slots: {n: {type: number, whole: true}, place: [shelf, cart], thing: {type: text, max_words: 2}}
intents:
  put: {action: custom, sentences: ["put {n} boxes [on the {place}]"]}
  hide: {action: custom, sentences: ["hide {n} boxes [behind the {thing}]"]}
""",
    "es": """
language: es
slots: {n: {type: number, whole: true}, sitio: [bodega, cocina], modo: [despacio, rápido]}
intents:
  podar: {action: custom, sentences: ["poda la hilera {n} [{modo}]"]}
  llevar: {action: custom, sentences: ["lleva {n} cajas a la {sitio}"]}
  cenar: {action: custom, sentences: ["lleva la cena a la habitación {n}"]}
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
    ],
)
def test_what_may_be_of_something_else_is_asked_about(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions
