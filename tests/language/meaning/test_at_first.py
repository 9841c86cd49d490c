"""A "first" behind the first of several commands: "close the door first, then start"."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

MILL = """
language: en
slots: {axis: [x, y], what: {type: text, max_words: 2}}
intents:
  open: {action: custom, sentences: ["open the door", "open the (first|second) drawer"]}
  spindle: {action: custom, sentences: ["start the spindle"]}
  load: {action: custom, sentences: ["load {what}"]}
  home:
    action: custom
    regex: "home (?P<axis>x|y)"
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(MILL)


@pytest.mark.parametrize(
    "said",
    [
        "open the door first, then start the spindle",
        "open the door first and then start the spindle",
        "please open the door first, and then, uh, start the spindle",
        "open the door first of all and start the spindle",
        "open the door first, start the spindle",
    ],
)
def test_it_says_nothing_but_their_order(engine: IntentEngine, said: str) -> None:
    assert engine.parse(said).actions == engine.parse("open the door and then start the spindle").actions != ()


def test_a_command_of_a_pattern_may_be_the_first(engine: IntentEngine) -> None:
    assert [action.name for action in engine.parse("home y first, then home x").actions] == ["home", "home"]


@pytest.mark.parametrize(
    "said",
    [
        "open the door first",
        "open the door, then start the spindle first",
        "open the door, but start the spindle first",
        "don't open the door first, then start the spindle",
        "if you open the door first, then start the spindle",
        "I open the door first, then start the spindle",
        "open the first, then start the spindle",
        "should I open the door first and then start the spindle?",
        "open the door first, no, start the spindle first",
    ],
)
def test_elsewhere_it_does(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


@pytest.mark.parametrize(
    ("language", "sentences", "said"),
    [
        ("de", ["öffne die tür", "starte die spindel"], "öffne die Tür zuerst, dann starte die Spindel"),
        ("fr", ["ouvre la porte", "démarre la broche"], "ouvre la porte d'abord, puis démarre la broche"),
        ("es", ["abre la puerta", "arranca el husillo"], "abre la puerta primero y luego arranca el husillo"),
        ("it", ["apri la porta", "avvia il mandrino"], "apri la porta prima, poi avvia il mandrino"),
    ],
)
def test_so_it_is_in_other_languages(engine_of, language: str, sentences: list[str], said: str) -> None:
    intents = "".join(
        f"  do{place}: {{action: custom, sentences: [{sentence!r}]}}\n" for place, sentence in enumerate(sentences)
    )
    engine = engine_of(f"language: {language}\nintents:\n{intents}")
    assert [action.name for action in engine.parse(said).actions] == ["do0", "do1"]
