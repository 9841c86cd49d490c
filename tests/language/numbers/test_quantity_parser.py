"""Numbers with their units, at a place among words."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.numbers.quantity_parser import parser_of
from intent_engine.language.numbers.units import units

KINDS = ("distance", "angle", "duration", "speed", "angular_speed", "percent")
LANGUAGES = ("en", "de", "fr", "es", "it", "pl")
NUMBERS = ["two", "half", "a", "minus", "2", "1.5", "zwei", "deux", "dos", "due"]


def vocabulary(language: str) -> list[str]:
    table = units(language)
    if table is None:
        return NUMBERS
    spoken = {word for kind in table.by_kind.values() for unit in kind for word in unit}
    joints = {word for phrases in table.words.values() for phrase in phrases for word in phrase.split()}
    return [*NUMBERS, *sorted(joints), *sorted(spoken)]


LAYOUTS = st.sampled_from(LANGUAGES).flatmap(
    lambda language: st.tuples(
        st.just(language), st.lists(st.sampled_from(vocabulary(language)), min_size=1, max_size=6)
    )
)


@given(LAYOUTS, st.sampled_from(KINDS), st.integers(0, 5))
def test_every_quantity_ends_behind_its_begin_and_within_the_words(layout, kind, at):
    language, words = layout
    for value, after in parser_of(language).quantities_at(words, min(at, len(words) - 1), kind):
        assert min(at, len(words) - 1) < after <= len(words)
        assert isinstance(value, float)


@pytest.mark.parametrize(
    ("words", "kind", "first"),
    [
        ("go two meters and a half now", "distance", (2.5, 6)),
        ("go two meters more", "distance", (2.0, 4)),
        ("go half a meter per second", "speed", (0.5, 6)),
        ("go five foot six", "distance", (1.6764, 4)),
        ("turn a full turn", "angle", (2 * math.pi, 4)),
        ("wait one hour thirty", "duration", (5400.0, 4)),
        ("go two seconds", "distance", None),
        ("turn pi radians", "angle", (math.pi, 3)),
        ("turn minus pi over four radians", "angle", (-math.pi / 4, 6)),
        ("turn three pi by two radians", "angle", (1.5 * math.pi, 6)),
        ("turn half pi rad", "angle", (math.pi / 2, 4)),
        ("turn pi over zero radians", "angle", None),
        ("turn pi over two", "angle", None),
        ("for 1 w 2 d 3 h", "duration", (604_800.0 + 172_800 + 10_800, 7)),
        ("for 3 d", "duration", None),
        ("go two in three", "distance", None),
        ("put two in the box", "distance", None),
        ("go 2 in further", "distance", (0.0508, 4)),
    ],
)
def test_the_longest_is_first(words, kind, first):
    found = next(parser_of("en").quantities_at(words.split(), 1, kind), None)
    assert found == (pytest.approx(first) if first is not None else None)


@pytest.mark.parametrize(
    ("unit", "kind", "factor"),
    [
        ("deg", "angle", math.pi / 180),
        ("m/s", "speed", 1.0),
        ("rpm", "angular_speed", 2 * math.pi / 60),
        ("m", "angle", None),
    ],
)
def test_a_unit_as_a_grammar_file_writes_it(unit, kind, factor):
    found = parser_of("en").factor(unit, kind)
    assert found == (pytest.approx(factor) if factor is not None else None)


def test_a_language_without_units_has_numbers_only():
    polish = parser_of("pl")
    assert next(polish.numbers_at(["2", "m"], 0)) == (2.0, 1)
    assert not any(list(polish.quantities_at(["2", "m"], 0, kind)) for kind in KINDS)
