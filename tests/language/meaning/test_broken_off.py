"""Corrections of what was broken off: "follow the blue, no, the red line"."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  colour: [blue, red, green]
  length: {type: distance}
  share: percent
  volume: {type: number, max: 1000}
  row: [A, B, C]
  column: {type: number, max: 12, whole: true}
  floor: ordinal
  guest: {type: text, max_words: 3}
phrases:
  well: "{row} {column}"
intents:
  follow: {action: custom, sentences: ["follow the {colour} line [for {length}]"]}
  loud: {action: custom, sentences: ["set the volume to {share}"]}
  lift: {action: custom, sentences: ["take the lift to the {floor} floor"]}
  draw: {action: custom, sentences: ["draw {volume} microliters [from {well}]"]}
  pour: {action: custom, sentences: ["pour {well} [slowly] into the {colour} cup"]}
  call: {action: custom, sentences: ["call {guest} to the {floor} floor"]}
  drill: {action: custom, sentences: ["drill {volume} holes", "drill {column} rows"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("follow the blue no red line", "follow the red line"),
        ("follow the blue, no, the red line", "follow the red line"),
        ("follow the blue I mean the red line for two meters", "follow the red line for two meters"),
        ("follow the blue line for two no three meters", "follow the blue line for three meters"),
        ("set the volume to fifty no sixty percent", "set the volume to sixty percent"),
        ("set the volume to fifty no to sixty percent", "set the volume to sixty percent"),
        ("take the lift to the second no third floor", "take the lift to the third floor"),
        ("take the lift to the second no the third floor", "take the lift to the third floor"),
        ("draw thirty no forty microliters from B six", "draw forty microliters from B six"),
        ("pour A one no B two into the red cup", "pour B two into the red cup"),
        ("draw thirty no forty microliters and follow the red line", "draw forty microliters and follow the red line"),
    ],
)
def test_the_rest_goes_on_from_both(engine: IntentEngine, said: str, meant: str) -> None:
    found = engine.parse(said)
    assert found.corrected
    assert found.actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "follow the no red line",  # nothing is taken back
        "follow the blue no nonsense line",
        "follow the blue no red",  # what goes on from neither
        "set the volume to fifty no sixty",
        "draw thirty no forty cups from B six",
        "drill thirty no four rows",  # thirty rows would be too many: holes, perhaps
        "call the doctor no the nurse to the second floor",  # any words would be a name
        "we follow the blue no the red line",
    ],
)
def test_where_it_is_not_clear_nothing_is_done(engine: IntentEngine, said: str) -> None:
    assert engine.parse(said).actions == ()


@given(st.integers(1, 99), st.integers(1, 99), st.sampled_from(["A", "B", "C"]), st.integers(1, 12))
def test_of_two_amounts_the_last_is_meant(engine: IntentEngine, said: int, meant: int, row: str, column: int) -> None:
    rest = f"microliters from {row} {column}"
    found = engine.parse(f"draw {said} no {meant} {rest}")
    assert found.actions == engine.parse(f"draw {meant} {rest}").actions != ()


WAITING = """
language: en
slots: {time: duration}
intents:
  wait: {action: custom, sentences: ["wait [for] {time} [for a signature]"]}
  open: {action: custom, sentences: ["open the drawer"]}
"""


@pytest.mark.parametrize(
    ("said", "time"),
    [
        ("wait five, no, ten minutes", 600),
        ("wait twenty seconds no forty seconds", 40),
        ("wait thirty, no, forty seconds for a signature", 40),
        ("wait for ten seconds, wait, twenty seconds", 20),
    ],
)
def test_a_verb_that_corrects_elsewhere_corrects_nothing_where_it_begins(engine_of, said: str, time: float) -> None:
    assert engine_of(WAITING).parse(said).slots == {"time": time}


def test_where_it_may_correct_it_does(engine_of) -> None:
    engine = engine_of(WAITING)
    assert engine.parse("wait, open the drawer").intent == "open"
    assert not engine.parse("wait ten seconds, no").actions
    assert not engine.parse("wait no forty seconds").actions


SETTING = """
language: en
slots:
  thing: {type: text, max_words: 4, known: [cup, box, bottle]}
  spot: [shelf, table]
  guest: {type: text, max_words: 2}
intents:
  put: {action: custom, sentences: ["put {thing} on the {spot}", "(give|hand) the {thing} to {guest}"]}
  sing: {action: custom, sentences: ["sing [for {guest}]"]}
"""
THINGS = st.sampled_from(["cup", "box", "bottle", "red cup", "big green bottle"])


@given(
    THINGS, THINGS, st.sampled_from([", no, ", " no ", ", I mean ", ", sorry, "]), st.sampled_from(["the", "my", "a"])
)
def test_of_two_things_that_a_slot_lists_the_last_is_meant(engine_of, said, meant, no, article):
    engine = engine_of(SETTING)
    found = engine.parse(f"put the {said}{no}{article} {meant} on the shelf")
    assert found.actions == engine.parse(f"put the {meant} on the shelf").actions != ()


@pytest.mark.parametrize(
    ("said", "does"),
    [
        ("give the cup, no, the box to Anna", "give the box to Anna"),
        ("hand the cup no the box to Anna and then sing", "hand the box to Anna and then sing"),
        ("put the cup no box on the shelf", ""),  # a shelf with no box on it
        ("put the cup, no, the lamp on the shelf", ""),  # any words might be a name
        ("put the lamp, no, the cup on the shelf", ""),
        ("put the cup, no, the box", ""),
        ("put the cup, no, the box is on the shelf", ""),
        ("don't put the cup, no, the box on the shelf", ""),
        ("she put the cup, no, the box on the shelf", ""),
    ],
)
def test_other_names_are_not_clear(engine_of, said, does):
    engine = engine_of(SETTING)
    assert engine.parse(said).actions == (engine.parse(does).actions if does else ())
