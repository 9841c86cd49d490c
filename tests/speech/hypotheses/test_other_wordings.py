"""Sentences of a grammar in the small words that were heard."""

from __future__ import annotations

import pytest

from intent_engine.speech.hypotheses.other_wordings import OtherWordings, in_words_heard, small_words
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
def truck(engine_of) -> OtherWordings:
    return OtherWordings(SpokenGrammar(engine_of(TRUCK)))


@pytest.mark.parametrize(
    ("heard", "said"),
    [
        ("hall that wasterock over to the north dump", "haul that waste rock over to the north dump"),
        ("raise your men up to fifty five degrees", "raise your bed up to fifty five degrees"),
        ("lived the mast to a height of eight meters", "lift the mast to a height of eight meters"),
        ("swim to the left by ten degrees", "swing to the left by ten degrees"),
    ],
)
def test_a_misheard_command_keeps_the_small_words_heard(truck: OtherWordings, heard: str, said: str) -> None:
    assert tuple(said.split()) in truck.heard(heard.split())


def test_of_several_small_words_those_are_put_that_change_nothing(engine_of) -> None:
    sentence, heard = "haul waste rock to the crusher", "haul some waste rock never to that crusher"
    small = frozenset({"some", "never", "to", "the", "that"})
    said = in_words_heard(sentence.split(), heard.split(), small, engine_of(TRUCK).parse)
    assert " ".join(said) == "haul some waste rock to that crusher"


@pytest.mark.parametrize(
    ("heard", "found"), [("scoot an iron or", []), ("scoot that iron or", [("scoop", "that", "iron", "ore")])]
)
def test_small_words_that_a_sentence_has_are_looked_for_with_all_that_was_heard(engine_of, heard, found) -> None:
    """Else each of its neighbours would be asked about in those words once more, a millisecond for each."""
    scoops = TRUCK + '  scoop: {action: custom, sentences: ["scoop [(a|an)] {rock}"]}\n'
    assert OtherWordings(SpokenGrammar(engine_of(scoops))).heard(heard.split()) == found


def test_what_it_means_is_what_the_grammar_has(truck: OtherWordings) -> None:
    said = ("raise", "your", "bed", "up", "to", "fifty", "five", "degrees")
    own = truck.own(said)
    assert own == ("raise", "the", "bed", "to", "fifty", "five", "degrees")
    assert truck.own(own) == own


@pytest.mark.parametrize(
    ("sentence", "own", "words", "put"),
    [
        # Another number, in the words in which the first was said.
        ("raise the bed to fifteen degrees", "raise the bed to fifty degrees", "raise your bed up to fifty degrees",
         "raise your bed up to fifteen degrees"),
        ("haul iron ore to the crusher", "haul waste rock to the crusher",
         "I want that waste rock hauled to the crusher", "I want that iron ore hauled to the crusher"),
        # Words with which it would be nothing are not put in.
        ("raise the bed to ten degrees", "swing left ten degrees", "raise the bed or lift it to ten degrees",
         "raise the bed to ten degrees"),
    ],
)  # fmt: skip
def test_one_sentence_in_the_words_of_another(
    truck: OtherWordings, sentence: str, own: str, words: str, put: str
) -> None:
    assert truck.beside(*(tuple(one.lower().split()) for one in (sentence, own, words))) == tuple(put.lower().split())


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("i want that waste rock hauled to the crusher", True),
        ("you can raise the bed to ten degrees now", True),
        ("raise the bed to ten degrees", False),  # in its own words
        ("i want that word taken", False),  # of no listed thing
        ("i want that rock", False),
        ("", False),
    ],
)
def test_what_was_heard_may_be_a_command_in_other_words(truck: OtherWordings, words: str, said: bool) -> None:
    assert (tuple(words.split()) in truck.heard(words.split())) is said


def test_ways_are_no_small_words(engine_of) -> None:
    small = small_words(SpokenGrammar(engine_of(TRUCK)).wording(), "en")
    assert {"that", "by", "over", "height"} <= small
    assert {"left", "right", "forward", "north"}.isdisjoint(small)
