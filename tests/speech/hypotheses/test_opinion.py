"""What a model heard, beside a sentence of the grammar."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from intent_engine.speech.hypotheses.opinion import Opinion
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.hypotheses.weighing import beside_heard
from intent_engine.speech.recognizer import Transcript

BAR = """
language: en
slots:
  amount: {type: number, min: 5, max: 90, whole: true}
  time: {type: duration, max: 10 min}
intents:
  pour: {action: custom, sentences: ["pour {amount} milliliters of rum"]}
  shake: {action: custom, sentences: ["shake [for {time}]"]}
"""


@pytest.fixture(scope="module")
def grammar(engine_of) -> SpokenGrammar:
    return SpokenGrammar(engine_of(BAR))


def heard(grammar: SpokenGrammar, text: str) -> Opinion:
    model = SimpleNamespace(grammar=grammar)
    return Opinion(model, np.zeros(16, np.float32), None, Transcript(text, -0.5, text, language="en"))


@pytest.mark.parametrize(
    ("text", "sentence", "read"),
    [
        ("460 milliliters of rum", "pour sixty milliliters of rum", "four sixty milliliters of rum"),
        ("Shake 415 seconds.", "shake for fifteen seconds", "shake four fifteen seconds"),
        ("Shake 415 seconds.", "shake four hundred fifteen seconds", "shake four hundred fifteen seconds"),
        ("Shake 405 seconds.", "shake for five seconds", "shake four hundred five seconds"),
        ("Shake 1415 seconds.", "shake for fifteen seconds", "shake one thousand four hundred fifteen seconds"),
    ],
)
def test_a_number_in_figures_is_read_as_a_sentence_has_it(
    grammar: SpokenGrammar, text: str, sentence: str, read: str
) -> None:
    assert " ".join(heard(grammar, text).heard_beside(sentence.split())) == read


def test_a_verb_that_was_written_as_a_figure_leaves_no_hundred_out(grammar: SpokenGrammar) -> None:
    both = [heard(grammar, text) for text in ("460 milliliters of rum", "460 milliliters of rum.")]
    said = beside_heard(grammar, ("pour", "sixty", "milliliters", "of", "rum"), both)
    assert (said.left_out(), said.passed_over(), said.heard_otherwise(0.8)) == ((), (), ())


def test_a_hundred_that_was_heard_is_left_out_by_nobody(grammar: SpokenGrammar) -> None:
    both = [heard(grammar, "pour four hundred sixty milliliters of rum")] * 2
    said = beside_heard(grammar, ("pour", "sixty", "milliliters", "of", "rum"), both)
    assert said.passed_over() == ("four hundred",)
