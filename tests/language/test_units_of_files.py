"""The unit of a grammar file is English in every language, and means one thing in all of them."""

from __future__ import annotations

import math

import pytest

from intent_engine.errors import ConfigError
from intent_engine.language import quantities
from intent_engine.language.numbers.units import FACTORS, units

LANGUAGES = ("en", "de", "es", "fr", "it")
WRITTEN = {
    "distance": ("m", "meters", "feet", "cm", "inches", "yards"),
    "angle": ("deg", "degrees", "rad", "turns"),
    "duration": ("s", "seconds", "minutes", "hours", "days"),
    "speed": ("m/s", "km/h", "mph", "knots", "meters per second"),
    "angular_speed": ("deg/s", "rad/s", "rpm", "degrees per second"),
    "percent": ("percent",),
}
TURN = """
language: de
slots: {{winkel: {{type: angle, max: {most}, unit: {unit}}}}}
intents:
  drehen:
    action: {{type: turn, direction: left, angle: "{{winkel}}"}}
    sentences: ["dreh dich nach links {{winkel}}"]
"""


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("kind", "unit"), [(kind, unit) for kind, known in WRITTEN.items() for unit in known])
def test_a_number_without_its_unit_has_that_of_the_file(language, kind, unit) -> None:
    found = quantities.evaluate(("5",), kind, language, unit)
    assert found is not None
    assert found == quantities.evaluate(("5",), kind, "en", unit)


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_unit_of_a_file_is_a_word_for_another_one(language) -> None:
    table = units(language)
    assert table is not None
    for kind, said in table.by_kind.items():
        for words, factor in said.items():
            written = FACTORS.get(kind, {}).get(" ".join(words), factor)
            assert math.isclose(written, factor), (kind, words)


def test_a_unit_in_another_language_is_refused_with_the_english_one(engine_of) -> None:
    with pytest.raises(ConfigError) as refused:
        engine_of(TURN.format(most="10 Grad", unit="grad"))
    told = [(problem.message, problem.hint) for problem in refused.value.problems]
    assert told == [
        ("'10 Grad' is not an angle", "write it with the unit deg, in English whatever is spoken"),
        ("'grad' is not a unit of angle", "write deg"),
    ]


def test_ninety_are_ninety_degrees(engine_of) -> None:
    engine = engine_of(TURN.format(most="360 deg", unit="degree"))
    assert engine.parse("dreh dich nach links 90").actions[0].angle == pytest.approx(math.pi / 2)
