"""What shall not be done ends, if it is done."""

from __future__ import annotations

import threading

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import Executor, Goal, SimulatedRobot
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


class Cleaning:
    """A handler that drives by what it submits, which takes the place of its own goal."""

    def __init__(self, returns: bool) -> None:
        self.driving, self.resting, self.over = threading.Event(), threading.Event(), threading.Event()
        self.returns = returns
        self.driven: list[Goal] = []
        self.executor = Executor(SimulatedRobot(), handlers={"clean": self.clean, "tidy": self.tidy})

    def tidy(self, action: Custom) -> None:
        self.driven += self.executor.submit(LAB)

    def clean(self, action: Custom) -> None:
        self.driven += self.executor.submit(Move(0.5, 50.0, 100.0))
        self.driving.set()
        if not self.returns:
            assert self.resting.wait(30.0)
            self.driven += self.executor.submit(Move(0.5, 50.0, 100.0))
        self.over.set()


@pytest.mark.parametrize("asked", [LAB, Custom("tidy")], ids=["itself", "by another handler"])
@pytest.mark.parametrize("returns", [True, False])
@pytest.mark.parametrize(("denied", "stops"), [(LAB, True), (Custom("clean"), True), (HALL, False)], ids=str)
def test_what_a_handler_does_by_what_it_submits_is_denied_with_it(asked, returns, denied, stops):
    scene = Cleaning(returns)
    with scene.executor as executor:
        executor.submit(asked)
        assert scene.driving.wait(30.0)
        assert executor.deny(denied) is stops
        assert scene.driven[-1].done is stops
        assert asked is LAB or executor.deny(asked) is not stops
        scene.resting.set()
        assert scene.over.wait(30.0)


def test_a_handler_is_denied_between_two_drives_and_not_when_it_is_over(stage):
    said: list[bool] = []

    def clean(action):
        s.executor.submit(Move(0.5, 0.5, 1.0))[0].result()
        said.append(s.executor.deny(HALL))
        said.append(s.executor.deny(LAB))

    s = stage(handlers={"clean": clean})
    s.executor.submit(LAB)
    s.executor.run_until_idle()
    assert said == [False, True]
    assert not s.executor.deny(LAB)
