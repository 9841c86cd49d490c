"""Quantities in running text."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.language.slots.quantity_finder import find

DATA = Path(__file__).resolve().parents[3] / ".." / "shared" / "data" / "numbers_units" / "en_values.jsonl"
DEGREE = math.pi / 180


@settings(max_examples=200, deadline=None)
@given(st.text(max_size=80))
def test_quantities_in_running_text_stand_one_after_the_other(text: str) -> None:
    last = 0
    for found in find(text):
        assert last <= found.start < found.end <= len(text)
        assert math.isfinite(found.value)
        last = found.end


def test_quantities_in_running_text() -> None:
    found = find("go 2 m, then turn ninety degrees for three seconds at 0.3 m/s past bay 12")
    assert [(one.kind, round(one.value, 3)) for one in found] == [
        ("distance", 2),
        ("angle", 1.571),
        ("duration", 3),
        ("speed", 0.3),
        ("number", 12),
    ]


@pytest.mark.parametrize("text", ["two feet more", "go two feet more", "deux mètres de plus"])
def test_a_quantity_may_end_with_the_text(text: str) -> None:
    language = "fr" if "deux" in text else "en"
    assert [(one.kind, text[one.end :]) for one in find(text, language)] == [("distance", "")]


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("it is two and a half meters away", "distance", 2.5),
        ("walk three quarters of a mile and rest", "distance", 1207.008),
        ("about 1,250 mm of pipe", "distance", 1.25),
        ("a foot and a half from the wall", "distance", 0.4572),
        ("five feet two inches tall", "distance", 1.5748),
        ("half a kilometer down the road", "distance", 500),
        ("wait a quarter of an hour", "duration", 900),
        ("it took two hours and thirty minutes", "duration", 9000),
        ("for a minute and a half", "duration", 90),
        ("turn by a quarter turn", "angle", 90 * DEGREE),
        ("tilt it 12.5 degrees to the side", "angle", 12.5 * DEGREE),
        ("minus four degrees", "angle", -4 * DEGREE),
        ("at twelve kilometers per hour", "speed", 12 / 3.6),
        ("no faster than half a meter per second", "speed", 0.5),
        ("it spins at 30 degrees per second", "angular_speed", 30 * DEGREE),
        ("one hundred and five people came", "number", 105),
        ("three point one four is close", "number", 3.14),
        ("two dozen eggs", "number", 24),
        ("add 5 g of sugar", "number", 5),
        ("a 2 t truck", "number", 2),
        ("a 10 k run", "number", 10_000),
    ],
)
def test_a_quantity_in_words_that_are_none(text: str, kind: str, value: float) -> None:
    assert [(one.kind, one.value) for one in find(text)] == [(kind, pytest.approx(value))]


# What others wrote is not copied into the repository: where it is not beside it, the quantities above stand for it.
@pytest.mark.data
@pytest.mark.skipif(not DATA.exists(), reason="../shared/data/numbers_units is not here")
def test_quantities_of_others_test_suites() -> None:
    """At least 97 % of those that mean one thing; an angle is labelled in degrees there."""
    rows = [json.loads(line) for line in DATA.read_text("utf-8").splitlines()]
    rows = [row for row in rows if row["robot_scope"]]

    def right(row: dict[str, float | str]) -> bool:
        meant = float(row["value_norm"])
        return any(
            found.kind == row["kind"] or row["kind"] == "number"
            for found in find(str(row["text"]))
            if math.isclose(found.value / (DEGREE if found.kind == "angle" else 1), meant, rel_tol=1e-6, abs_tol=1e-6)
        )

    share = sum(map(right, rows)) / len(rows)
    assert share >= 0.97, share
