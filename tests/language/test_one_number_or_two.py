"""Numbers that may be two, units that may be two, and signs that may add."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.language.quantities import evaluate

PHARMACY = """
language: en
slots:
  count: {type: number, whole: true}
  room: {type: number, whole: true}
  way: distance
  tilt: {type: angle, unit: deg, min: -90 deg, max: 90 deg}
  level: {type: percent, min: 0, max: 100 %}
  feed: {type: distance, units: {1 mm: [mil, mils]}}
intents:
  dispense: {action: custom, sentences: ["dispense {count} tablets", "count to {count}"]}
  go: {action: custom, sentences: ["go to room {room}", "go to room {room} for {count} tablets"]}
  lift: {action: custom, sentences: ["lift it {way}"]}
  tilt: {action: custom, sentences: ["tilt it to {tilt}"]}
  dim: {action: custom, sentences: ["dim to {level}"]}
  mill: {action: custom, sentences: ["mill {feed}"]}
"""


@pytest.fixture(scope="module")
def pharmacy(engine_of) -> IntentEngine:
    return engine_of(PHARMACY)


@pytest.mark.parametrize(
    "said",
    [
        "dispense five ten tablets",
        "dispense eight fifteen tablets",
        "count to five ten",
        "lift it five ten feet",
        "lift it two meters five ten centimeters",
    ],
)
def test_how_many_are_meant_is_not_clear(pharmacy: IntentEngine, said: str) -> None:
    assert not pharmacy.parse(said).actions


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("go to room five ten", {"room": 510}),
        ("go to room five ten for ten tablets", {"room": 510, "count": 10}),
        ("dispense one twenty tablets", {"count": 120}),
        ("dispense five hundred ten tablets", {"count": 510}),
        ("tilt it to plus five degrees", {"tilt": pytest.approx(0.0872665, rel=1e-4)}),
        ("tilt it to plus 5", {"tilt": pytest.approx(0.0872665, rel=1e-4)}),
        ("tilt it to minus five", {"tilt": pytest.approx(-0.0872665, rel=1e-4)}),
        ("mill two mils", {"feed": 0.002}),
    ],
)
def test_one_number_is_one(pharmacy: IntentEngine, said: str, slots: dict[str, object]) -> None:
    assert pharmacy.parse(said).slots == slots


def test_a_plus_may_add_where_nothing_is_below_zero(pharmacy: IntentEngine) -> None:
    assert "may add to what it is now" in pharmacy.parse("dim to plus ten percent").reason


@pytest.mark.parametrize("unit", ["mil", "mils"])
def test_a_mil_is_a_thousandth_of_an_inch_to_some(pharmacy: IntentEngine, unit: str) -> None:
    assert evaluate(["five", unit], "distance") is None
    assert not pharmacy.parse(f"lift it five {unit}").actions
