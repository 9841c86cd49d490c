"""A robot that hangs in a call, and somebody who speaks to it: stop is heard all the same."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from continuing_stage import ENGINE, Frames, Parts, Voiced, framed

from intent_engine import Executor, GoalState, Reason, Runtime, SimulatedRobot
from intent_engine.actions import Custom, Move
from intent_engine.execution.clock import MonotonicClock, VirtualClock
from intent_engine.execution.failsafe import HANGS
from intent_engine.runtime import Heard, HeardKind
from intent_engine.runtime.hands import Hands
from intent_engine.speech.audio import SAMPLE_RATE

NEAR = Move(0.5, 0.01, 0.02)


class Hanging(SimulatedRobot):
    """Hangs in the first velocity that it is to write, until it is let go."""

    def __init__(self) -> None:
        super().__init__(MonotonicClock())
        self.go = threading.Event()
        self.written: list[float] = []
        self.stops = 0

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        if linear and not self.go.is_set():
            self.go.wait(30.0)
        self.written.append(linear)
        super().velocity(linear, angular, valid_for)

    def stop(self) -> None:
        self.stops += 1
        super().stop()


@pytest.fixture
def robot():
    made = Hanging()
    yield made
    made.go.set()


@pytest.fixture
def executor(robot, monkeypatch):
    monkeypatch.setattr(Hands, "PATIENCE", 0.2)
    with Executor(robot, handle_sigterm=False) as made:
        made._books.ANSWER = made._books.LATER = 0.01
        yield made


def test_it_is_stopped_and_a_stop_that_is_said_later_is_heard(robot, executor):
    events: list[Heard] = []
    voice = Voiced((0.5, 1.0), (2.5, 3.0), (4.5, 5.0))
    hears = Parts("go forward one meter", "turn left", "stop")
    runtime = Runtime(ENGINE, executor, hears, voice=voice, noise_filter=None, on_event=events.append)
    runtime.join_sentences(False)
    runtime.run(Frames(framed(np.zeros(6 * SAMPLE_RATE, np.float32))))
    assert [event.detail for event in events if event.kind is HeardKind.ERROR] == [HANGS]
    done = [event for event in events if event.kind is HeardKind.SUBMITTED]
    assert [event.interpretation.text for event in done] == ["turn left", "stop"]
    assert [(goal.state, goal.reason) for goal in done[0].goals] == [(GoalState.REJECTED, Reason.ROBOT_ERROR)]
    assert robot.stops >= 2
    robot.go.set()
    assert executor.wait(timeout=30.0)
    assert robot.speed() == (0.0, 0.0)
    assert executor.submit(NEAR)[0].result(30.0).succeeded


def test_what_a_robot_does_that_answers_is_returned_and_what_is_raised_is_raised(executor, robot):
    robot.go.set()
    hands = Hands(executor, stepped=False)
    (goal,) = hands.submit([NEAR])
    assert goal.result(30.0).succeeded
    assert hands.release()
    with pytest.raises(ValueError, match="policy"):
        hands.submit([NEAR], policy="maybe")


def test_a_release_that_hangs_is_told(executor, robot):
    robot.go.set()
    executor.submit(Move(0.5, 50.0, 100.0))
    executor.hold()
    robot.go.clear()
    hands = Hands(executor, stepped=False)
    assert not hands.release()
    robot.go.set()


def test_what_a_handler_asks_for_is_its_own(robot, executor):
    """The handler makes way, and what it asks for through them afterwards is refused, as without them."""
    robot.go.set()
    hands = Hands(executor, stepped=False)
    asked: list[str] = []
    taken, told, over = threading.Event(), threading.Event(), threading.Event()

    def handler(action: Custom) -> None:
        taken.set()
        told.wait(30.0)
        asked.extend(goal.reason for goal in hands.submit([NEAR]))
        over.set()

    executor.register("wave", handler)
    executor.submit(Custom("wave"))
    assert taken.wait(30.0)
    executor.submit(NEAR)
    told.set()
    assert over.wait(30.0)
    assert asked == [Reason.PREEMPTED]


def test_on_a_virtual_clock_it_is_done_in_the_same_thread():
    clock = VirtualClock()
    threads: list[str] = []

    class Curious(SimulatedRobot):
        def velocity(self, linear: float, angular: float, valid_for: float) -> None:
            threads.append(threading.current_thread().name)
            super().velocity(linear, angular, valid_for)

    with Executor(Curious(clock), clock=clock) as executor:
        hands = Hands(executor, stepped=True)
        (goal,) = hands.submit([NEAR])
        executor.wait()
        assert goal.succeeded
    assert set(threads) == {threading.current_thread().name}
