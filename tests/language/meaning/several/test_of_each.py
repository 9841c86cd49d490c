"""What is said of several things is of each, where somebody says so or a level is set; and what one name is."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine import IntentEngine

LAB = """
language: en
slots:
  plate: [source plate, target plate]
  row: [a, b, c]
  column: {type: number, min: 1, max: 12, whole: true}
  oven: {type: number, min: 1, max: 9, whole: true}
  amount: {type: number, max: 500}
  heat: {type: number, max: 300}
  time: duration
intents:
  shake: {action: custom, sentences: ["shake the {plate} [for {time}]"]}
  stir: {action: custom, sentences: ["stir the {plate} {amount} times"]}
  move: {action: custom, sentences: ["move to well {row} {column}"]}
  drip: {action: custom, sentences: ["drip {amount} milliliters into well {row} {column}"]}
  add: {action: custom, sentences: ["add {amount} grams to oven {oven}"]}
  bake: {action: custom, sentences: ["heat oven {oven} to {heat} degrees", "bake in oven {oven} for {time}"]}
"""


@pytest.fixture(scope="module")
def lab(engine_of) -> IntentEngine:
    return engine_of(LAB)


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        (
            "shake the source plate and the target plate for ten seconds each",
            "shake the source plate for ten seconds, then shake the target plate for ten seconds",
        ),
        (
            "stir the source plate and the target plate five times each",
            "stir the source plate five times, then stir the target plate five times",
        ),
        ("bake in oven 3 and 4 for a minute each", "bake in oven 3 for a minute, then bake in oven 4 for a minute"),
        ("bake in ovens 3 and 4 for a minute apiece", "bake in oven 3 for a minute, then bake in oven 4 for a minute"),
        ("add five grams each to oven 3 and 4", "add five grams to oven 3, then add five grams to oven 4"),
        (
            "drip 50 milliliters each into well A1 and B2",
            "drip 50 milliliters into well A1, then drip 50 milliliters into well B2",
        ),
        ("heat ovens 3 and 4 to 200 degrees", "heat oven 3 to 200 degrees, then heat oven 4 to 200 degrees"),
        ("move to well A1 and A2", "move to well A1, then move to well A2"),
        ("move to wells A1, B2 and C3", "move to well A1, then move to well B2, then move to well C3"),
        ("move to well b 1 and a 2", "move to well B1, then move to well A2"),
    ],
)  # fmt: skip
def test_each_is_done(lab: IntentEngine, said: str, plain: str) -> None:
    assert_same(lab, said, plain)


@pytest.mark.parametrize(
    "said",
    [
        # Of each, or of all together?
        "shake the source plate and the target plate for ten seconds", "bake in oven 3 and 4 for a minute",
        "add five grams to oven 3 and 4", "drip 50 milliliters into well A1 and B2",
        "bake in each oven for a minute", "shake each", "each", "shake the source plate or the target plate each",
        "don't shake the source plate and the target plate for ten seconds each",
        "we shake the source plate and the target plate for ten seconds each", "move to well A1 or A2",
    ],
)  # fmt: skip
def test_what_is_not_clear_does_nothing(lab: IntentEngine, said: str) -> None:
    assert not lab.parse(said).actions


OVENS = """
language: {language}
slots:
  nummer: {{type: number, min: 1, max: 9, whole: true}}
  zeit: duration
intents:
  bake: {{action: custom, sentences: ["{sentence}"]}}
"""


@pytest.mark.parametrize(
    ("language", "sentence", "said"),
    [
        ("de", "heiz Ofen {nummer} [für {zeit}]", "heiz Ofen 3 und 4 jeweils für zehn Minuten"),
        ("es", "calienta el horno {nummer} [durante {zeit}]", "calienta el horno 3 y 4 durante diez minutos cada uno"),
        ("fr", "chauffe le four {nummer} [pendant {zeit}]", "chauffe le four 3 et 4 pendant dix minutes chacun"),
        ("it", "scalda il forno {nummer} [per {zeit}]", "scalda il forno 3 e 4 per dieci minuti ciascuno"),
    ],
)
def test_in_other_languages(engine_of, language: str, sentence: str, said: str) -> None:
    found = engine_of(OVENS.format(language=language, sentence=sentence)).parse(said)
    assert [dict(action.slots) for action in found.actions] == [
        {"nummer": 3, "zeit": 600.0},
        {"nummer": 4, "zeit": 600.0},
    ]
