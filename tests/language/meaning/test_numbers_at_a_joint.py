"""A number that ends a command, and one that begins the next behind an "and": "for bed 3 and ten tablets for bed 4"."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

GRAMMAR = """
language: en
slots:
  count: {type: number, whole: true, max: 500}
  mass: {type: number, units: {1: [gram, grams], 1000: [kilo, kilos]}}
  thing: [salt, flour, tea]
  bed: {type: number, whole: true, max: 200}
phrases:
  what: "({count} boxes of|{mass} of) {thing} [for bed {bed}]"
intents:
  bring: {action: custom, sentences: ["bring {what}"], then: ["{what}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize("spoken", [False, True])
@pytest.mark.parametrize(
    ("said", "beds"),
    [
        ("bring 2 boxes of salt for bed 3 and 10 boxes of tea for bed 4", [3, 4]),
        ("bring two boxes of salt for bed three and ten boxes of tea for bed four", [3, 4]),
        ("bring 250 grams of tea for bed 3 and 2 kilos of flour for bed 120", [3, 120]),
        ("bring a kilo of salt for bed twenty and a kilo of tea for bed two", [20, 2]),
        ("bring 2 boxes of salt for bed 3 and then 10 boxes of tea", [3, None]),
    ],
)
def test_they_are_two_where_both_commands_end_alike(
    engine: IntentEngine, said: str, beds: list[int | None], spoken: bool
) -> None:
    found = engine.parse(said, spoken=spoken)
    assert [step["slots"].get("bed") for step in found.slots.get("steps", ())] == beds, found.reason


@pytest.mark.parametrize(
    "said",
    [
        "bring 2 boxes of salt for bed 100 and 10 boxes of tea for bed 4",  # a hundred and ten
        "bring 2 boxes of salt for bed 3 and 10 boxes of tea",
        "bring 2 boxes of salt for bed 3, 10 boxes of tea for bed 4",
        "bring 2 boxes of salt for bed 3 and 10",
        "bring 2 boxes of salt for bed 3 and 10 for bed 4",
    ],
)
def test_elsewhere_they_may_be_one(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions
