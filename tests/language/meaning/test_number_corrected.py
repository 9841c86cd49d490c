"""A number that is corrected is the new one, and never goes together with a part of the old."""

from __future__ import annotations

import math
from functools import cache

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import ROOT, done, shipped

from intent_engine.actions import Move, Turn
from intent_engine.engine import IntentEngine
from intent_engine.language.numbers import said
from intent_engine.language.numbers.spelled import in_words


@cache
def german() -> IntentEngine:
    return IntentEngine.from_files(ROOT / "grammars" / "de.yaml")


def spelled(number: float, language: str) -> str:
    if language == "en" or number != int(number):
        return " ".join(in_words([f"{number:g}"]))
    return " ".join(said.spell(int(number), language))


numbers = st.one_of(st.integers(2, 300), st.sampled_from([0.5, 2.5, 12.5]))


@given(numbers, numbers, st.sampled_from(["meters", "steps", "feet"]))
def test_a_distance(old: float, new: float, unit: str) -> None:
    found = shipped().parse(f"go forward {spelled(old, 'en')} {unit}, no, {spelled(new, 'en')}")
    meant = shipped().parse(f"go forward {spelled(new, 'en')} {unit}")
    assert found.actions == meant.actions


@given(st.integers(2, 300), st.integers(2, 300))
def test_a_distance_in_german(old: int, new: int) -> None:
    found = german().parse(f"fahr {spelled(old, 'de')} Meter vor, nein, {spelled(new, 'de')}")
    (move,) = found.actions
    assert isinstance(move, Move)
    assert math.isclose(move.distance, new)


@given(st.integers(5, 360), st.integers(5, 360))
def test_an_angle_without_its_unit(old: int, new: int) -> None:
    found = shipped().parse(f"turn right {spelled(old, 'en')}, no, {spelled(new, 'en')}")
    (turn,) = found.actions
    assert isinstance(turn, Turn)
    assert math.isclose(turn.angle, -math.radians(new))


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("go forward two and a half meters, no, three", "forward 3"),
        ("go forward one hundred meters, no, two", "forward 2"),
        ("go forward half a meter, no, two", "forward 2"),
        ("go forward two meters, no, three and a half", "forward 3.5"),
        # Which of two numbers is meant nobody knows.
        ("go forward four feet six inches, no, five", "rejected"),
        ("go forward one meter twenty, no, thirty", "rejected"),
    ],
)
def test_what_is_kept_of_it_is_the_unit(said: str, meant: str) -> None:
    assert done(shipped().parse(said)) == meant


@given(st.integers(1, 20), st.integers(1, 20), st.sampled_from(["backward", "back", "turn right", "to the kitchen"]))
def test_a_number_behind_a_pause_is_in_doubt_also_where_something_else_is_corrected(
    far: int, number: int, meant: str
) -> None:
    said = f"go forward {spelled(far, 'en')} meters, {spelled(number, 'en')}, no, {meant}"
    assert not any(isinstance(action, Move) for action in shipped().parse(said).actions), said
