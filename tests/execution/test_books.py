"""A stop that has to wait for the lock, and what another thread makes of the time until it has it."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

from intent_engine.actions import Custom, Move, Navigate
from intent_engine.execution.events import EventKind
from intent_engine.execution.executor import Executor
from intent_engine.execution.gate import Gate
from intent_engine.execution.goal import Goal, GoalState, Reason
from intent_engine.execution.robots.robot import Pose, TaskState
from intent_engine.execution.robots.simulated import SimulatedRobot

FORWARD = Move(0.5, 50.0, 100.0)


class Journey:
    """A task that ends when the robot answers at last; until then the question hangs."""

    reason = ""
    progress = None

    def __init__(self) -> None:
        self.hanging, self.asked, self.go = threading.Event(), threading.Event(), threading.Event()

    @property
    def state(self) -> TaskState:
        if not self.hanging.is_set():
            return TaskState.RUNNING
        self.asked.set()
        self.go.wait(30.0)
        return TaskState.SUCCEEDED

    def add_done_callback(self, callback: object) -> None:
        pass


class Slow(SimulatedRobot):
    def __init__(self) -> None:
        super().__init__()
        self.written: list[float] = []
        self.journeys: list[Journey] = []

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        self.written.append(linear)

    def navigate(self, goal: Pose) -> Journey:
        self.journeys.append(Journey())
        return self.journeys[-1]


def hang(executor: Executor, robot: Slow, *then: object) -> list[Goal]:
    """A navigation and what comes after it; the robot hangs in the first, with the executor's lock held."""
    goals = executor.submit([Navigate("kitchen", 5.0, 2.0, 0.0), *then])
    robot.journeys[0].hanging.set()
    assert robot.journeys[0].asked.wait(30.0)
    return goals


@pytest.fixture
def robot():
    return Slow()


@pytest.fixture
def executor(robot):
    done: list[Custom] = []
    with Executor(robot, handlers={"wave": done.append}, handle_sigterm=False) as made:
        made.waved = done
        yield made


@pytest.mark.parametrize(
    "then", [FORWARD, Navigate("dock", 1.0, 0.0, 0.0), Custom("wave")], ids=["motion", "task", "handler"]
)
def test_nothing_begins_between_a_stop_that_could_not_wait_and_its_entry(executor, robot, then):
    executor._books.LATER = 0.0
    goals = hang(executor, robot, then)
    executor.stop()
    robot.journeys[0].go.set()
    assert goals[1].result(30.0).reason is Reason.STOP
    assert goals[1].times.started is None
    assert not any(robot.written)
    assert (len(robot.journeys), executor.waved) == (1, [])
    assert executor.submit(Move(0.5, 0.01, 0.02))[0].result(30.0).succeeded


@pytest.mark.parametrize("command", ["stop", "hold"])
def test_nothing_begins_while_a_stop_or_a_hold_waits_for_the_lock(executor, robot, command):
    executor._books.LATER = 30.0
    goals = hang(executor, robot, FORWARD)
    past_the_lock = threading.Event()
    robot.stop = past_the_lock.set
    thread = threading.Thread(target=getattr(executor, command))
    thread.start()
    assert past_the_lock.wait(30.0)
    robot.journeys[0].go.set()
    thread.join(30.0)
    assert not any(robot.written)
    assert goals[1].times.started is None
    if command == "hold":
        assert goals[1].state is GoalState.ACCEPTED
        executor.release()
        assert goals[1].state is GoalState.EXECUTING


def interrupted(*arguments: object, **options: object) -> bool:
    raise KeyboardInterrupt


def test_a_stop_that_is_broken_off_is_entered_all_the_same(executor, robot, monkeypatch):
    (goal,) = executor.submit(FORWARD)
    lock = executor._books.lock

    class Interrupted:
        acquire = staticmethod(interrupted)

    with lock:
        monkeypatch.setattr(executor._books, "lock", Interrupted())
        with pytest.raises(KeyboardInterrupt):
            executor._books.stop(Reason.STOP, EventKind.STOP)
        monkeypatch.setattr(executor._books, "lock", lock)
    executor._books.poke()
    assert goal.result(30.0).reason is Reason.STOP


def drives(gate: Gate, robot: Slow) -> bool:
    before = len(robot.written)
    gate.velocity(0.5, 0.0, 0.3)
    return len(robot.written) > before


def test_a_gate_opens_only_when_every_stop_on_its_way_is_entered(robot):
    gate = Gate(robot)
    first, second = object(), object()
    gate.keep_shut(first)
    gate.keep_shut(second)
    settled: list[Callable[[], None]] = [lambda: gate.entered(first), lambda: gate.entered(second)]
    for settle in settled:
        assert not gate.open()
        assert not drives(gate, robot)
        settle()
    assert not drives(gate, robot)
    assert gate.open()
    assert drives(gate, robot)
