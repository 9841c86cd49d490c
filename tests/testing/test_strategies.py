"""Sentences for Hypothesis: what is asked for is what comes, and a failure shrinks to the shortest."""

from __future__ import annotations

import re
import sys

import pytest
from hypothesis import find, given, settings
from hypothesis import strategies as st
from meanings import shipped

import intent_engine.testing
from intent_engine.errors import ConfigError
from intent_engine.interpretation import Status
from intent_engine.testing import Noise, assert_means, moves, sentences

GRAMMAR = """
language: en
fillers: [please, "could you"]
slots:
  colour: [red, light blue, green]
  count: {type: number, min: 1, max: 12}
  thing: {type: text, max_words: 2}
intents:
  paint:
    action: {type: custom, name: paint}
    sentences: ["paint it {colour}", "(make|colour) {count} {colour} ones", "paint the {thing} {colour}"]
  halt: {action: stop, sentences: [halt]}
  answer:
    action: {type: custom, name: answer}
    requires: [asked]
    sentences: ["(yes|no thanks|not now)"]
  agree: {action: custom, requires: [asked], regex: "(of course|sure thing)"}
  matched:
    action: {type: custom, name: matched}
    regex: "(?:or){9}der (?P<count>[0-9]+)"
"""
FIND = settings(max_examples=1000, derandomize=True, database=None)
FEW = settings(max_examples=60, deadline=None, derandomize=True)


@pytest.fixture(scope="module")
def engine(engine_of):
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("wanted", "shortest"),
    [
        (lambda said: True, "halt"),
        (lambda said: said.expected.intent == "paint", "paint it red"),
        (lambda said: "thing" in said.expected.slots, "paint the box red"),
        (lambda said: said.expected.slots.get("colour") == "light blue", "paint it light blue"),
        (lambda said: said.expected.slots.get("count", 0) > 1, "make 2 red ones"),
    ],
)
def test_a_failure_shrinks_to_the_shortest_sentence(engine, wanted, shortest):
    assert find(sentences(engine), wanted, settings=FIND).text == shortest


@pytest.mark.parametrize(
    ("wanted", "words"),
    [
        (lambda said: said.expected.intent == "navigate", 2),
        (lambda said: "angle" in said.expected.slots, 2),
        (lambda said: said.expected.intent == "move" and said.expected.slots.get("direction") == "backward", 1),
        (lambda said: said.expected.intent == "pick" and "source" in said.expected.slots, 5),  # of the fewest choices
    ],
)
def test_it_does_in_a_large_grammar(wanted, words):
    assert len(find(sentences(shipped()), wanted, settings=FIND).text.split()) <= words


@pytest.mark.parametrize(
    ("noise", "text"),
    [
        (Noise.FILLERS, "halt"),
        (Noise.SPELLING, "halt"),
        (Noise.NEGATION, "don't paint it red"),
        (Noise.CORRECTION, "paint it red no red"),
    ],
)
def test_noise_shrinks_to_as_little_as_it_can(engine, noise, text):
    assert find(sentences(engine, noise=noise), lambda _: True, settings=FIND).text == text


@FEW
@given(data=st.data())
def test_only_what_was_asked_for(engine, data):
    said = data.draw(sentences(engine, "paint", texts={"thing": ["old boat"]}))
    assert said.expected.intent == "paint"
    assert said.expected.slots.get("thing", "old boat") == "old boat"
    assert said.expected.actions[0].slots == said.expected.slots
    assert_means(engine.parse(said.text), said.expected)


@FEW
@given(data=st.data())
def test_intents_that_need_a_state_are_said_in_it(engine, data):
    assert data.draw(sentences(engine)).expected.intent in ("paint", "halt")
    said = data.draw(sentences(engine, "answer", state=["asked"]))
    assert said.text in ("yes", "no thanks", "not now")


@FEW
@given(data=st.data())
def test_a_negated_sentence_is_expected_to_move_nothing(engine, data):
    said = data.draw(sentences(engine, noise=["negation", "fillers", "spelling"]))
    assert said.expected.status is Status.REJECTED
    assert not moves(said.expected)
    assert_means(engine.parse(said.text), said.expected)


@FEW
@given(data=st.data())
def test_a_pattern_is_corrected_to_what_it_takes(engine_of, data):
    engine = engine_of(
        "language: en\nslots:\n  room: [kitchen, hall, living room]\n  n: {type: number, min: 1, max: 500}\n"
        "intents:\n  clean: {action: custom, regex: 'clean the (?P<room>kitchen|hall)'}\n"
        "  open: {action: custom, regex: 'open gate (?P<n>[0-9])'}\n"
    )
    said = data.draw(sentences(engine, noise="correction"))
    assert_means(engine.parse(said.text), said.expected)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"intent": "pant"}, "there is no intent 'pant'; did you mean 'paint'?"),
        ({"intent": "matched"}, "has patterns only"),
        ({"intent": "answer"}, "it needs: asked"),
        ({"intent": "agree"}, "it needs: asked"),
        ({"intent": "halt", "noise": "negation"}, "neither negated nor corrected"),
    ],
)
def test_what_cannot_be_said_is_told_at_once(engine, options, message):
    with pytest.raises(ConfigError, match=re.escape(message)):
        sentences(engine, **options)


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        ({"intent": ["paint", "halt"]}, TypeError, "the name of one intent"),
        ({"noise": 3}, TypeError, "noise is a name, or several in a list (fillers"),
        ({"state": {"asked": True}}, TypeError, "states are names in a list"),
        ({"state": ["askd"]}, ConfigError, "no intent of the grammar asks for a state 'askd'"),
        ({"texts": ["boat"]}, TypeError, "texts is a dictionary"),
        ({"texts": {"thing": [3]}}, TypeError, "for 'thing' is a list of texts"),
        ({"texts": {"thin": ["boat"]}}, ConfigError, "no text slot 'thin'; did you mean 'thing'?"),
        ({"texts": {"colour": ["mauve"]}}, ConfigError, "no text slot 'colour'; there is thing"),
        ({"texts": {"thing": ["very old boat"]}}, ConfigError, "has more words than the 2 that slot 'thing' takes"),
        ({"texts": {"thing": []}}, ConfigError, "nothing is said for slot 'thing'"),
        ({"texts": {"thing": ["?"]}}, ConfigError, "'?', for slot 'thing', has no word"),
    ],
)
def test_what_is_asked_for_wrongly_is_told_at_once(engine, options, error, message):
    with pytest.raises(error, match=re.escape(message)):
        sentences(engine, **options)


def test_where_nothing_can_be_corrected_it_is_told_at_once(engine_of):
    alone = engine_of("intents: {bow: {action: custom, sentences: [bow, 'bow now']}}")
    with pytest.raises(ConfigError, match="no sentence of the grammar can be corrected"):
        sentences(alone, noise="correction")


@pytest.mark.parametrize(
    "pattern",
    [
        "regex: 'go (?P<side>left|right)'",
        "lark: |\n      start: 'go ' side\n      side: 'left' | 'right'".replace("'", '"'),
    ],
)
def test_a_pattern_is_not_misheard_for_it_takes_its_own_words_alone(engine_of, pattern):
    engine = engine_of(f"slots: {{side: [left, right]}}\nintents:\n  go:\n    action: custom\n    {pattern}\n")

    @settings(FEW, max_examples=300)
    @given(sentences(engine, noise="spelling"))
    def law(case):
        assert_means(engine.parse(case.text), case.expected)

    law()


def test_a_state_that_is_given_as_text_is_that_state(engine):
    assert find(sentences(engine, "answer", state="asked"), lambda _: True, settings=FIND).text == "yes"


@pytest.mark.parametrize(
    ("said", "value"),
    [("the old boat", "old boat"), ("Boat 3", "boat 3"), ("Boat", "boat")],
)
def test_what_is_said_for_a_text_slot_has_the_value_that_the_engine_gives_it(engine, said, value):
    strategy = sentences(engine, texts={"thing": said})
    found = find(strategy, lambda case: "thing" in case.expected.slots, settings=FIND)
    assert said in found.text
    assert found.expected.slots["thing"] == value
    assert_means(engine.parse(found.text), found.expected)


@pytest.mark.parametrize("noise", ["loud", ["negation", "correction"]])
def test_noise_that_means_nothing(engine, noise):
    with pytest.raises(ValueError, match=r"loud|negated or corrected"):
        sentences(engine, noise=noise)


def test_without_hypothesis_it_says_what_to_install(monkeypatch):
    for name in [name for name in sys.modules if name.split(".")[0] == "hypothesis" or name.endswith("strategies")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "hypothesis", None)
    monkeypatch.delitem(vars(intent_engine.testing), "sentences")
    with pytest.raises(ModuleNotFoundError, match=re.escape("pip install 'intent-engine[testing]'")):
        intent_engine.testing.sentences  # noqa: B018
    assert intent_engine.testing.RecordingRobot


WITH = """
language: en
slots: {drink: [latte, mocha], milk: [cream, soy milk, skim milk]}
intents:
  order: {action: {type: custom, name: order}, sentences: ["{drink} with [the] {milk}"]}
"""


def test_no_correction_may_as_well_say_that_there_shall_be_none(engine_of):
    """ "Latte with soy milk no cream": cream in its place, or none? Nobody knows, and so it is no sample."""
    coffee = engine_of(WITH)

    @settings(max_examples=400, deadline=None, derandomize=True, database=None)
    @given(sentences(coffee, noise="correction"))
    def corrected(sentence):
        assert_means(coffee.parse(sentence.text), sentence.expected)

    corrected()
