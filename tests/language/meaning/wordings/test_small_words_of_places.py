"""Little words of a place or an amount that a grammar has otherwise: "take me home", "lane 3", "three times, no,
twice"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine import IntentEngine

HOUSE = """
language: en
slots:
  place: [home, upstairs, downstairs, kitchen]
  thing: [box, towel, glass of water]
  lane: {type: ordinal, max: 8}
  well: {type: number, min: 1, max: 9, whole: true}
  count: {type: number, min: 1, max: 9, whole: true}
  far: {type: distance, max: 5 m}
  side: [left, right]
intents:
  go: {action: custom, sentences: ["(take me|go) to [the] {place}", "bring the {thing} to [the] {place}"]}
  lane: {action: custom, sentences: ["send the {thing} to the {lane} lane", "open lane number {#}"]}
  well: {action: custom, sentences: ["pour {count} liters into well {well}", "take the {thing} from well {well}"]}
  knock: {action: custom, sentences: ["knock [{count} times]"]}
  drop: {action: custom, sentences: ["drop the {thing}", "ring"]}
  roll: {action: custom, sentences: ["roll {side} [{far}]"]}
  gear: {action: custom, sentences: ["{lane} gear"]}
  lights: {action: custom, sentences: ["lights (on|off)", "the {thing} heater (on|off)"]}
  fetch: {action: custom, sentences: ["fetch [{count}] {thing}"]}
"""


@pytest.fixture(scope="module")
def house(engine_of) -> IntentEngine:
    return engine_of(HOUSE)


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("take me home", "take me to home"),
        ("take me back home please", "take me to home"),
        ("bring the box upstairs and go downstairs", "bring the box to upstairs, then go to downstairs"),
        ("send the box to lane 3", "send the box to the third lane"),
        ("send the box to lane two", "send the box to the second lane"),
        ("pour two liters in well 7", "pour two liters into well 7"),  # "well" opens nothing where it is a noun
        ("take the towel out of well 7", "take the towel from well 7"),
        ("knock three times, no, twice", "knock two times"),
        ("knock twice, no, once", "knock one time"),
        ("knock once, no, three times", "knock three times"),
        ("go to the kitchen and drop the box there", "go to the kitchen, then drop the box"),
        ("go to the kitchen and ring over there", "go to the kitchen, then ring"),
        ("go to the kitchen and wait there", "go to the kitchen"),  # every command ends at rest
        ("roll two meters left", "roll left two meters"),  # though a command begins with a number
        ("roll a bit to the left, two meters", "roll left two meters"),
        ("roll left a little, say two meters", "roll left two meters"),
        ("turn the lights on", "lights on"),
        ("switch off the lights and knock", "lights off, then knock"),
        ("fetch another towel", "fetch a towel"),
        ("fetch a box and a towel", "fetch a box, then fetch a towel"),
    ],
)
def test_it_is_understood(house: IntentEngine, said: str, plain: str) -> None:
    assert_same(house, said, plain)


@pytest.mark.parametrize(
    "said",
    [
        "I'm home", "he took me home", "take home", "don't take me home", "home", "is he upstairs",
        "go home or upstairs",
        "send the box to lane 30", "send the box to lane 3 or 4", "send the box to lane two point five",
        "knock no twice", "knock three times, no, never", "don't knock three times, no, twice",
        "take the box from well 7 and drop the towel over there now or later", "drop the box there",
        "take the box from the kitchen and ring there", "don't go to the kitchen and ring there",
        "go to the kitchen and hold on", "go to the kitchen and wait there for Anna", "wait there",
        "roll left a bit", "a bit, two meters", "roll, a bit, no",
        "turn the lights", "the lights turn on", "don't turn the lights on", "is turn the lights on",
        "somebody turned the lights on", "turn on the radio", "fetch another kitchen",
    ],
)  # fmt: skip
def test_nothing_is_done(house: IntentEngine, said: str) -> None:
    assert not house.parse(said).actions


def test_whom_something_is_brought_is_no_title(engine_of) -> None:
    grammar = """
language: en
slots: {title: {type: text, max_words: 5}, author: {type: text, max_words: 3}}
intents:
  fetch: {action: custom, sentences: ["(get|fetch) {title} by {author}"]}
"""
    assert_same(engine_of(grammar), "get me dune by frank herbert", "get dune by frank herbert")


BAR = """
language: de
slots:
  zeit: {type: duration, max: 10 min}
  teil: [Düse, Schale]
intents:
  mahlen: {action: custom, sentences: ["mahl {zeit} lang"]}
  spülen: {action: custom, sentences: ["spül die {teil} [{zeit} lang]"]}
  hupen: {action: custom, sentences: ["hup"]}
"""


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("mahl zehn Sekunden", "mahl zehn Sekunden lang"),
        ("spül die Düse eine Minute", "spül die Düse eine Minute lang"),
        ("spül eine Minute die Düse", "spül die Düse eine Minute lang"),
        ("bitte hupen", "hup"),
    ],
)
def test_german(engine_of, said: str, plain: str) -> None:
    assert_same(engine_of(BAR), said, plain)


@pytest.mark.parametrize("said", ["mahl zehn", "hupen", "bitte nicht hupen", "mahl nicht zehn Sekunden", "eine Minute"])
def test_german_that_does_nothing(engine_of, said: str) -> None:
    assert not engine_of(BAR).parse(said).actions
