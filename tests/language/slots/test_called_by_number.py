"""What is called by a number: "row number seven" is row seven."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

FARM = """
language: en
slots:
  row: {type: number, whole: true, max: 99, digits: true}
  litres: {type: number, max: 9}
  times: {type: number, max: 5}
intents:
  water: {action: custom, sentences: ["water row {row} [with {litres} liters]"]}
  knock: {action: custom, sentences: ["knock [on the door] [{times} times]"]}
  take: {action: custom, sentences: ["take {litres}"]}
"""


@pytest.fixture(scope="module")
def farm(engine_of) -> IntentEngine:
    return engine_of(FARM)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("water row number seven", {"row": 7}),
        ("please water row number 7 with three liters", {"row": 7, "litres": 3.0}),
        ("water row number one two", {"row": 12}),
        ("water row seven", {"row": 7}),
    ],
)
def test_the_word_number_before_a_number(farm, said, slots) -> None:
    assert farm.parse(said).slots == slots


@pytest.mark.parametrize(
    "said",
    ["knock on the door number three times", "knock number three times", "take number seven", "water row number",
     "water number seven", "water row, number seven", "water row number hundred", "do not water row number seven"],
)  # fmt: skip
def test_what_is_not_called_so(farm, said) -> None:
    assert not farm.parse(said).actions


@pytest.mark.parametrize(
    ("said", "meant", "told"),
    [
        ("water the seventh row", "water row 7", "'the seventh row'"),
        ("please water the 7th row with three liters", "water row 7 with three liters", "'the 7th row'"),
        ("water twenty first row", "water row 21", "'twenty first row'"),
        ("knock on the door three times and water the second row", "knock three times and water row 2", "'the second"),
    ],
)
def test_one_in_order_is_asked_about_where_it_has_a_number(farm, said, meant, told) -> None:
    """The third in a row need not be row three: "yes" says that it is."""
    asked = farm.parse(said)
    assert not asked.actions
    assert asked.reason.startswith(told)
    done = farm.parse("yes", last=asked)
    assert done.actions == farm.parse(meant).actions != ()
    assert not farm.parse("no", last=asked).actions


@pytest.mark.parametrize(
    "said",
    [
        "water the hundredth row",  # there is none
        "water a third row",
        "water one third row",
        "water the last row",
        "water the third",
        "don't water the third row",
        "knock the third time",  # how often, and no name
        "is the third row wet",
        "the third row needs water",
    ],
)
def test_what_is_in_order_and_names_nothing_is_not_asked_about(farm, said) -> None:
    found = farm.parse(said)
    assert not found.actions
    assert "say the number" not in found.reason


@pytest.mark.parametrize(
    ("language", "sentence", "said", "meant", "yes"),
    [
        ("de", "öffne die Schublade {n}", "öffne die dritte Schublade", "öffne die Schublade 3", "ja"),
        ("fr", "ouvre le tiroir {n}", "ouvre le troisième tiroir", "ouvre le tiroir 3", "oui"),
        ("es", "abre el cajón {n}", "abre el segundo cajón", "abre el cajón 2", "sí"),
        ("it", "apri il cassetto {n}", "apri il terzo cassetto", "apri il cassetto 3", "sì"),
    ],
)
def test_in_other_languages_too(engine_of, language, sentence, said, meant, yes) -> None:
    engine = engine_of(
        f"language: {language}\nslots: {{n: {{type: number, whole: true, max: 9}}}}\n"
        f'intents: {{open: {{action: custom, sentences: ["{sentence}"]}}}}'
    )
    asked = engine.parse(said)
    assert not asked.actions
    assert asked.alternatives == (meant.lower(),)
    assert asked.reason.endswith("say the number")
    assert engine.parse(yes, last=asked).actions == engine.parse(meant).actions != ()
