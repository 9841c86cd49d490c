"""Where an article stands without a word that binds it, another thing begins: nobody takes a "cup the plate"."""

from __future__ import annotations

import pytest

TAKE = {
    "de": "nimm {thing}",
    "en": "take {thing}",
    "es": "coge {thing}",
    "fr": "prends {thing}",
    "it": "prendi {thing}",
}


@pytest.mark.parametrize(
    ("language", "said", "taken"),
    [
        ("en", "take the cup the plate", False),
        ("de", "nimm die Tasse den Teller", False),
        ("fr", "prends la tasse un verre", False),
        ("fr", "prends la tasse mon livre", False),
        ("fr", "prends la tasse la plus grande", True),
        ("fr", "prends le verre d'un ami", True),
        ("fr", "prends la tasse avec une fleur", True),
        ("es", "coge la taza el plato", False),
        ("es", "coge la taza un vaso", False),
        ("es", "coge el libro de mi hermano", True),
        ("es", "coge la taza con el asa", True),
        ("es", "coge la caja junto a la puerta", True),
        ("it", "prendi la tazza il piatto", False),
        ("it", "prendi la tazza un bicchiere", False),
        ("it", "prendi il libro di mia sorella", True),
        ("it", "prendi la tazza dietro la porta", True),
        ("it", "prendi la tazza con la maniglia", True),
    ],
)
def test_two_things_are_not_one(engine_of, language: str, said: str, taken: bool) -> None:
    grammar = f"language: {language}\nslots: {{thing: {{type: object, max_words: 6}}}}\n"
    take = f"action: {{type: pick, object: '{{thing}}'}}, sentences: ['{TAKE[language]}']"
    engine = engine_of(grammar + f"intents: {{take: {{{take}}}}}\n")
    assert bool(engine.parse(said).actions) == taken
