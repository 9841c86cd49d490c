"""How much of the whole, in a slot that holds a percentage: "half" is fifty percent, and never half a percent."""

from __future__ import annotations

import pytest

from intent_engine.language.quantities import share

GRAMMAR = """
language: {language}
slots: {{level: {{type: percent, min: 0, max: 100 %{unit}}}}}
intents:
  dim: {{action: custom, sentences: ["dim to {{level}} [now]"]}}
"""


@pytest.mark.parametrize("unit", ["", ", unit: percent"])
@pytest.mark.parametrize(
    ("said", "level"),
    [
        ("half", 0.5),
        ("a quarter now", 0.25),
        ("three quarters", 0.75),
        ("two thirds", 2 / 3),
        ("half a percent", 0.005),
        ("a quarter, no, half", 0.5),
        ("full", 1.0),
        ("half, no, full", 1.0),
        ("1/2", 0.5),
        ("½ now", 0.5),
        ("3/4", 0.75),
        ("2/3", 2 / 3),
        ("1/16", 1 / 16),
        ("1/2 percent", 0.005),
    ],
)
def test_a_part_is_one_of_the_whole(engine_of, unit: str, said: str, level: float) -> None:
    engine = engine_of(GRAMMAR.format(unit=unit, language="en"))
    assert engine.parse(f"dim to {said}").slots["level"] == pytest.approx(level)


@pytest.mark.parametrize("unit", ["", ", unit: percent"])
def test_german_parts(engine_of, unit: str) -> None:
    assert engine_of(GRAMMAR.format(unit=unit, language="de")).parse("dim to drei Viertel").slots["level"] == 0.75


@pytest.mark.parametrize("unit", ["", ", unit: percent"])
@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("de", "die Hälfte"),
        ("de", "zehn Prozent, nein, die Hälfte"),
        ("fr", "la moitié"),
        ("es", "la mitad"),
        ("it", "metà"),
    ],
)
def test_half_of_it_is_a_noun_in_other_languages(engine_of, unit: str, language: str, said: str) -> None:
    assert engine_of(GRAMMAR.format(unit=unit, language=language)).parse(f"dim to {said}").slots == {"level": 0.5}


@pytest.mark.parametrize("said", ["die", "drei Hälfte", "die Hälfte Prozent", "Hälfte der Lampen"])
def test_what_is_no_half(engine_of, said: str) -> None:
    assert not engine_of(GRAMMAR.format(unit="", language="de")).parse(f"dim to {said}").actions


@pytest.mark.parametrize(
    "said",
    [
        "half or a quarter",
        "half fifty",
        "full half",
        "a full",
        "minus half",
        "a",
        "third",
        "3/2",
        "1 1/2",
        "1/2 m",
        "50",
        "0.5",
        "1/2 or 1/4",
    ],
)
def test_what_is_no_part(engine_of, said: str) -> None:
    assert not engine_of(GRAMMAR.format(unit="", language="en")).parse(f"dim to {said}").actions


@pytest.mark.parametrize("said", ["point five", "one and a half", "three halves", "two", "a", "", "minus half"])
def test_no_share(said: str) -> None:
    assert share(said.split()) is None


def test_a_word_of_the_grammar_is_itself(engine_of) -> None:
    grammar = GRAMMAR.replace("slots: {{", "slots: {{mode: [full, eco], ")
    grammar = grammar.replace("[now]", '[now]", "dim to {{mode}}')
    engine = engine_of(grammar.format(unit="", language="en"))
    assert engine.parse("dim to full").slots == {"mode": "full"}
    assert engine.parse("dim to half").slots == {"level": 0.5}


def test_the_sign_is_the_unit(engine_of) -> None:
    engine = engine_of(GRAMMAR.format(unit=", unit: '%'", language="en"))
    assert engine.parse("dim to thirty").slots["level"] == 0.3
