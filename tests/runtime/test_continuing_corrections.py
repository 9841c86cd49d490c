"""What is said right after a command takes it back, and says what is meant instead."""

from __future__ import annotations

import pytest
from continuing_stage import Said, SaidInParts, Script
from speech_stage import ROOT

from intent_engine.engine import IntentEngine
from intent_engine.execution.goal import GoalState
from intent_engine.runtime import HeardKind

ORDERS = IntentEngine.from_files(ROOT / "examples" / "coffee" / "coffee.yaml")


def test_a_correction_that_comes_later_is_done():
    said = Said(Script("go to the kitchen", "i mean the bedroom", "go to the kitchen, i mean the bedroom"))
    assert (said.pose.x, said.pose.y) == pytest.approx((2.0, 8.0))


def test_a_correction_that_was_heard_clearly_needs_no_model_that_searches_for_it():
    said = Said(Script("go to the kitchen", "i mean the bedroom", "get to the kitchen in the bedroom"))
    assert (said.pose.x, said.pose.y) == pytest.approx((2.0, 8.0))
    hardly = Said(Script("go to the kitchen", "i mean the bedroom", "get to the kitchen in the bedroom", score=-1.0))
    assert hardly.goals == [GoalState.CANCELED]


def test_where_it_begins_with_a_no_it_takes_something_back_or_is_not_done():
    """ "No" is heard as "know", and "no, the dock" as "and go to the dock"."""
    for second in ("no the duck", "know the duck"):
        said = Said(Script("go to the lounge", second, "go to the lounge and go to the dock"))
        assert said.goals == [GoalState.CANCELED]
    said = Said(Script("go to the lounge", "know the duck", "go to the lounge no the dock"))
    assert said.goals == [GoalState.CANCELED, GoalState.SUCCEEDED]
    assert said.pose.x == pytest.approx(10.0)


def test_a_no_and_what_is_meant_instead_may_come_one_after_the_other():
    kitchen, dock = "go to the kitchen", "go to the kitchen no the dock"
    said = SaidInParts(kitchen, "no", "go to the kitchen no", "the dock", dock)
    assert said.goals == [GoalState.CANCELED, GoalState.SUCCEEDED]
    assert said.pose.x == pytest.approx(10.0)


@pytest.mark.parametrize(
    "last",
    [
        ("the dock", "go to the kitchen the dock"),  # the "no" was not heard again
        ("what a nice day", "go to the kitchen no what a nice day"),
        ("slowly", "go to the kitchen no slowly"),
    ],
)
def test_what_was_taken_back_is_not_begun_again(last):
    said = SaidInParts("go to the kitchen", "no", "go to the kitchen no", *last)
    assert said.goals == [GoalState.CANCELED]
    assert said.pose.x < 4.9


def test_a_no_that_is_only_heard_with_the_command_takes_it_back():
    said = SaidInParts("go to the kitchen", "oh", "go to the kitchen no", "")
    assert said.goals == [GoalState.CANCELED]


def test_a_no_takes_it_back_even_if_what_is_meant_instead_is_not_understood():
    said = Said(Script("go forward ten meters", "no the dog", "go forward ten meters no the dog"))
    assert said.goals == [GoalState.CANCELED]
    assert said.pose.x < 2.0
    told = [event.interpretation for event in said.events if event.kind is HeardKind.INTERPRETATION]
    assert "taken back" in told[-1].reason
    hardly = Said(Script("go forward ten meters", "no the dog", "go forward ten meters no the dog", score=-2.0))
    assert hardly.pose.x == pytest.approx(10.0)


def test_a_command_of_a_program_that_is_done_is_corrected_by_another():
    """What it did stays done: only the program knows what would undo it."""
    said = Said(
        Script("i'd like a small latte", "no a large one", "i'd like a small latte no a large one"), engine=ORDERS
    )
    assert [order["size"] for order in said.orders] == ["small", "large"]
