"""A value is understood with a "the" that no sentence has, and so it is where it is corrected, or corrects."""

from __future__ import annotations

import pytest
from meanings import german, shipped

GRAMMAR = """
language: en
slots:
  unit: {type: number, min: 1, max: 40, whole: true}
  station: [dock, shipping, receiving]
  thing: {type: text, max_words: 2}
intents:
  send: {action: custom, sentences: ["send unit {unit} to {station}"]}
  load: {action: custom, sentences: ["load {thing} at {station}"]}
"""
GERMAN = """
language: de
slots: {platz: [Dock, Lager]}
intents:
  fahr: {action: custom, sentences: ["fahr zu {platz}"]}
"""


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("send unit 3 to the dock, no, to receiving", {"unit": 3, "station": "receiving"}),
        ("send unit 3 to the dock, no, receiving", {"unit": 3, "station": "receiving"}),
        ("send unit 3 to shipping no to the dock", {"unit": 3, "station": "dock"}),
        ("send unit 3 to shipping, no, the dock", {"unit": 3, "station": "dock"}),
        ("send unit 3, no, 4 to the dock", {"unit": 4, "station": "dock"}),
        ("send unit 3 to the dock, no, load the cup at the dock", {"thing": "cup", "station": "dock"}),
        ("send unit 3 to the dock, no, load the cup at dock", {"thing": "cup", "station": "dock"}),
    ],
)
def test_the_article_of_a_value_matters_to_no_correction(engine_of, said: str, slots: dict[str, object]) -> None:
    assert engine_of(GRAMMAR).parse(said).slots == slots


@pytest.mark.parametrize(
    "said",
    [
        "send unit 3 to the dock, no",
        "send unit 3 to the dock, no, to the moon",
        # Of free words an article tells what is meant.
        "load the cup at the dock, no plate",
    ],
)
def test_nothing_is_guessed_without_the_article(engine_of, said: str) -> None:
    assert not engine_of(GRAMMAR).parse(said).actions


@pytest.mark.parametrize("broken_off", ["no, the", "no the", "I mean the", "sorry, the", "no, the uh", "no, the well"])
@pytest.mark.parametrize("said", ["go to the kitchen", "turn left", "go forward two meters", "pick up the cup"])
def test_a_correction_that_breaks_off_behind_its_article_does_not_do_what_it_takes_back(said, broken_off) -> None:
    assert shipped().parse(f"{said}, {broken_off}").actions == ()


@pytest.mark.parametrize("said", ["fahr in die Küche, nein, die", "dreh dich nach links, nein, das"])
def test_a_german_correction_that_breaks_off(said) -> None:
    assert german().parse(said).actions == ()


def test_german_articles(engine_of) -> None:
    assert engine_of(GERMAN).parse("fahr zu dem Dock, nein, zu dem Lager").slots == {"platz": "Lager"}
