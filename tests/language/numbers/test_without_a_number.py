"""Speeds and angles that are said without a number, in every language that has numbers."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import intent_engine.language as language_room
from intent_engine.language.normalize import words_of
from intent_engine.language.numbers.relative import Relative
from intent_engine.language.numbers.units import units
from intent_engine.language.quantities import evaluate

LANGUAGES = sorted(file.stem for file in (Path(language_room.__file__).parent / "numbers").glob("*.yaml"))
ROBOT = """
language: {language}
slots: {{speed: speed, angle: angle}}
intents:
  drive: {{action: custom, defaults: {{speed: 0.4 m/s}}, sentences: ["{drive} [{{speed}}]"]}}
  turn: {{action: custom, sentences: ["{turn} {{angle}}"]}}
"""
VERBS = {
    "en": ("drive", "do"), "de": ("fahr", "mach"), "fr": ("avance", "fais"), "es": ("avanza", "da"),
    "it": ("avanza", "fai"),
}  # fmt: skip


def table_of(language: str):
    table = units(language)
    assert table is not None
    return table


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_language_has_both(language: str) -> None:
    table = table_of(language)
    assert {0.5, 1.0, 1.5, 2.0} <= {*table.speeds.values()}
    assert math.pi in table.whole_angles.values()


@pytest.mark.parametrize(
    ("language", "said", "factor"),
    [(language, said, factor) for language in LANGUAGES for said, factor in table_of(language).speeds.items()],
)
def test_every_speed_is_read_where_a_grammar_has_speeds(engine_of, language: str, said: str, factor: float) -> None:
    assert evaluate(said.split(), "speed", language) == evaluate(said.split(), "angular_speed", language)
    assert evaluate(said.split(), "speed", language) == Relative(factor)


@pytest.mark.parametrize(
    ("language", "said", "factor"),
    [
        ("fr", "avance lentement", 0.5),
        ("fr", "avance à mi-vitesse", 0.5),
        ("fr", "avance au ralenti", 0.5),
        ("fr", "avance à toute vitesse", 2.0),
        ("fr", "avance 50 % de la vitesse", 0.5),
        ("fr", "avance moins vite", 0.5),
        ("es", "avanza despacio", 0.5),
        ("es", "avanza a media velocidad", 0.5),
        ("es", "avanza muy rápido", 2.0),
        ("es", "avanza cincuenta por ciento de velocidad", 0.5),
        ("it", "avanza piano", 0.5),
        ("it", "avanza piano piano", 0.25),
        ("it", "avanza a metà velocità", 0.5),
        ("it", "avanza 50% della velocità", 0.5),
        ("de", "fahr höchster Geschwindigkeit", 2.0),
        ("fr", "avance pas vite", None),
        ("es", "no avances despacio", None),
    ],
)
def test_how_fast_people_say(engine_of, language: str, said: str, factor: float | None) -> None:
    drive, turn = VERBS[language]
    found = engine_of(ROBOT.format(language=language, drive=drive, turn=turn)).parse(said)
    assert found.slots.get("speed") == factor
    assert bool(found.actions) == (factor is not None)


@pytest.mark.parametrize(
    ("language", "said"),
    [(language, " ".join(words)) for language in LANGUAGES for words in table_of(language).whole_angles]
    + [("fr", "demi-tour"), ("es", "media vuelta"), ("it", "mezzo giro"), ("de", "eine halbe Drehung")],
)
def test_angles_without_a_number(engine_of, language: str, said: str) -> None:
    drive, turn = VERBS[language]
    words = words_of(said, language)
    (action,) = engine_of(ROBOT.format(language=language, drive=drive, turn=turn)).parse(f"{turn} {said}").actions
    assert action.slots["angle"] == pytest.approx(table_of(language).whole_angles.get(words, math.pi))
