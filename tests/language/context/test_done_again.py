"""What was done last is done once more, in a grammar that says nothing of it; and "not that, this" corrects it."""

from __future__ import annotations

import pytest

from intent_engine import IntentEngine

GRAMMAR = """
language: {language}
fillers: [please, okay, thanks, uh]
slots:
  {{thing: [lamp, heater, fan]}}
intents:
  light: {{action: custom, excludes: [dark], sentences: ["turn on the {{thing}}", "licht {{thing}}"]}}
  quench: {{action: custom, sentences: ["turn off the {{thing}}"]}}
"""
OWN = GRAMMAR + '  again: {{action: {{type: custom, name: again}}, sentences: ["encore"]}}\n'


@pytest.fixture(scope="module")
def english(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR.format(language="en"))


@pytest.mark.parametrize(
    "text", ["again", "do it again", "Same again, please!", "once more", "okay, again", "and again", "again, thanks"]
)
def test_the_last_command_is_done_once_more(english: IntentEngine, text: str) -> None:
    first = english.parse("turn off the fan and turn on the lamp")
    found = english.parse(text, last=first)
    assert found.actions == first.actions[-1:]
    assert english.parse(text, last=found).actions == found.actions
    assert not english.parse(text).actions
    assert not english.parse(text, last=first, state=["dark"]).actions


@pytest.mark.parametrize(
    "text",
    ["thanks again", "uh, thanks again", "say that again", "not again", "don't do it again", "again?", "again the fan",
     "oh, that again", "never again"],
)  # fmt: skip
def test_talk_with_an_again_does_nothing(english: IntentEngine, text: str) -> None:
    assert not english.parse(text, last=english.parse("turn on the lamp")).actions


@pytest.mark.parametrize(("language", "text"), [("de", "nochmal"), ("fr", "encore une fois"), ("es", "otra vez"),
                                                ("it", "di nuovo")])  # fmt: skip
def test_other_languages_have_words_for_it(engine_of, language: str, text: str) -> None:
    engine = engine_of(GRAMMAR.format(language=language))
    first = engine.parse("licht lamp")
    assert engine.parse(text, last=first).actions == first.actions != ()


def test_a_grammar_with_words_of_its_own_has_no_others(engine_of) -> None:
    engine = engine_of(OWN.format(language="en"))
    first = engine.parse("turn on the lamp")
    assert engine.parse("encore", last=first).actions == first.actions
    assert not engine.parse("again", last=first).actions


def test_what_is_spoken_needs_a_sentence_for_it(english: IntentEngine) -> None:
    assert not english.parse("again", last=english.parse("turn on the lamp"), spoken=True).actions
