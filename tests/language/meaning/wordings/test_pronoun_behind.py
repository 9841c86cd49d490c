"""For whom something is done is asked before the verb or with its infinitive, where a sentence has it behind the
verb."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "fr": """
language: fr
slots: {lieu: [jardin, salon]}
intents:
  aller: {action: custom, sentences: ["(emmène-nous|conduis-nous) au {lieu}"]}
""",
    "es": """
language: es
slots: {lugar: [jardín, salón]}
intents:
  ir: {action: custom, sentences: ["llévanos al {lugar}"]}
""",
    "it": """
language: it
slots: {luogo: [giardino, salone]}
intents:
  andare: {action: custom, sentences: ["portaci (al|in) {luogo}"]}
""",
}
USUAL = {"fr": "emmène-nous au jardin", "es": "llévanos al jardín", "it": "portaci al giardino"}


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("fr", "peux-tu nous emmener au jardin ?"),
        ("fr", "est-ce que tu pourrais nous conduire au jardin, s'il te plaît ?"),
        ("fr", "je voudrais que tu nous emmènes au jardin"),
        ("fr", "tu nous emmènes au jardin, s'il te plaît ?"),
        ("es", "¿puedes llevarnos al jardín?"),
        ("es", "¿nos puedes llevar al jardín?"),
        ("es", "¿nos llevas al jardín?"),
        ("es", "quiero que nos lleves al jardín"),
        ("es", "llévenos al jardín, por favor"),
        ("it", "puoi portarci al giardino?"),
        ("it", "ci puoi portare al giardino?"),
        ("it", "ci porti al giardino?"),
        ("it", "vorrei che ci portassi al giardino"),
    ],
)
def test_it_is_the_same(engine_of, language: str, said: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, USUAL[language])


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("fr", "peux-tu me conduire au jardin ?"),  # the sentence leads more than one
        ("fr", "peux-tu emmener au jardin ?"),
        ("fr", "peux-tu ne pas nous emmener au jardin ?"),
        ("fr", "tu nous emmènes au jardin ?"),
        ("fr", "il nous emmène au jardin"),
        ("fr", "nous emmener au jardin"),
        ("es", "nos lleva al jardín"),
        ("es", "¿nos llevaste al jardín?"),
        ("es", "¿puedes llevarlo al jardín?"),
        ("es", "no nos lleves al jardín"),
        ("es", "no quiero que nos lleves al jardín"),
        ("it", "ci porta al giardino"),
        ("it", "puoi portarlo al giardino?"),
        ("it", "non ci portare al giardino"),
        ("it", "non vorrei che ci portassi al giardino"),
    ],
)
def test_what_tells_or_forbids_does_nothing(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions
