"""What says how often something is to be done, in words that else say nothing: "now and then turn left"."""

from __future__ import annotations

import pytest

GRAMMAR = """
slots: {side: [left, right]}
intents:
  turn: {action: custom, sentences: ["turn {side}"]}
  once: {action: custom, sentences: ["(flash|beep now and then)"]}
"""


@pytest.fixture(scope="module")
def does(engine_of):
    engine = engine_of(GRAMMAR)
    return lambda said: [*map(dict, (action.slots for action in engine.parse(said).actions))]


@pytest.mark.parametrize(
    "said",
    ["now and then turn left", "okay, now and then turn left", "now and again turn left", "turn left now and then",
     "turn left now and again", "again and again turn left"],
)  # fmt: skip
def test_it_is_not_done_once(does, said: str) -> None:
    assert does(said) == []


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("turn left now and then right", [{"side": "left"}, {"side": "right"}]),
        ("turn left now and then turn right", [{"side": "left"}, {"side": "right"}]),
        ("now turn left and then right", [{"side": "left"}, {"side": "right"}]),
        ("beep now and then", [{}]),
    ],
)
def test_a_list_and_what_a_grammar_has_stay(does, said: str, meant: list[dict[str, str]]) -> None:
    assert does(said) == meant


@pytest.mark.parametrize(
    ("language", "sentence", "said"),
    [
        ("de", "dreh links", "dann und wann dreh links"),
        ("de", "dreh links", "dreh immer wieder links"),
        ("fr", "tourne", "de temps en temps tourne"),
        ("es", "gira", "de vez en cuando gira"),
        ("it", "gira", "ogni tanto gira"),
    ],
)
def test_in_other_languages(engine_of, language: str, sentence: str, said: str) -> None:
    engine = engine_of(f"language: {language}\nintents: {{turn: {{action: custom, sentences: ['{sentence}']}}}}\n")
    assert engine.parse(sentence).actions
    assert not engine.parse(said).actions
