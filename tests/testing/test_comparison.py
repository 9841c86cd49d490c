"""What two meanings have to share, and how a difference is told."""

from __future__ import annotations

from dataclasses import replace

import pytest

from intent_engine.actions import Move, Stop
from intent_engine.interpretation import Interpretation, Status
from intent_engine.testing import assert_means, difference_table, differences, moves

TWO = Interpretation(
    "go two meters", Status.ACCEPTED, "move", {"direction": "forward", "distance": 2.0}, (Move(0.5, 2.0, 4.0),), 1.0
)


@pytest.mark.parametrize(
    ("change", "parts"),
    [
        ({}, []),
        ({"text": "Go two meters.", "confidence": 0.9, "reason": "heard otherwise"}, []),
        ({"slots": {"distance": 2, "direction": "forward"}}, []),
        ({"slots": {"direction": "forward", "distance": 2.0000001}}, []),
        ({"slots": {"direction": "forward", "distance": 2.1}}, ["slots.distance"]),
        ({"slots": {"direction": "forward"}}, ["slots.distance"]),
        ({"slots": {**TWO.slots, "speed": True}}, ["slots.speed"]),
        ({"intent": "drive"}, ["intent"]),
        ({"actions": (Move(0.4, 2.0, 5.0),)}, ["actions"]),
        ({"status": Status.REJECTED, "intent": None, "slots": {}, "actions": ()},
         ["status", "intent", "slots.direction", "slots.distance", "actions"]),
    ],
)  # fmt: skip
def test_what_counts_as_a_difference(change, parts):
    assert [row.part for row in differences(TWO, replace(TWO, **change))] == parts


def test_of_what_is_rejected_only_that_and_its_actions_count():
    rejected = Interpretation("don't go", Status.REJECTED)
    assert not differences(rejected, replace(rejected, intent="move", slots={"a": 1}, reason="negated"))
    assert [row.part for row in differences(rejected, TWO)] == ["status", "actions"]


def test_true_is_not_one():
    one, true = replace(TWO, slots={"count": 1}), replace(TWO, slots={"count": True})
    assert [row.part for row in differences(one, true)] == ["slots.count"]


def test_a_failure_is_a_table():
    with pytest.raises(AssertionError) as caught:
        assert_means(replace(TWO, slots={"direction": "backward"}), TWO)
    assert str(caught.value).splitlines() == [
        "'go two meters' is understood otherwise",
        "                 expected  found",
        "slots.direction  forward   backward",
        "slots.distance   2         (none)",
    ]
    assert difference_table(()) == "  expected  found"


def test_stopping_is_no_moving():
    assert moves(TWO)
    assert not moves(replace(TWO, actions=(Stop(),)))
    assert not moves(Interpretation("", Status.REJECTED))


@pytest.mark.parametrize(
    ("given", "instead"),
    [
        ("go two meters", "give engine.parse('go two meters')"),
        (TWO.to_json(), "give Interpretation.from_json(...) of it"),
        ({"direction": "forward"}, "compare slots with found.slots"),
        (TWO.actions, "compare actions with found.actions"),
        (TWO.actions[0], "compare actions with found.actions"),
        (None, "give what engine.parse(text) returns"),
    ],
)
def test_what_is_no_interpretation_is_told_what_to_give_instead(given, instead):
    for name, call in {
        "assert_means(found, expected) compares two Interpretations, but expected is": lambda: assert_means(TWO, given),
        "assert_means(found, expected) compares two Interpretations, but found is": lambda: assert_means(given, TWO),
        "differences(expected, found) compares two Interpretations, but found is": lambda: differences(TWO, given),
        "moves takes an Interpretation, not": lambda: moves(given),
    }.items():
        with pytest.raises(TypeError) as caught:
            call()
        assert str(caught.value).startswith(name)
        assert instead in str(caught.value)
