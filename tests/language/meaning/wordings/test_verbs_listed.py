"""Verbs that are values of a list, in another form than the list has them."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine.interpretation import Status

GRAMMARS = {
    "fr": """
language: fr
slots: {état: {type: choice, values: {ouverte: [ouvre], fermée: [ferme]}}}
intents:
  vanne: {action: custom, sentences: ["{état} la vanne"]}
""",
    "it": """
language: it
slots: {stato: {type: choice, values: {aperto: [apri], chiuso: [chiudi]}}}
intents:
  sportello: {action: custom, sentences: ["{stato} lo sportello"]}
""",
    "de": """
language: de
slots: {stellung: {type: choice, values: {offen: [öffne], dicht: [schließe]}}}
intents:
  ventil: {action: custom, sentences: ["{stellung} das Ventil"]}
""",
    "en": """
language: en
slots: {state: {type: choice, values: {up: [lift], down: [lower]}}}
intents:
  boom: {action: custom, sentences: ["{state} the boom"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("fr", "fermez la vanne", "ferme la vanne"),
        ("fr", "peux-tu fermer la vanne", "ferme la vanne"),
        ("fr", "veuillez ouvrir la vanne", "ouvre la vanne"),
        ("it", "apra lo sportello", "apri lo sportello"),
        ("it", "puoi chiudere lo sportello", "chiudi lo sportello"),
        ("de", "öffnen Sie das Ventil", "öffne das Ventil"),
        ("de", "kannst du das Ventil schließen", "schließe das Ventil"),
    ],
)
def test_it_is_the_order(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("fr", "fermer la vanne"),
        ("fr", "il ferme la vanne"),
        ("fr", "ouvra la vanne"),  # it is asked about
        ("it", "apre lo sportello"),
        ("it", "non apra lo sportello"),
        ("de", "das Ventil schließt"),
        ("en", "lowers the boom"),
        ("en", "he lowers the boom"),
    ],
)
def test_what_tells_denies_or_is_not_clear_does_nothing(engine_of, language: str, said: str) -> None:
    found = engine_of(GRAMMARS[language]).parse(said)
    assert found.status is not Status.ACCEPTED, found
