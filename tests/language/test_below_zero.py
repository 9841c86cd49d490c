"""Quantities below zero are so with all their parts."""

from __future__ import annotations

import math

import pytest

from intent_engine.language.quantities import evaluate

DEGREE = math.pi / 180


@pytest.mark.parametrize(
    ("kind", "said", "value"),
    [
        ("distance", "minus one inch and a half", -1.5 * 0.0254),
        ("distance", "minus an inch and a quarter", -1.25 * 0.0254),
        ("distance", "-1 inch and a half", -1.5 * 0.0254),
        ("distance", "minus two feet three inches", -27 * 0.0254),
        ("distance", "negative one foot and two inches", -14 * 0.0254),
        ("distance", "minus two centimeters five millimeters", -0.025),
        ("distance", "minus two meters fifty", -2.5),
        ("distance", "minus zero feet two inches", -2 * 0.0254),
        ("angle", "minus ten degrees and a half", -10.5 * DEGREE),
        ("speed", "minus one meter and a half per second", -1.5),
        ("distance", "one foot minus two inches", 10 * 0.0254),
    ],
)
def test_the_sign_is_of_all_of_it(kind: str, said: str, value: float) -> None:
    assert evaluate(said.split(), kind) == pytest.approx(value)


@pytest.mark.parametrize(
    ("language", "said", "value"),
    [
        ("de", "minus zwei meter fünfzig", -2.5),
        ("fr", "moins deux mètres et demi", -2.5),
        ("it", "meno un metro e mezzo", -1.5),
        ("es", "menos dos metros y medio", -2.5),
    ],
)
def test_so_it_is_in_other_languages(language: str, said: str, value: float) -> None:
    assert evaluate(said.split(), "distance", language) == pytest.approx(value)


@pytest.mark.parametrize(
    "said", ["minus -5", "plus -5", "minus minus five", "plus minus five", "minus one foot minus two inches"]
)
def test_of_two_signs_nobody_knows(said: str) -> None:
    kind = "distance" if "foot" in said else "number"
    assert evaluate(said.split(), kind) is None


def test_so_are_units_of_a_grammar(engine_of) -> None:
    engine = engine_of(
        "language: en\nslots: {lift: {type: distance, min: -5 m, units: {20 cm: [notch, notches]}}}\n"
        "intents: {lift: {action: custom, sentences: ['lift {lift}']}}\n"
    )
    assert engine.parse("lift minus two notches and a half").slots == {"lift": pytest.approx(-0.5)}
