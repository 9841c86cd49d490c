"""One of several that is told by its place alone: "close the first valve and open the second"."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "en": """
language: en
slots: {n: {type: ordinal, max: 8}, door: {type: ordinal, max: 3}}
intents:
  open: {action: custom, sentences: ["open the {n} valve", "open the {door} door"]}
  close: {action: custom, sentences: ["close the {n} valve"]}
  wait: {action: custom, sentences: [rest]}
""",
    "es": """
language: es
slots: {n: {type: ordinal, max: 8}}
intents:
  abrir: {action: custom, sentences: ["abre la {n} válvula"]}
  cerrar: {action: custom, sentences: ["cierra la {n} válvula"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("en", "close the first valve and open the second", "close the first valve and open the second valve"),
        ("en", "close the first valve, then open the last one", "close the first valve, then open the last valve"),
        ("en", "open the second door, rest and open the third", "open the second door, rest and open the third door"),
        ("es", "cierra la primera válvula y abre la segunda", "cierra la primera válvula y abre la segunda válvula"),
    ],
)
def test_it_is_one_of_the_same(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    "said",
    [
        "open the second",
        "rest and open the second",
        "open the second and close the first valve",
        "close the first valve, open the second door and open the third",
        "close the first valve and don't open the second",
        "open the second door and close the third",
    ],
)
def test_of_nothing_or_of_two_kinds_of_things_nobody_knows_which(engine_of, said: str) -> None:
    assert not engine_of(GRAMMARS["en"]).parse(said).actions
