"""A command of a pattern is corrected as any other: a value of it, its end, or all of it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  shelf: [A, B, C]
  bin: {type: number, min: 1, max: 40, whole: true}
  fruit: [apples, pears]
  code: {type: text, max_words: 2}
intents:
  refill:
    action: custom
    regex: "refill (?:bin )?(?P<shelf>[a-c]) ?(?P<bin>\\\\d+)(?: with (?P<fruit>.+))?"
  scan:
    action: custom
    lark: |
      start: "scan code " code
      code: /[a-z] \\d+/
  wave: {action: custom, sentences: ["wave [twice]"]}
"""
JOBS = """
language: en
slots:
  hour: {type: number, min: 0, max: 23, whole: true}
  minute: {type: number, min: 0, max: 59, whole: true}
  job: {type: number, min: 1, max: 99, whole: true}
  begin: {type: number, min: 1, max: 999, whole: true}
  final: {type: number, min: 1, max: 999, whole: true}
intents:
  print:
    action: custom
    lark: |
      start: "print job " job pages?
      pages: " pages " begin " to " final
      job: /\\d+/
      begin: /\\d+/
      final: /\\d+/
  ring:
    action: custom
    lark: |
      start: "ring at " time
      time: hour rest
      rest: " " minute
      hour: /\\d+/
      minute: /\\d+/
"""
"""Whose slots stand at different depths of the tree."""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("refill b 12, no, 13", "refill b 13"),
        ("refill b 12 I mean c", "refill c 12"),
        ("refill bin b 12 with apples, no, pears", "refill bin b 12 with pears"),
        ("refill bin b 12 with apples, sorry, with pears", "refill bin b 12 with pears"),
        ("scan code a 12, no, b 13", "scan code b 13"),
        ("refill b 12, no, 13 with apples", "refill b 13 with apples"),
        ("refill b twelve, no, thirteen with apples", "refill b 13 with apples"),
        ("refill b, no, c 12", "refill c 12"),
        ("refill b 12, no, c 13", "refill c 13"),
        ("refill b 12 with apples, no, c 13 with pears", "refill c 13 with pears"),
        ("refill b 12, no, scan code b 13", "scan code b 13"),
        ("refill b 12, no, wave twice", "wave twice"),
        ("wave twice, no, refill b 12", "refill b 12"),
        ("wave and refill b 12, no, 13", "wave and refill b 13"),
    ],
)
def test_what_is_said_again_counts(engine, said, meant):
    assert engine.parse(said).actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "refill b 12, no",
        "refill b 12, no, d 13",
        "refill b 12, no, 13 with",
        "refill b 12, no, 50",
        "refill b 12 with apples, no, plums",
    ],
)
def test_what_is_no_value_corrects_nothing(engine, said):
    assert not engine.parse(said).actions


@given(st.integers(1, 40), st.integers(1, 40), st.sampled_from("abc"), st.sampled_from(("no", "I mean", "sorry")))
def test_the_last_number_counts(engine, old, new, shelf, corrects):
    assert (
        engine.parse(f"refill {shelf} {old}, {corrects}, {new}").actions
        == engine.parse(f"refill {shelf} {new}").actions
    )


@given(
    st.sampled_from("abc"),
    st.tuples(st.integers(1, 40), st.integers(1, 40)),
    st.tuples(st.sampled_from(("apples", "pears")), st.sampled_from(("apples", "pears"))),
    st.sampled_from(("refill {s} {n}, no, {m} with {f}", "refill {s} {n} with {f}, no, {m} with {g}")),
)
def test_a_pattern_is_corrected_as_the_template_that_says_the_same(both, shelf, bins, fruits, said):
    written, templated = both
    text = said.format(s=shelf, n=bins[0], m=bins[1], f=fruits[0], g=fruits[1])
    found, other = (engine.parse(text) for engine in (written, templated))
    assert found.slots == other.slots
    assert bool(found.actions) == bool(other.actions)


@pytest.fixture(scope="module")
def both(engine_of) -> tuple[IntentEngine, IntentEngine]:
    head, _, rest = GRAMMAR.partition("    regex:")
    template = '    sentences: ["refill [bin] {shelf} {bin} [with {fruit}]"]\n' + rest.partition("\n")[2]
    return engine_of(GRAMMAR), engine_of(head + template)


@pytest.fixture(scope="module")
def jobs(engine_of) -> IntentEngine:
    return engine_of(JOBS)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("print job 4 pages 10 to 20, no, 30 to 40", "print job 4 pages 30 to 40"),
        ("print job 4 pages 10 to 20, no, pages 30 to 40", "print job 4 pages 30 to 40"),
        ("print job 4 pages 10 to 20, no, to 40", "print job 4 pages 10 to 40"),
        ("print job 4 pages 10 to 20, no, job 5", "print job 5 pages 10 to 20"),
        ("ring at 7 30, no, 8 15", "ring at 8 15"),
    ],
)
def test_slots_of_lark_are_corrected_in_the_order_in_which_they_are_said(jobs, said, meant):
    assert jobs.parse(said).actions == jobs.parse(meant).actions != ()


@pytest.mark.parametrize("said", ["ring at 7 30, no, 8", "print job 4 pages 10 to 20, no, 15"])
def test_which_of_two_numbers_of_lark_is_meant_is_asked(jobs, said):
    assert not jobs.parse(said).actions
