"""A correction that begins with a word of the sentence takes its place from there on, whatever it names."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine, Status
from intent_engine.language.numbers.spelled import in_words

GRAMMAR = """
language: en
slots:
  box: {type: number, whole: true, max: 999}
  bay: {type: number, whole: true, max: 99}
  shelf: {type: number, whole: true, max: 9}
  dock: [A, B, C]
  times: {type: number, whole: true, max: 5}
  thing: {type: text, max_words: 2}
intents:
  bring:
    action: custom
    sentences: ["bring box {box} to (dock {dock}|bay {bay}|shelf {shelf} in bay {bay}) [{times} times]"]
  fetch: {action: custom, sentences: ["fetch box {box} (from dock {dock}|from bay {bay}|at dock {dock})"]}
  drive: {action: custom, sentences: ["drive to bay {bay}"]}
  moor: {action: custom, sentences: ["drive to dock {dock}"]}
  show: {action: custom, sentences: ["show {thing} to bay {bay}", "show {thing} to dock {dock}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("bring box five to bay three, no, to dock A", "bring box five to dock A"),
        ("bring box five to shelf two in bay three, sorry, to dock B", "bring box five to dock B"),
        ("bring box five to bay three two times, I mean to dock A", "bring box five to dock A two times"),
        ("bring box five to bay three no to bay four no to dock C", "bring box five to dock C"),
        ("fetch box five from bay three, no, from dock B", "fetch box five from dock B"),
        ("drive to bay seven, no, to dock B", "drive to dock B"),
        ("don't drive to bay seven but to dock B", "drive to dock B"),
    ],
)
def test_it_takes_the_place_of_what_began_so(engine: IntentEngine, said: str, meant: str) -> None:
    found = engine.parse(said)
    assert found.status is Status.ACCEPTED, found.reason
    assert found.actions == engine.parse(meant).actions


@pytest.mark.parametrize(
    ("said", "about"),
    [
        ("bring box five to bay three, no, four", "four"),
        ("drive to bay seven, I mean dock B", "dock b"),
        ("fetch box five from bay three, no, at dock B", "at dock b"),
        ("drive to bay seven, no, to dock D", "to dock d"),
        ("show a cup to bay seven, no, to dock B", "to dock b"),
    ],
)
def test_what_it_takes_the_place_of_is_asked_where_it_is_not_clear(engine: IntentEngine, said: str, about: str) -> None:
    found = engine.parse(said)
    assert not found.actions
    assert found.reason == f"it is not clear what {about!r} takes the place of; say the whole command again"


boxes, bays = st.integers(1, 999), st.integers(1, 99)


@given(boxes, bays, st.sampled_from("ABC"), st.sampled_from(["no", "sorry", "I mean"]))
def test_what_was_said_before_it_stays(engine: IntentEngine, box: int, bay: int, dock: str, corrects: str) -> None:
    box_said, bay_said = (" ".join(in_words([str(number)])) for number in (box, bay))
    found = engine.parse(f"bring box {box_said} to bay {bay_said}, {corrects}, to dock {dock}")
    assert [action.slots for action in found.actions] == [{"box": box, "dock": dock}]
