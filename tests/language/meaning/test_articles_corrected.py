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


TOOLS = """
language: de
slots: {gerät: [Hammer, Zange], ort: [Lager, Werkstatt], lage: [Tisch, Regal, Bank]}
intents:
  hol: {action: custom, sentences: ["hol (den|die) {gerät} aus (dem|der) {ort}"]}
  leg: {action: custom, sentences: ["leg (den|die) {gerät} auf (den|die|das) {lage}"]}
"""
FRENCH_TOOLS = """
language: fr
slots: {outil: [marteau, pince], lieu: [cuisine, cave]}
intents:
  cherche: {action: custom, sentences: ["cherche (le|la) {outil} dans la {lieu}"]}
"""


@pytest.mark.parametrize(
    ("grammar", "said", "meant"),
    [
        (TOOLS, "hol den Hammer, nein, die Zange aus dem Lager", "hol die Zange aus dem Lager"),
        (TOOLS, "hol den Hammer nein die Zange aus der Werkstatt", "hol die Zange aus der Werkstatt"),
        (TOOLS, "hol den Hammer aus dem Lager, nein, die Zange", "hol die Zange aus dem Lager"),
        (TOOLS, "leg den Hammer auf den Tisch, nein, die Zange auf das Regal", "leg die Zange auf das Regal"),
        (FRENCH_TOOLS, "cherche le marteau, non, la pince dans la cave", "cherche la pince dans la cave"),
    ],
)
def test_one_article_takes_the_place_of_another(engine_of, grammar: str, said: str, meant: str) -> None:
    engine = engine_of(grammar)
    assert engine.parse(said).actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize("said", ["hol den Hammer aus dem Lager, nein, das", "hol den Hammer, nein, die Zange"])
def test_where_more_is_missing_than_an_article_nothing_is_done(engine_of, said: str) -> None:
    assert engine_of(TOOLS).parse(said).actions == ()
