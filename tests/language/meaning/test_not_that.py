""" "Turn left, no, not left, right": a correction that says first what was not meant."""

from __future__ import annotations

import pytest
from meanings import done

from intent_engine import IntentEngine

GRAMMAR = """
language: {language}
slots:
  side: {{type: choice, values: {{left: [{left}], right: [{right}]}}}}
  far: {{type: distance, max: 9 m}}
intents:
  turn: {{action: {{type: turn, direction: "{{side}}"}}, sentences: ["{turn} {{side}}", "{{side}}"]}}
  go: {{action: {{type: move, direction: forward, distance: "{{far}}"}}, sentences: ["{go} {{far}}"]}}
"""
WORDS = {
    "en": {"left": "left", "right": "right", "turn": "turn", "go": "go"},
    "de": {"left": "links", "right": "rechts", "turn": "dreh nach", "go": "fahr"},
    "fr": {"left": "à gauche", "right": "à droite", "turn": "tourne", "go": "avance de"},
    "es": {"left": "a la izquierda", "right": "a la derecha", "turn": "gira", "go": "avanza"},
    "it": {"left": "a sinistra", "right": "a destra", "turn": "gira", "go": "avanza di"},
}
MEANT = [
    ("en", "turn left, no, not left, right", {"side": "right"}),
    ("en", "no, not left, right", {"side": "right"}),
    ("en", "turn left, sorry, not left but right", {"side": "right"}),
    ("en", "go two meters, no, not two meters, three meters", {"far": 3.0}),
    ("de", "dreh nach links, nein, nicht links, rechts", {"side": "right"}),
    ("de", "nein, nicht links, rechts", {"side": "right"}),
    ("de", "dreh nach links, nein, nicht links, sondern rechts", {"side": "right"}),
    ("fr", "tourne à gauche, non, pas à gauche, à droite", {"side": "right"}),
    ("es", "gira a la izquierda, no, no a la izquierda, a la derecha", {"side": "right"}),
    ("it", "gira a sinistra, no, non a sinistra, a destra", {"side": "right"}),
]
UNCLEAR = [
    ("en", "turn left, no, not right, left"),
    ("en", "turn left, no, not left"),
    ("en", "turn left no not left right"),
    ("en", "no not left right"),
    ("en", "no, not left, not right"),
    ("en", "don't turn left, no, not left, right"),
    ("en", "turn left, no, not left, the weather is nice"),
    ("en", "no, not now, right"),
    ("de", "nein, nicht links"),
    ("de", "nein nicht links rechts"),
    ("de", "dreh nach links, nein, nicht links, nicht rechts"),
    ("es", "no, no a la izquierda"),
    ("es", "gira a la izquierda no no a la izquierda a la derecha"),
]


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {language: engine_of(GRAMMAR.format(language=language, **words)) for language, words in WORDS.items()}


@pytest.mark.parametrize(("language", "said", "slots"), MEANT)
def test_what_follows_is_meant(engines, language: str, said: str, slots: dict[str, object]) -> None:
    assert dict(engines[language].parse(said).slots) == slots


@pytest.mark.parametrize(("language", "said"), UNCLEAR)
def test_where_it_is_not_clear_nothing_is_done(engines, language: str, said: str) -> None:
    assert not engines[language].parse(said).actions


def test_a_whole_command_may_follow(engines) -> None:
    assert done(engines["en"].parse("turn left, no, not left, go two meters")) == "forward 2"
