"""People, and where one is, are never taken, though things are given to them or put there."""

from __future__ import annotations

import pytest
from meanings import does, done, german

from intent_engine import IntentEngine

ARM = """
language: en
slots:
  listed: {type: text, known: [cup, house]}
  scene: {type: object, known: [lamp]}
intents:
  lift: {action: {type: pick, object: "{listed}"}, sentences: ["lift {listed}"]}
  film: {action: custom, sentences: ["film {scene}"]}
"""


@pytest.fixture(scope="module")
def arm(engine_of) -> IntentEngine:
    return engine_of(ARM)


@pytest.mark.parametrize(
    "said",
    [
        "put the man in prison", "leave the house by the stairs", "leave the old town on the bus",
        "bring the whole family to the kitchen and the women to the hall", "pick up the customers from the station",
        "take the nurse to the office", "drop the tall lady in the garden", "take your shoulders off the table",
        "lift the house on the hill",
    ],
)  # fmt: skip
def test_they_stay_where_they_are(said: str) -> None:
    assert does(said) in ("rejected", "incomplete")


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("give the cup to the nurse", "bring"),
        ("bring the mop to the house", "bring"),
        ("put the towel on my shoulder", "place towel shoulder"),
        ("drop the box in the garden", "place box garden"),
        ("take the bird house", "pick bird house"),
        ("pick up the gingerbread man", "pick gingerbread man"),
        ("pick up the toy house", "pick toy house"),
        ("put the house plant on the shelf", "place house plant shelf"),
    ],
)
def test_things_are_put_there_and_called_after_them(said: str, meant: str) -> None:
    assert does(said) == meant


@pytest.mark.parametrize("said", ["nimm die Leute mit", "stell den Mann an die Wand", "steck das Haus in Brand"])
def test_in_german(said: str) -> None:
    assert not german().parse(said).actions


@pytest.mark.parametrize("said", ["bring das Buch zu den Leuten", "stell die Kiste vors Haus", "nimm das Puppenhaus"])
def test_in_german_things_are_brought_there(said: str) -> None:
    assert done(german().parse(said)) != "rejected"


def test_what_a_slot_lists_is_taken(arm: IntentEngine) -> None:
    assert arm.parse("lift the house").actions
    assert not arm.parse("lift the garden").actions


def test_what_is_only_looked_at_may_be_anybody(arm: IntentEngine) -> None:
    assert arm.parse("film the house").actions
    assert arm.parse("film the crowd").actions
