"""What holds a robot that moves, in a grammar that knows no such command: "wait", "don't move"."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.needs import MOVING


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    sentences = {
        "en": "[clean the lab, stay]",
        "own": '["clean the lab", "wait for the mop"]',
        "de": "[putze]",
        "fr": "[nettoie]",
    }
    sentences |= {"es": "[limpia]", "it": "[pulisci]"}
    grammar = "language: {}\nintents:\n  clean: {{action: custom, sentences: {}}}\n"
    return {name: engine_of(grammar.format(name.replace("own", "en"), said)) for name, said in sentences.items()}


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "wait"),
        ("en", "Wait, please!"),
        ("en", "hold on a second"),
        ("en", "no, wait"),
        ("en", "don't move"),
        ("en", "uh, just a moment"),
        ("de", "Warte mal"),
        ("de", "beweg dich nicht"),
        ("fr", "attendez"),
        ("es", "espera un momento"),
        ("it", "aspetta, aspetta"),
    ],
)
def test_a_robot_that_moves_is_held_and_one_at_rest_does_nothing(engines, said, language):
    engine = engines[language]
    assert engine.parse(said, state={MOVING}).stops
    at_rest = engine.parse(said)
    assert not at_rest.actions
    assert at_rest.refuses, "a recogniser takes it as it was heard, and for no command that sounds like it"


@pytest.mark.parametrize("said", ["wait for him", "she cannot wait", "wait until six", "one moment later it rang"])
def test_more_than_that_is_other_talk(engines, said):
    assert not engines["en"].parse(said, state={MOVING}).actions


@pytest.mark.parametrize(("engine", "said"), [("en", "stay"), ("own", "wait for the mop"), ("own", "clean the lab")])
def test_sentences_of_the_grammar_are_its_own(engines, engine, said):
    found = engines[engine].parse(said, state={MOVING})
    assert found.actions
    assert not found.stops


def test_the_beginning_of_a_command_holds_a_robot_that_moves_and_may_go_on_at_rest(engines):
    assert engines["own"].parse("wait", state={MOVING}).stops
    assert not engines["own"].parse("wait").refuses
