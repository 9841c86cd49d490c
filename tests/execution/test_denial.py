"""What shall not be done ends, if it is done."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import Executor, SimulatedRobot
from intent_engine.actions import Action, Custom, Move, Navigate, Pick, Place, Turn
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.denial import denies
from intent_engine.execution.goal import Reason

LAB, HALL = Custom("clean", {"room": "lab"}), Custom("clean", {"room": "hall"})
ACTIONS = [
    *(LAB, HALL, Custom("clean"), Custom("water", {"room": "lab"}), Pick("cup"), Pick("ball"), Place("cup", "table")),
    *(Place(), Place("cup"), Move(0.5, 1.0, 2.0), Turn(1.0, 0.5, 2.0), Navigate("lab", 1.0, 2.0, 0.0)),
]


@pytest.mark.parametrize("action", ACTIONS, ids=str)
def test_an_action_denies_itself(action):
    assert denies(action, action)


@pytest.mark.parametrize(
    ("denied", "done", "expected"),
    [
        (Custom("clean"), LAB, True),
        (Custom("clean", {"room": None}), LAB, True),
        (LAB, Custom("clean", {"room": "lab", "times": 2.0}), True),
        (Place("cup"), Place("cup", "table"), True),
        (Place(), Place("cup", "table"), True),
        (LAB, Custom("clean"), False),
        (LAB, HALL, False),
        (LAB, Custom("water", {"room": "lab"}), False),
        (Place("cup", "shelf"), Place("cup", "table"), False),
        (Pick("cup"), Pick("ball"), False),
        (Pick("cup"), Place("cup"), False),
    ],
    ids=str,
)
def test_what_was_said_of_it_must_be_so(denied, done, expected):
    assert denies(denied, done) is expected


@given(
    st.lists(st.sampled_from([Turn(2.0, 0.5, 4.0), Move(0.5, 1.0, 2.0), Move(-0.5, 1.0, 2.0)]), min_size=1, max_size=4),
    st.sampled_from(ACTIONS),
)
def test_all_stops_if_it_is_done_or_waits_its_turn_and_nothing_else_does(doing: list[Action], denied: Action):
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        goals = executor.submit(Move(0.5, 5.0, 10.0))
        goals += executor.submit(doing, policy="queue")
        clock.advance(1.0)
        stopped = executor.deny(denied)
        assert stopped is any(denies(denied, goal.action) for goal in goals)
        assert all(goal.reason is Reason.STOP for goal in goals) is stopped
        assert executor.idle is stopped
        if stopped:
            assert executor.snapshot().velocity == (0.0, 0.0)


def test_nothing_is_denied_of_a_robot_that_does_nothing():
    with Executor(SimulatedRobot(clock := VirtualClock()), clock=clock) as executor:
        assert not executor.deny(ACTIONS)
        assert not executor.deny(())


def test_what_is_no_action_is_refused():
    with (
        Executor(SimulatedRobot(clock := VirtualClock()), clock=clock) as executor,
        pytest.raises(TypeError, match="deny takes actions"),
    ):
        executor.deny("clean")


def test_listeners_are_told_of_what_nobody_here_does():
    told = []
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock, on_event=told.append) as executor:
        executor.deny(())
        assert told == []
        executor.deny([LAB, HALL])
        assert [event.to_json() for event in told] == [
            {
                "event": "deny",
                "time": 0.0,
                "denied": [{"type": "custom", "name": "clean", "slots": {"room": room}} for room in ("lab", "hall")],
            }
        ]
