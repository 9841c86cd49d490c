"""Units that a grammar has of its own: "take two steps back"."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import ROOT

from intent_engine.actions import Move
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.checker import check_grammar
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.sampler import RandomChoices, Sampler

GRAMMAR = """
language: {language}
{operators}
fillers: []
phrases:
  long: "[long]"
slots:
  way: {{type: distance, units: {{0.3 m: [step, steps], 2 m: "{{long}} (pole|poles)"}}, max: 1 km}}
  eggs: {{type: number, units: {{12: (crate|crates), 30: [tray]}}, whole: true}}
  nap: {{type: duration, units: {{25 min: (round|rounds)}}}}
intents:
  walk:
    action: {{type: custom, name: walk}}
    sentences: ["walk {{way}}"]
    regex: "stroll (?P<way>.+)"
  order:
    action: {{type: custom, name: order}}
    sentences: ["order {{eggs}}", "sleep {{nap}}"]
"""
DUTCH = "operators: {negation: [niet], stop: [halt]}"


@cache
def written(grammar: str) -> IntentEngine:
    with TemporaryDirectory() as folder:
        file = Path(folder) / "own.yaml"
        file.write_text(grammar, "utf-8")
        return IntentEngine.from_files(file)


def engine_of(language: str) -> IntentEngine:
    return written(GRAMMAR.format(language=language, operators=DUTCH if language == "nl" else ""))


@cache
def shipped(language: str) -> IntentEngine:
    return IntentEngine.from_files(ROOT / "grammars" / f"{language}.yaml")


def slots(text: str, language: str = "en") -> dict[str, float] | str:
    found = engine_of(language).parse(text)
    return dict(found.slots) if found.status is Status.ACCEPTED else found.status.value


@given(count=st.integers(1, 300), unit=st.sampled_from(["step", "steps", "pole", "long pole"]), spell=st.booleans())
@pytest.mark.parametrize("verb", ["walk", "stroll"])
def test_a_count_is_so_many_times_the_unit(verb: str, count: int, unit: str, spell: bool) -> None:
    words = " ".join(in_words([str(count)])) if spell else str(count)
    found = slots(f"{verb} {words} {unit}")
    assert isinstance(found, dict)
    assert math.isclose(found["way"], count * (0.3 if "step" in unit else 2.0))


@pytest.mark.parametrize("language", ["en", "de", "fr", "es", "it", "nl"])
@given(count=st.integers(1, 99))
def test_in_every_language(language: str, count: int) -> None:
    found = slots(f"walk {count} steps", language)
    assert isinstance(found, dict)
    assert math.isclose(found["way"], count * 0.3)


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("walk a step", {"way": 0.3}),
        ("walk half a step", {"way": 0.15}),
        ("walk a couple of steps", {"way": 0.6}),
        ("walk a step and a half", {"way": 0.45}),
        ("walk two and a half steps", {"way": 0.75}),
        ("walk another three steps", "rejected"),
        ("walk two more steps", {"way": 0.6}),
        ("walk two steps, no, three", {"way": 0.9}),
        ("walk two meters, no, three steps", {"way": 0.9}),
        ("walk two steps, no, three meters", {"way": 3.0}),
        ("walk two meters", {"way": 2.0}),
        ("order two crates", {"eggs": 24}),
        ("order half a crate", {"eggs": 6}),
        ("order a tray", {"eggs": 30}),
        ("order ten", {"eggs": 10}),
        ("sleep three rounds", {"nap": 4500.0}),
        ("walk two poles three steps", {"way": 4.9}),
        ("walk a pole and three steps", {"way": 2.9}),
        ("order a tray and two crates", {"eggs": 54}),
        # A smaller one first, one twice, more of the smaller one than the larger has, and a part of the larger.
        ("walk three steps two poles", "rejected"),
        ("walk two steps two steps", "rejected"),
        ("walk a pole ten steps", "rejected"),
        ("walk half a pole and three steps", "rejected"),
        # No number, two of them, another unit, and more than its limit.
        ("walk steps", "rejected"),
        ("walk a few steps", "rejected"),
        ("walk two steps ten", "rejected"),
        ("walk five ten steps", "rejected"),  # five to ten
        ("walk two steps and ten centimeters", "rejected"),
        ("walk two crates", "rejected"),
        ("walk a thousand poles", "rejected"),
        ("order an eighth of a crate", "rejected"),
    ],
)
def test_how_they_are_said(said: str, expected: object) -> None:
    assert slots(said) == expected


def test_what_counts_is_an_int() -> None:
    found = slots("order two crates")
    assert isinstance(found, dict)
    assert type(found["eggs"]) is int


@pytest.mark.parametrize("language", ["en", "de"])
@given(count=st.integers(1, 60), back=st.booleans())
def test_the_shipped_grammars_count_steps(language: str, count: int, back: bool) -> None:
    if language == "en":
        said = f"take {count} steps {'back' if back else 'forward'}"
    else:
        said = f"mach {count} Schritte {'zurück' if back else 'vor'}"
    (action,) = shipped(language).parse(said).actions
    assert isinstance(action, Move)
    assert math.isclose(action.distance, count * 0.3)
    assert (action.linear_velocity < 0) == back


@pytest.mark.parametrize(
    "said", ["take two steps", "two steps ahead of me", "take steps back", "one step at a time", "take the steps back"]
)
def test_steps_of_something_else_move_nothing(said: str) -> None:
    assert not shipped("en").parse(said).actions


def test_they_are_checked_without_a_doubt() -> None:
    findings = check_grammar(engine_of("en").matcher("en").grammar, None).findings
    assert not [one for one in findings if one.level != "note"]


GRAMS = """
language: en
slots:
  mass: {type: number, units: {1: [g, gram, grams], 1000: [kg, kilo, kilos], 0.001: mg}}
intents:
  weigh: {action: custom, sentences: ["weigh {mass} of flour"]}
"""


@pytest.mark.parametrize(
    ("said", "mass"),
    [
        ("250g", 250),
        ("250 g", 250),
        ("2.5 kg", 2500),
        ("1 kg 250 g", 1250),
        ("two kilos and three grams", 2003),
        ("2 g 500 mg", 2.5),
        ("2g 500mg", 2.5),
    ],
)
def test_a_sign_that_scales_numbers_may_be_a_unit(said: str, mass: float) -> None:
    assert written(GRAMS).parse(f"weigh {said} of flour").slots == {"mass": mass}


@given(kilos=st.integers(1, 50), grams=st.integers(1, 999), joint=st.sampled_from([" ", " and "]))
def test_a_larger_and_a_smaller_unit_add_up(kilos: int, grams: int, joint: str) -> None:
    engine = written(GRAMS)
    assert engine.parse(f"weigh {kilos} kg{joint}{grams} g of flour").slots == {"mass": kilos * 1000 + grams}
    assert not engine.parse(f"weigh {grams} g{joint}{kilos} kg of flour").actions


@given(
    number=st.sampled_from(["two", "2", "two hundred", "2.5", "a dozen", "half"]),
    more=st.sampled_from(["", "12: (box|boxes), "]),
    unit=st.sampled_from(["", ", unit: gram", ", unit: g"]),
)
def test_a_number_alone_counts_ones_only_where_these_have_no_other_name(number: str, more: str, unit: str) -> None:
    """Who leaves the unit out may mean kilos, so the slot has to say that it is grams."""
    grammar = """
    language: en
    slots:
      mass: {{type: number, units: {{{more}1: [gram, grams, g], 1000: [kilo, kilos]}}{unit}}}
      eggs: {{type: number, units: {{12: (crate|crates)}}}}
    intents:
      weigh: {{action: custom, sentences: ["weigh {{mass}}"]}}
      count: {{action: custom, sentences: ["count {{eggs}}"]}}
    """
    engine = written(grammar.format(more=more, unit=unit))
    assert bool(engine.parse(f"weigh {number}").actions) == bool(unit)
    assert engine.prefix(f"weigh {number}").status == ("extendable" if unit else "incomplete")
    assert engine.parse("weigh two kilos").slots == {"mass": 2000}
    assert engine.parse(f"count {number}").actions
    sampler = Sampler(engine.grammar)
    said = [sampler.draw(RandomChoices(seed), "weigh").text for seed in range(40)]
    assert [text for text in said if not engine.parse(text).actions] == []
