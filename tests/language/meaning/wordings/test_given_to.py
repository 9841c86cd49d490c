"""Whom something is given to, before what is given: "give hive 8 two liters" of "give two liters to hive 8"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  hive: {type: number, whole: true, min: 1, max: 40}
  n: {type: number, max: 5}
  drink: [tea, coffee]
  room: [kitchen, lab]
  who: [Anna, Ben]
  item: [book, cup]
  thing: object
  far: distance
intents:
  feed: {action: custom, sentences: ["give {n} liters [of syrup] to hive {hive}"]}
  serve: {action: custom, sentences: ["bring {n} {drink} to table {hive}", "bring {n} {drink} to the {room}"]}
  hand: {action: custom, sentences: ["(hand|give) the {item} to {who}", "bring a {drink} to {who}"]}
  fetch: {action: custom, sentences: ["get {thing}", "make {thing} for {who}", "show {thing} to {who}"]}
  roll: {action: custom, sentences: ["roll {far} to door {hive}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("could you give hive 8 half a liter of syrup?", "give 0.5 liters of syrup to hive 8"),
        ("give hive 8 two liters", "give 2 liters to hive 8"),
        ("bring table 5 two coffees, please", "bring two coffees to table 5"),
        ("bring the lab two teas", "bring two teas to the lab"),
        ("bring Anna a tea", "bring a tea to Anna"),
        ("hand Ben the cup", "hand the cup to Ben"),
    ],
)
def test_it_is_given_to_them(engine: IntentEngine, said: str, command: str) -> None:
    assert_same(engine, said, command)


@pytest.mark.parametrize(
    "said",
    [
        # Where whom it is given to ends is not clear.
        "give hive twenty four liters", "bring table twenty five teas", "bring table 20 five teas",
        "give hive 8 five hundred liters", "give hive 20 3 liters",
        # Nobody that the grammar knows, or nothing.
        "give Tom the book", "give Anna a break", "bring the lab two", "give the book the cup",
        "give Anna's book the cup",
        # One of two, another time, what somebody tells or asks.
        "give Anna or Ben the book", "give Anna the book tomorrow", "give Anna the book when I leave",
        "don't give Anna the book", "she gave Anna the book", "did you give Anna the book", "give, Anna, the book",
        # No verb of giving, and free words.
        "roll door 3 two meters", "show Anna the box",
    ],
)  # fmt: skip
def test_what_may_mean_something_else_does_nothing(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions
