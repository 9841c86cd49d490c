"""Verdicts of single recordings, and scores of many."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.actions import Custom, Move, Stop, Turn
from intent_engine.evaluation.hearing import Act, Hearing
from intent_engine.evaluation.labels import Expected, Row, Step
from intent_engine.evaluation.sameness import same
from intent_engine.evaluation.scoring import Condition, Verdict, judge, quantile, score, wilson
from intent_engine.interpretation import Interpretation, Status

CONDITION = Condition("tiny.en")
FORWARD = Interpretation(
    "go forward 2 meters",
    Status.ACCEPTED,
    "move",
    {"direction": "forward", "distance": 2.0},
    (Move(0.5, 2.0, 4.0),),
    confidence=1.0,
)
LEFT = Interpretation("turn left", Status.ACCEPTED, "turn", {"side": "left"}, (Turn(0.75, 0.5, 1.5),), confidence=1.0)
BOTH = Interpretation(
    "go forward 2 meters and turn left",
    Status.ACCEPTED,
    "compound",
    {"steps": [{"intent": one.intent, "slots": one.slots} for one in (FORWARD, LEFT)]},
    FORWARD.actions + LEFT.actions,
)


def row(expected: Expected, text: str | None = None, speech_end: float | None = None) -> Row:
    return Row("row", 1, Path("a.wav"), expected, text, speech_end=speech_end)


def heard(*meanings: Interpretation, free: str | None = None, at: float = 2.0) -> Hearing:
    return Hearing(
        texts=[meaning.text for meaning in meanings],
        free_texts=[free if free is not None else meaning.text for meaning in meanings],
        meanings=list(meanings),
        acts=[Act(meaning, at, at - 0.25) for meaning in meanings if meaning.actions],
        decodes=[0.1],
    )


STOPPED, PAUSED = (
    Interpretation(intent, Status.ACCEPTED, intent, {}, (Stop(),), confidence=1.0) for intent in ("stop", "pause")
)
STOP_LABEL = Expected((Step("stop"),), actions=(Stop(),), stops=True)
FORWARD_LABEL = Expected((Step("move", {"distance": 2}),))


@pytest.mark.parametrize(
    ("expected", "meanings", "verdict"),
    [
        (FORWARD_LABEL, [FORWARD], Verdict.RIGHT),
        (FORWARD_LABEL, [LEFT], Verdict.WRONG),
        (FORWARD_LABEL, [FORWARD, LEFT], Verdict.WRONG),
        (FORWARD_LABEL, [], Verdict.MISSED),
        (FORWARD_LABEL, [Interpretation("hm", Status.REJECTED)], Verdict.MISSED),
        (FORWARD_LABEL, [Interpretation("hm", Status.REJECTED), FORWARD], Verdict.RIGHT),
        (Expected((Step("move", {"distance": 3}),)), [FORWARD], Verdict.WRONG),
        (Expected((Step("move", {"speed": 1.0}),)), [FORWARD], Verdict.WRONG),
        (Expected((Step("move", {"speed": None}),)), [FORWARD], Verdict.RIGHT),
        (Expected((Step("move"), Step("turn"))), [BOTH], Verdict.RIGHT),
        (Expected((Step("move"), Step("turn"))), [FORWARD, LEFT], Verdict.RIGHT),
        (Expected((Step("turn"), Step("move"))), [BOTH], Verdict.WRONG),
        (Expected(actions=(Move(0.5, 2.0, 4.0),)), [FORWARD], Verdict.RIGHT),
        (Expected(actions=(Move(0.5, 2.1, 4.2),)), [FORWARD], Verdict.WRONG),
        (Expected(actions=(Stop(),)), [FORWARD], Verdict.WRONG),
        (STOP_LABEL, [STOPPED], Verdict.RIGHT),
        (STOP_LABEL, [STOPPED, STOPPED], Verdict.RIGHT),
        (STOP_LABEL, [STOPPED, FORWARD], Verdict.WRONG),
        (STOP_LABEL, [STOPPED, PAUSED], Verdict.WRONG),
        (STOP_LABEL, [PAUSED], Verdict.WRONG),
        (FORWARD_LABEL, [FORWARD, FORWARD], Verdict.WRONG),
        (Expected(types=("move", "turn")), [BOTH], Verdict.RIGHT),
        (Expected(types=("move",)), [BOTH], Verdict.WRONG),
        (Expected(), [], Verdict.QUIET),
        (Expected(actions=()), [Interpretation("hm", Status.REJECTED)], Verdict.QUIET),
        (Expected(), [LEFT], Verdict.FALSE_ACCEPT),
    ],
)
def test_verdicts(expected, meanings, verdict):
    assert judge(row(expected), CONDITION, heard(*meanings)).verdict is verdict


@pytest.mark.parametrize(
    ("expected", "meanings", "unasked"),
    [
        (FORWARD_LABEL, [FORWARD], False),
        (FORWARD_LABEL, [], False),
        (FORWARD_LABEL, [LEFT], True),
        (FORWARD_LABEL, [FORWARD, STOPPED], True),
        (FORWARD_LABEL, [STOPPED], False),
        (Expected(), [STOPPED], False),
        (Expected(), [STOPPED, STOPPED], False),
        (Expected(), [FORWARD], True),
        (Expected(), [STOPPED, LEFT], True),
        (Expected(), [], False),
        (STOP_LABEL, [LEFT], True),
    ],
)
def test_a_stop_that_nobody_said_is_a_mistake_and_no_danger(expected, meanings, unasked):
    outcome = judge(row(expected), CONDITION, heard(*meanings))
    assert outcome.unasked is unasked
    assert score([outcome]).unasked == unasked


def test_latency_is_of_right_actions_alone_and_from_the_label_where_it_says():
    assert judge(row(FORWARD_LABEL), CONDITION, heard(FORWARD)).latency == pytest.approx(0.25)
    assert judge(row(FORWARD_LABEL, speech_end=1.6), CONDITION, heard(FORWARD)).latency == pytest.approx(0.4)
    assert judge(row(FORWARD_LABEL), CONDITION, heard(LEFT)).latency is None


def test_slots_are_counted_one_by_one():
    expected = Expected((Step("move", {"distance": 2, "direction": "backward"}),))
    outcome = judge(row(expected), CONDITION, heard(FORWARD))
    assert (outcome.slots, outcome.slots_right) == (2, 1)
    outcome = judge(row(expected), CONDITION, heard(LEFT))
    assert (outcome.slots, outcome.slots_right) == (2, 0)


LIFT = Interpretation(
    "lift the bucket",
    Status.ACCEPTED,
    "lift",
    {"tool": "bucket"},
    (Custom("lift", {"tool": "bucket", "way": "up"}),),
    confidence=1.0,
)


@pytest.mark.parametrize(
    ("slots", "right"),
    [
        ({"way": "up"}, 1),
        ({"way": "down"}, 0),
        ({"way": None}, 1),
        ({"tool": "bucket", "way": "up"}, 2),
        ({"tool": "arm"}, 0),
    ],
)
def test_what_a_command_takes_unsaid_may_be_labelled_too(slots, right):
    """The label of a person, who may not know which slots a sentence says: "lift the bucket" lifts it up."""
    outcome = judge(row(Expected((Step("lift", slots),))), CONDITION, heard(LIFT))
    assert outcome.slots_right == right
    assert outcome.verdict is (Verdict.RIGHT if right == len(slots) else Verdict.WRONG)


@pytest.mark.parametrize(
    ("one", "other", "equal"),
    [
        (0.61, 0.6096, True),
        (2, 2.0, True),
        (2.0, 2.1, False),
        (True, 1, False),
        ("Living Room", "living room", True),
        ("bay 3", "bay three", True),
        ("kitchen", "chicken", False),
        ("yellow tool box", "yellow toolbox", True),
        ("tool box", "box", False),
        ("", "", True),
        ("?", "!", False),
        (None, None, True),
        (None, 0.0, False),
        ({"a": 1}, {"a": 1.0}, True),
        ({"a": 1}, {"a": 1, "b": 2}, False),
    ],
)
def test_values_that_say_the_same(one, other, equal):
    assert same(one, other) is equal
    assert same(other, one) is equal


def test_a_score():
    outcomes = [
        judge(row(FORWARD_LABEL, "go forward two meters"), CONDITION, heard(FORWARD, free="Go, for what, 2 meters?")),
        judge(row(FORWARD_LABEL, "go forward two meters"), CONDITION, heard()),
        judge(row(FORWARD_LABEL), CONDITION, heard(LEFT)),
        judge(row(Expected(), ""), CONDITION, heard(LEFT)),
        judge(row(Expected()), CONDITION, heard()),
    ]
    found = score(outcomes)
    assert (found.commands, found.right, found.wrong, found.missed) == (3, 1, 1, 1)
    assert (found.others, found.false_accepts) == (2, 1)
    assert found.accuracy == pytest.approx(1 / 3)
    assert found.slot_accuracy == pytest.approx(1 / 3)
    # Four of eight words were not heard at all; "2" and "two" are the same word.
    assert found.word_error_rate == pytest.approx(4 / 8)
    assert found.free_word_error_rate == pytest.approx((4 + 2) / 8)
    assert found.latency_p50 == found.latency_max == pytest.approx(0.25)
    assert found.to_json()["noise"] == "none"


def test_a_score_of_talk_alone_has_no_accuracy():
    found = score([judge(row(Expected()), Condition("base", 6.0), heard())])
    assert (found.accuracy, found.latency_p50, found.word_error_rate) == (None, None, None)
    assert (found.model, found.noise) == ("base", "6 dB")
    with pytest.raises(ValueError, match="nothing"):
        score([])


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=30), st.floats(0, 1))
def test_a_quantile_is_a_value_that_was_measured(values, share):
    found = quantile(values, share)
    assert found in values
    assert sum(value <= found for value in values) >= share * len(values) - 1e-9
    assert quantile(values, 1.0) == max(values)


@given(st.integers(1, 500), st.data())
def test_the_interval_holds_the_share_and_narrows_with_more_recordings(whole, data):
    right = data.draw(st.integers(0, whole))
    low, high = wilson(right, whole)
    assert 0 <= low <= right / whole <= high <= 1
    wider = wilson(right, whole)
    narrower = wilson(right * 4, whole * 4)
    assert narrower[1] - narrower[0] < wider[1] - wider[0]


def test_the_interval_of_nine_in_ten():
    # Newcombe, Statistics in Medicine 17 (1998), method 3.
    assert wilson(9, 10) == (pytest.approx(0.5958, abs=1e-4), pytest.approx(0.9821, abs=1e-4))


def test_a_hold_is_counted_where_nobody_knows_when_the_word_ended_and_is_no_time():
    """Nothing was acted on, and the label does not say it: no time is not a time of 0 ms."""
    unknown = judge(row(STOP_LABEL), CONDITION, Hearing(holds=[1.5]))
    assert (unknown.held, unknown.held_at) == (None, 1.5)
    labelled = judge(row(STOP_LABEL, speech_end=1.25), CONDITION, Hearing(holds=[1.5]))
    acted_on = judge(row(STOP_LABEL), CONDITION, Hearing(holds=[1.5], acts=[Act(STOPPED, 2.0, 1.0)]))
    talk = judge(row(Expected()), CONDITION, Hearing(holds=[1.5]))
    assert (labelled.held, acted_on.held, talk.held) == (0.25, 0.5, None)
    found = score([unknown, labelled, acted_on, talk, judge(row(STOP_LABEL), CONDITION, Hearing())])
    assert (found.stops, found.stops_held, found.others_held) == (4, 3, 1)
    assert (found.held_p50, found.held_p90) == (0.25, 0.5)
