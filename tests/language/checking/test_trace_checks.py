"""Words that may be numbers by their sound, and where nobody means them so."""

from __future__ import annotations

import math

import pytest
from meanings import shipped

from intent_engine.actions import Move, Turn


@pytest.mark.parametrize(
    ("heard", "metres"),
    [("go forward to meters", 2), ("go back for meters", -4), ("move ate meters", 8), ("go forward too feet", 0.6096)],
)
def test_a_number_by_its_sound_is_as_sure_where_its_unit_follows(heard: str, metres: float) -> None:
    found = shipped().parse(heard)
    (action,) = found.actions
    assert isinstance(action, Move)
    assert math.copysign(action.distance or 0.0, action.linear_velocity) == pytest.approx(metres)
    assert found.confidence == 1.0


@pytest.mark.parametrize(
    "heard", ["turn right to twenty degrees", "go forward for to", "turn left to", "back to forty meters"]
)
def test_what_only_leads_to_a_number_is_none(heard: str) -> None:
    assert shipped().parse(heard).actions == ()


@pytest.mark.parametrize(
    "heard",
    [
        "turn left four five degrees",
        "turn left 4 5 degrees",
        "move four five meters",
        "turn left four five",
        "turn two five degrees to the right",
    ],
)
def test_the_first_of_two_digits_is_no_word_that_leads_to_the_other(heard: str) -> None:
    assert not shipped().parse(heard).actions


def test_a_digit_before_a_larger_number_may_be_such_a_word() -> None:
    (action,) = shipped().parse("turn right four 20 degrees").actions
    assert isinstance(action, Turn)
    assert math.degrees(action.angle) == pytest.approx(-20)


def test_a_last_word_is_no_number_where_the_sentence_may_have_broken_off(engine_of) -> None:
    count = engine_of(
        "slots: {n: number}\nintents: {count: {action: custom, sentences: ['count {n}', 'count {n} cups']}}"
    ).matcher()
    assert count.read(["count", "two"], loose=True)
    assert count.read(["count", "to", "cups"], loose=True)
    assert not count.read(["count", "to"], loose=True)


def test_where_more_of_a_number_follows_it_is_less_sure() -> None:
    assert shipped().parse("go forward to hundred meters").confidence < 1.0


WAVE = """
slots:
  person: {type: text, max_words: 2}
  times: {type: number, min: 1, max: 10}
intents:
  wave: {action: custom, sentences: ["wave [(at|to) [my] {person}] [{times} times]"]}
"""


@pytest.mark.parametrize("heard", ["wave two times once", "wave two point five", "wave two seven times"])
def test_no_number_is_taken_for_a_word_before_free_text_that_what_belongs_to_it_would_be(engine_of, heard) -> None:
    assert not engine_of(WAVE).parse(heard).actions


@pytest.mark.parametrize("heard", ["wave two my friend", "wave two anna three times"])
def test_but_it_is_where_as_a_number_it_leads_nowhere(engine_of, heard) -> None:
    assert engine_of(WAVE).parse(heard).reason == f"read as '{heard.replace('two', 'to')}'"


@pytest.mark.parametrize(
    ("said", "readings"), [("7", 1), ("seven", 1), ("7 and 8", 0), ("7.5", 0), ("minus seven", 0), ("-7", 0)]
)
def test_the_number_of_a_name_is_one_whole_number(engine_of, said, readings) -> None:
    matcher = engine_of("intents: {open: {action: custom, sentences: ['open drawer {#}']}}").matcher()
    assert len(matcher.read(["open", "drawer", *said.split()])) == readings


@pytest.mark.parametrize(
    ("heard", "values"),
    [
        ("track three five times", {"times": 5}),
        ("track 3 5 times", {"times": 5}),
        ("track twenty five times", None),
        ("track 2.5 seconds", None),
        ("track two point five seconds", None),
        ("track two hundred five times", None),
        ("track twenty five six times", {"times": 6}),
        ("track three a minute and a half", {"span": 90}),
    ],
)
def test_a_number_of_a_name_takes_nothing_from_the_one_behind_it(engine_of, heard, values) -> None:
    player = engine_of(
        "slots: {times: {type: number, max: 99}, span: duration}\n"
        "intents: {play: {action: custom, sentences: ['track {#} {times} times', 'track {#} {span}']}}"
    )
    found = player.parse(heard)
    assert (dict(found.slots) if found.actions else None) == values
