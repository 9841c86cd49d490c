"""What looks like a quantity in running text and is none, or another."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.language.slots.quantity_finder import find

DEGREE = math.pi / 180
LANGUAGES = st.sampled_from(("en", "de", "fr", "es", "it", "pl"))
SIGNS = st.sampled_from("^²:'°\"/- 23.,")
PIECES = SIGNS | st.sampled_from(
    (
        *("-3", "1.5", "e-3", ". ", " - ", "m", "km", "s", "per ", "pi", "π", "over ", "two ", "twenty ", "first "),
        *("a few ", "hundred ", "and ", "half ", "ein ", "paar ", "deux ", "y "),
    )
)


@settings(max_examples=400, deadline=None)
@given(st.lists(PIECES, max_size=12).map("".join), LANGUAGES)
def test_no_text_is_too_odd(text: str, language: str) -> None:
    last = 0
    for found in find(text, language):
        assert last <= found.start < found.end <= len(text)
        assert math.isfinite(found.value)
        last = found.end


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("en", "a few hundred meters"),
        ("en", "several dozen"),
        ("de", "ein paar Meter"),
        ("it", "qualche decina di metri"),
        ("en", "the forty third door"),
        ("en", "a hundred and second"),
        ("fr", "la quarante et unième porte"),
        ("en", "at 6:45"),
        ("en", "10:20:05"),
        ("en", "3.5^2"),
        ("en", "4.2 x 10^6"),
        ("en", "6'500 m"),
        ("fr", "2 300 m"),
        ("en", "12° 30' 5\""),
        ("en", "pi over six"),
        ("en", "2 pi"),
        ("en", "π/3"),
        ("de", "pi halbe"),
        ("fr", "pi sur quatre radians"),
        ("de", "Komma sieben"),
        ("es", "treinta sextos"),
        ("fr", "cent vingt-deux cinquièmes"),
        ("en", "oh, wait"),
        ("en", "not that one please"),
    ],
)
def test_none(language: str, text: str) -> None:
    assert find(text, language) == []


@pytest.mark.parametrize(
    ("language", "text", "number"),
    [
        ("en", "six miles squared", 6),
        ("en", "7 cm^2", 7),
        ("en", "7cm2", 7),
        ("en", "3 m³", 3),
        ("en", "four feet per second squared", 4),
        ("en", "4 m/s^2", 4),
        ("en", "4 m/s2", 4),
        ("en", "one meter per second per second", 1),
        ("en", "five meters per square second", 5),
        ("en", "eighteen degrees Celsius", 18),
        ("en", "64 °F", 64),
        ("de", "18 Grad Celsius", 18),
        ("fr", "neuf mètres carrés", 9),
        ("es", "ocho metros cuadrados", 8),
        ("it", "sei metri quadri", 6),
    ],
)
def test_of_another_unit_only_the_number_is_known(language: str, text: str, number: float) -> None:
    assert [(one.kind, one.value) for one in find(text, language)] == [("number", number)]


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("Take one. Thirty more came.", [("number", 1), ("number", 30)]),
        ("two, forty five, six", [("number", 2), ("number", 45), ("number", 6)]),
        ("5 m - 8 m", [("distance", 5), ("distance", 8)]),
        ("5 m 8 m", [("distance", 5), ("distance", 8)]),
        ("one meter, ten degrees", [("distance", 1), ("angle", 10 * DEGREE)]),
        ("one meter ten degrees", [("distance", 1), ("angle", 10 * DEGREE)]),
        ("three, and a half meters", [("distance", 3.5)]),
        ("4 feet, 3 inches", [("distance", 1.2954)]),
        ("4 feet, 3 boxes", [("distance", 1.2192), ("number", 3)]),
        ("one hour, five minutes, and ten seconds", [("duration", 3910)]),
        ("two million, three hundred", [("number", 2_000_300)]),
        ("4 ft. 3 in. high", [("distance", 1.2954)]),
        ("sixty - one", [("number", 61)]),
        ("forty second pauses", [("duration", 40)]),
        ("some 20 meters", [("distance", 20)]),
        ("this one meter rule", [("distance", 1)]),
        ("half past four", [("number", 4)]),
        ("ninety percent of 8 m", [("percent", 0.9), ("distance", 8)]),
        ("3.5e-2 m", [("distance", 0.035)]),
        ("-4e3", [("number", -4000)]),
        ("pi over six radians", [("angle", 30 * DEGREE)]),
        ("π/3 rad", [("angle", 60 * DEGREE)]),
    ],
)
def test_what_stands_beside_what(text: str, found: list[tuple[str, float]]) -> None:
    assert [(one.kind, one.value) for one in find(text)] == [(kind, pytest.approx(value)) for kind, value in found]


def test_no_long_number_is_cut_off() -> None:
    said = "deux cent trente quatre mille millions cinq cent soixante sept mille huit cent quatre vingt douze"
    assert [one.value for one in find(said, "fr")] == [234_000_567_892]
    said = "seven hundred and fifty six million four hundred and thirty two thousand and nine hundred and eighty seven"
    assert [one.value for one in find(said)] == [756_432_987]
