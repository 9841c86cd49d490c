"""A robot that hangs in a call: who asks for something is answered, and nothing but a stop is done until it is back."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest

from intent_engine.actions import Custom, Move, Navigate, Stop
from intent_engine.errors import RobotError
from intent_engine.execution.events import Event, EventKind
from intent_engine.execution.executor import Executor
from intent_engine.execution.failsafe import HANGS
from intent_engine.execution.goal import Goal, GoalState, Reason
from intent_engine.execution.robots.robot import Pose, Task
from intent_engine.execution.robots.simulated import SimulatedRobot

KITCHEN = Navigate("kitchen", 0.02, 0.0, 0.0)
THEN = Move(0.5, 0.02, 0.04)
NEAR = Move(0.5, 0.01, 0.02)


class Hanging(SimulatedRobot):
    """Hangs when it is to navigate, until it is let go."""

    def __init__(self) -> None:
        super().__init__()
        self.asked, self.go = threading.Event(), threading.Event()
        self.stops = 0

    def navigate(self, goal: Pose) -> Task:
        self.asked.set()
        self.go.wait(30.0)
        return super().navigate(goal)

    def stop(self) -> None:
        self.stops += 1
        super().stop()


class Stage:
    """An executor whose robot hangs in a call that another thread has made."""

    def __init__(self) -> None:
        self.robot = Hanging()
        self.events: list[Event] = []
        self.executor = Executor(self.robot, on_event=self.events.append, handle_sigterm=False)
        self.executor._books.ANSWER = self.executor._books.LATER = 0.01
        self.goals: list[Goal] = []
        self._thread = threading.Thread(target=self._submit)
        self._thread.start()
        assert self.robot.asked.wait(30.0)

    def _submit(self) -> None:
        self.goals = self.executor.submit([KITCHEN, THEN])

    def comes_back(self) -> None:
        self.robot.go.set()
        self._thread.join(30.0)
        assert self.executor.wait(timeout=30.0)

    def errors(self) -> list[str]:
        assert self.executor.settle(30.0)
        return [event.detail for event in self.events if event.kind is EventKind.ERROR]


@pytest.fixture
def stage() -> Iterator[Stage]:
    made = Stage()
    yield made
    made.robot.go.set()
    made.executor.close()


def test_a_command_is_refused_and_what_hangs_goes_on_when_it_is_back(stage):
    refused = stage.executor.submit([NEAR, NEAR])
    assert [(goal.state, goal.reason, goal.detail) for goal in refused] == [
        (GoalState.REJECTED, Reason.ROBOT_ERROR, HANGS)
    ] * 2
    assert stage.robot.stops == 0
    stage.comes_back()
    assert stage.goals[0].succeeded
    assert stage.executor.submit(NEAR)[0].result(30.0).succeeded


def test_listeners_hear_of_what_is_refused_and_once_that_it_hangs(stage):
    for _ in range(3):
        stage.executor.submit(NEAR)
    assert stage.errors() == [HANGS]
    told = [event.state for event in stage.events if event.goal is not None and event.goal.action == NEAR]
    assert told == [GoalState.PENDING, GoalState.REJECTED] * 3
    stage.comes_back()
    stage.executor.stop()
    stage.robot.asked.clear()
    stage.robot.go.clear()
    thread = threading.Thread(target=stage.executor.submit, args=([KITCHEN],))
    thread.start()
    assert stage.robot.asked.wait(30.0)
    stage.executor.submit(NEAR)
    assert stage.errors() == [HANGS] * 2, "the second time is another"
    stage.robot.go.set()
    thread.join(30.0)


def test_of_a_sentence_that_begins_with_a_stop_that_is_done(stage):
    stop, near = stage.executor.submit([Stop(), NEAR])
    assert (stop.state, near.state) == (GoalState.SUCCEEDED, GoalState.REJECTED)
    assert stage.robot.stops
    stage.comes_back()
    assert [goal.reason for goal in stage.goals] == [Reason.STOP] * 2


def test_it_can_be_asked_how_things_stand(stage):
    now = stage.executor.snapshot()
    assert (now.hangs, now.pose) == (True, None)
    assert now.goal is not None
    assert now.goal.action == KITCHEN
    assert not stage.executor.idle
    assert stage.robot.stops == 0
    stage.comes_back()
    assert not stage.executor.snapshot().hangs
    assert stage.executor.snapshot().pose is not None


@pytest.mark.parametrize("command", ["hold", "pause", "cancel", "deny"])
def test_what_brings_a_robot_to_rest_stops_one_that_hangs(stage, command):
    goal = stage.executor.snapshot().goal
    arguments = {"cancel": [goal], "deny": [Custom("dance")]}.get(command, [])
    answer = getattr(stage.executor, command)(*arguments)
    assert stage.robot.stops
    assert answer is (True if command == "deny" else None)
    stage.comes_back()
    assert [goal.state for goal in stage.goals] == [GoalState.CANCELED] * 2
    now = stage.executor.snapshot()
    assert (now.held, now.paused) == (False, False)
    assert stage.executor.submit(NEAR)[0].result(30.0).succeeded


@pytest.mark.parametrize("command", ["release", "resume"])
def test_what_lets_a_robot_go_on_does_nothing_to_one_that_hangs(stage, command):
    getattr(stage.executor, command)()
    assert stage.robot.stops == 0
    assert stage.errors() == [HANGS]
    stage.comes_back()
    assert stage.goals[0].succeeded


def test_an_emergency_stop_is_not_ended_while_it_hangs(stage):
    stage.executor.estop()
    with pytest.raises(RobotError, match="has not come back"):
        stage.executor.reset()
    assert stage.executor.estopped
    stage.comes_back()
    stage.executor.reset()
    assert not stage.executor.estopped
