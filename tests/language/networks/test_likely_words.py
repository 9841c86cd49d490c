"""A sentence that ends with a number goes on with a unit, and that is what a person is told."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import german, shipped

from intent_engine import IntentEngine, Status

GRAMMAR = """
language: {language}
slots:
  way: {{type: distance, units: {{30 cm: [{step}, {steps}]}}}}
  time: {{type: duration}}
  mass: {{type: number, units: {{1: [gram], 1000: [kilo]}}}}
intents:
  go: {{action: custom, sentences: ["go {{way}}", "go {{time}} [please]"]}}
  weigh: {{action: custom, sentences: ["weigh {{mass}}"]}}
"""


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    words = {"en": ("pace", "paces"), "de": ("satz", "sätze")}
    return {
        language: engine_of(GRAMMAR.format(language=language, step=step, steps=steps))
        for language, (step, steps) in words.items()
    }


@pytest.mark.parametrize(
    ("language", "said", "told"),
    [
        ("en", "go three", ("meters", "seconds", "paces")),
        ("en", "go 3", ("meters", "seconds", "paces")),
        ("en", "go one", ("meter", "second", "pace")),
        ("en", "weigh two", ("gram", "kilo")),
        ("de", "go drei", ("metern", "sekunden", "sätze")),
        ("de", "go 1", ("meter", "sekunde", "satz")),
    ],
)
def test_units_come_first(engines: dict[str, IntentEngine], language: str, said: str, told: tuple[str, ...]) -> None:
    found = engines[language].parse(said)
    assert found.status is Status.INCOMPLETE
    assert found.alternatives[: len(told)] == told


@given(st.sampled_from(["go forward", "back up"]), st.sampled_from(["three", "two hundred", "2.5"]))
def test_each_that_is_told_goes_on_so(begin: str, number: str) -> None:
    found = shipped().parse(f"{begin} {number}")
    assert found.status is Status.INCOMPLETE
    assert found.alternatives[0] == "meters"
    assert len(found.alternatives) == 8
    for word in found.alternatives:
        assert shipped().parse(f"{begin} {number} {word}").status is not Status.INCOMPLETE, word


def test_in_german_no_sign_is_told() -> None:
    assert german().parse("dreh dich um drei").alternatives[0] == "grad"


@pytest.mark.parametrize(
    ("said", "first"),
    [("turn", ("left", "right")), ("go to the", ("bedroom", "dock", "entrance", "kitchen", "left", "right"))],
)
def test_what_is_said_most_comes_first(said: str, first: tuple[str, ...]) -> None:
    assert shipped().parse(said).alternatives[: len(first)] == first


@pytest.mark.parametrize("said", ["go to the", "turn", "head", "put the cup", "look"])
def test_what_makes_a_sentence_whole_comes_before_what_does_not(said: str) -> None:
    told = shipped().parse(said).alternatives
    whole = [shipped().parse(f"{said} {word}").status is Status.ACCEPTED for word in told]
    assert any(whole), f"none of {told} makes it a sentence"
    assert whole == sorted(whole, reverse=True)
