"""A filler by which a list or a map calls something: an "ER" is a place where it is said as one."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

HOSPITAL = """
language: en
slots:
  place: location
  area: [hall, well]
  thing: {type: text, max_words: 3}
intents:
  go: {action: custom, sentences: ["(go|drive) to [the] {place}"]}
  clean: {action: custom, sentences: ["clean [the] {area}"]}
  take: {action: custom, sentences: ["take [the] {thing} to [the] {place}"]}
"""
MAP = {"ER": (0.0, 0.0, 0.0), "kitchen": (1.0, 0.0, 0.0), "ER lobby": (2.0, 0.0, 0.0)}


@pytest.fixture(scope="module")
def hospital(engine_of) -> IntentEngine:
    return engine_of(HOSPITAL, locations=MAP)


@pytest.mark.parametrize(
    ("said", "names"),
    [
        ("go to the ER", ["ER"]),
        ("go to the ER please", ["ER"]),
        ("um, please go to the ER now", ["ER"]),
        ("go to, er, the ER", ["ER"]),
        ("go to the ER, no, the kitchen", ["kitchen"]),
        ("go to the kitchen, no, the ER", ["ER"]),
        ("go to the ER instead", ["ER"]),
        ("go to the ER and clean the well", ["ER", "well"]),
        ("clean the well, no, the hall", ["hall"]),
        ("clean the hall, no, the well", ["well"]),
        ("go to the kitchen and the ER", ["kitchen", "ER"]),
        ("take the cup to the ER, no, the kitchen", ["kitchen"]),
        ("go to the ER lobby", ["ER lobby"]),
        # Elsewhere people only think what to say.
        ("go to the er kitchen", ["kitchen"]),
        ("go to the, er, kitchen", ["kitchen"]),
        ("er, go to the kitchen", ["kitchen"]),
        ("go er to the kitchen", ["kitchen"]),
        ("well, clean the hall", ["hall"]),
        # It may be either.
        ("go to the er, kitchen", []),
        ("go to the kitchen or the ER", []),
        ("don't go to the ER", []),
        ("I was at the ER", []),
    ],
)
def test_it_is_a_name_behind_its_article(hospital: IntentEngine, said: str, names: list[str]) -> None:
    actions = hospital.parse(said).actions
    assert [action.slots.get("place", action.slots.get("area")) for action in actions] == names


def test_where_nothing_is_called_so_it_says_nothing(engine_of) -> None:
    engine = engine_of(HOSPITAL, locations={"kitchen": (1.0, 0.0, 0.0)})
    assert engine.parse("go to the er, kitchen").slots == {"place": "kitchen"}
    assert not engine.parse("go to the ER").actions
