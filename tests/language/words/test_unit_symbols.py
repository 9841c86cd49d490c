"""Units of a sentence as recognisers write them: a person says "five kilograms", and "5 kg" is what is written."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status

BENCH = """
language: en
slots:
  n: {type: number, min: -100, max: 5000}
  row: [L, M]
intents:
  lift: {action: custom, sentences: ["lift {n} kilograms", "take {n} kilos of flour"]}
  pour: {action: custom, sentences: ["pour {n} milliliters [(in|into) row {row}]"]}
  push: {action: custom, sentences: ["push with {n} newtons"]}
  flow: {action: custom, sentences: ["flow {n} liters per minute"]}
  feed: {action: custom, sentences: ["feed {n} (millimeters|mm) per minute"]}
  heat: {action: custom, sentences: ["heat to {n} degrees celsius"]}
  turn: {action: custom, sentences: ["tighten to {n} newton meters", "loosen with {n} newtonmeters"]}
  spin: {action: custom, sentences: ["spin at {n} rpm", "mill at {n} revolutions per minute"]}
  film: {action: custom, sentences: ["film {n} frames per second"]}
  weigh:
    action: custom
    regex: "weigh (?P<n>\\\\d+) grams"
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(BENCH)


@pytest.mark.parametrize(
    ("said", "intent", "n"),
    [
        ("lift 5 kg", "lift", 5),
        ("lift 5kg, please", "lift", 5),
        ("lift five kilos", "lift", 5),
        ("take 2 kg of flour", "lift", 2),
        ("pour 2.5 ml into row L", "pour", 2.5),
        ("push with 800 N", "push", 800),
        ("flow 3 l/min", "flow", 3),
        ("flow 3 liters per min", "flow", 3),
        ("feed 1,200 mm/min", "feed", 1200),
        ("heat to 95 deg C", "heat", 95),
        ("heat to 95 C", "heat", 95),
        ("tighten to 40 Nm", "turn", 40),
        ("tighten to 40Nm, no, 50 Nm", "turn", 50),
        ("loosen with 12 newton meters", "turn", 12),
        ("mill at 800 rpm", "spin", 800),
        ("mill at 800 revs per minute", "spin", 800),
        ("mill at 800 rev per min", "spin", 800),
        ("film 30 fps", "film", 30),
        ("weigh 20 g", "weigh", 20),
        ("lift 5 kg, no, 6 kg", "lift", 6),
    ],
)
def test_a_symbol_behind_a_number_is_the_unit_of_the_sentence(engine: IntentEngine, said: str, intent: str, n: float):
    found = engine.parse(said)
    assert (found.status, found.intent) == (Status.ACCEPTED, intent)
    assert found.slots["n"] == pytest.approx(n)


def test_each_command_has_its_own(engine: IntentEngine) -> None:
    found = engine.parse("lift 5 kg and then pour 20 ml")
    assert [action.slots for action in found.actions] == [{"n": 5}, {"n": 20}]


@pytest.mark.parametrize(
    "said",
    [
        "lift kg",
        "lift 5, kg",
        "push with n",
        "don't lift 5 kg",
        "lift 5 ml",
        "flow 3 l per h",
        "push 800 v",
        "film fps",
        "film 30, fps",
    ],
)
def test_no_other_word_is(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


def test_a_word_of_the_grammar_is_itself(engine_of) -> None:
    engine = engine_of(
        "language: en\nslots: {n: {type: number, max: 99}, row: [L, M]}\n"
        "intents: {pour: {action: custom, sentences: ['pour {n} {row}', 'fill {n} liters']}}\n"
    )
    assert engine.parse("pour 3 L").slots == {"n": 3, "row": "L"}
    assert engine.parse("fill 3 L").slots == {"n": 3}
    assert not engine.parse("fill L").actions


@pytest.mark.parametrize(
    ("language", "sentence", "said"),
    [
        ("de", "hebe {n} kilogramm", "hebe 5 kg"),
        ("de", "zieh sie mit {n} newtonmeter an", "zieh sie mit 5 Nm an"),
        ("fr", "soulève {n} kilogrammes", "soulève 5 kg"),
        ("es", "levanta {n} kilogramos", "levanta 5 kg"),
        ("it", "solleva {n} chilogrammi", "solleva 5 kg"),
    ],
)
def test_so_it_is_in_other_languages(engine_of, language: str, sentence: str, said: str) -> None:
    engine = engine_of(
        f"language: {language}\nslots: {{n: {{type: number, max: 99}}}}\n"
        f"intents: {{lift: {{action: custom, sentences: ['{sentence}']}}}}\n"
    )
    assert engine.parse(said).slots == {"n": 5}
