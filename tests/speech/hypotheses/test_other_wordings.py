"""Sentences of a grammar in the small words that were heard."""

from __future__ import annotations

import pytest

from intent_engine.speech.hypotheses.other_wordings import small_words
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

TRUCK = """
language: en
slots:
  rock: [waste rock, iron ore]
  site: [north dump, crusher]
  tilt: {type: angle, unit: deg}
  height: distance
  what: object
intents:
  haul: {action: custom, sentences: ["haul [the] {rock} to the {site}"]}
  bed: {action: custom, sentences: ["raise the bed to {tilt}"]}
  mast: {action: custom, sentences: ["lift the mast to {height}"]}
  swing: {action: custom, sentences: ["swing (left|right) {tilt}"]}
  take: {action: custom, sentences: ["take the {what}"]}
"""


@pytest.fixture(scope="module")
def truck(engine_of) -> SpokenGrammar:
    return SpokenGrammar(engine_of(TRUCK))


@pytest.mark.parametrize(
    ("heard", "said"),
    [
        ("hall that wasterock over to the north dump", "haul that waste rock over to the north dump"),
        ("raise your men up to fifty five degrees", "raise your bed up to fifty five degrees"),
        ("lived the mast to a height of eight meters", "lift the mast to a height of eight meters"),
        ("swim to the left by ten degrees", "swing to the left by ten degrees"),
    ],
)
def test_a_misheard_command_keeps_the_small_words_heard(truck: SpokenGrammar, heard: str, said: str) -> None:
    assert tuple(said.split()) in truck.in_words_heard(heard.split())


def test_what_it_means_is_what_the_grammar_has(truck: SpokenGrammar) -> None:
    said = ("raise", "your", "bed", "up", "to", "fifty", "five", "degrees")
    own = truck.as_it_has_it(said)
    assert own == ("raise", "the", "bed", "to", "fifty", "five", "degrees")
    assert truck.parse(" ".join(own)).actions == truck.parse(" ".join(said)).actions
    assert truck.as_it_has_it(own) == own


@pytest.mark.parametrize(
    ("sentence", "heard", "put"),
    [
        # Another number, in the words of the one that was taken for it.
        ("raise the bed to ten degrees", "raise your bed up to fifty degrees", "raise your bed up to ten degrees"),
        # Words with which it would be something else, or nothing, are not put in.
        ("swing left ten degrees", "swing right by ten degrees", "swing left by ten degrees"),
        ("raise the bed to ten degrees", "raise the bed or lift it to ten degrees", "raise the bed to ten degrees"),
        # What is heard in the place of a number says nothing of it.
        ("lift the mast to two meters", "shift a mask to meters", "lift a mast to two meters"),
    ],
)  # fmt: skip
def test_one_sentence_in_the_words_of_another(truck: SpokenGrammar, sentence: str, heard: str, put: str) -> None:
    assert truck.put(sentence.split(), heard.split()) == tuple(put.split())


def test_a_sentence_without_such_words_is_heard_as_it_is(truck: SpokenGrammar) -> None:
    assert truck.in_words_heard(["raise", "the", "bed", "to", "ten", "degrees"]) == []


def test_ways_are_no_small_words(truck: SpokenGrammar) -> None:
    small = small_words(truck.wording(), "en")
    assert {"that", "by", "over", "height"} <= small
    assert {"left", "right", "forward", "north"}.isdisjoint(small)
