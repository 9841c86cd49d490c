"""What may be said anew behind a word of doubt, and what says no further: "turn left, maybe right"."""

from __future__ import annotations

import pytest
from meanings import does

from intent_engine.interpretation import Status

WORDS = {
    "en": ("maybe", "turn left", "turn right"),
    "de": ("vielleicht", "dreh links", "dreh rechts"),
    "fr": ("peut-être", "tourne à gauche", "tourne à droite"),
    "es": ("quizás", "gira a la izquierda", "gira a la derecha"),
    "it": ("forse", "gira a sinistra", "gira a destra"),
}


@pytest.mark.parametrize("language", WORDS)
def test_what_may_be_the_other_is_asked(engine_of, language: str) -> None:
    doubt, left, right = WORDS[language]
    verb, _, side = left.partition(" ")
    other = right.partition(" ")[2]
    engine = engine_of(
        f"language: {language}\nfillers: [{doubt}]\nslots: {{side: {{type: choice, values: [{side}, {other}]}}}}\n"
        f'intents: {{turn: {{action: custom, sentences: ["{verb} {{side}}", "{{side}}"]}}}}\n'
    )
    for said in (f"{left}, {doubt} {other}", f"{left}, {doubt} {right}", f"{doubt} {left}, {doubt} {right}"):
        found = engine.parse(said)
        assert (found.status, found.actions) == (Status.AMBIGUOUS, ()), said
    assert len(engine.parse(f"{doubt} {left}").actions) == 1


@pytest.mark.parametrize(
    "said", ["go no further left", "go no farther left", "turn left, no more", "no more right turns, turn left"]
)
def test_no_further_is_no_correction(said: str) -> None:
    assert does(said) == Status.REJECTED.value
