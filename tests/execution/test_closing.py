"""Closing an executor: of a robot that hangs, of one that exits in its stop, and what may be asked of it afterwards."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys
import threading

import pytest

from intent_engine import Executor, Goal, GoalState, Move, Reason
from intent_engine.execution.clock import VirtualClock
from intent_engine.testing import RecordingRobot

LONG = Move(0.5, 50.0, 100.0)


class Hanging(RecordingRobot):
    """Hangs in its first velocity until it is told to go on."""

    def __init__(self) -> None:
        super().__init__()
        self.asked, self.go = threading.Event(), threading.Event()

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        if linear and not self.asked.is_set():
            self.asked.set()
            self.go.wait(30.0)
        super().velocity(linear, angular, valid_for)


def test_a_robot_that_hangs_is_not_waited_for_and_its_goal_ends_when_it_answers():
    robot = Hanging()
    executor = Executor(robot, handle_sigterm=False)
    executor._books.LATER = executor._books.CLOSING = 0.01
    goals = []
    submitting = threading.Thread(target=lambda: goals.extend(executor.submit(LONG)), daemon=True)
    submitting.start()
    assert robot.asked.wait(30.0)
    closing = threading.Thread(target=executor.close, daemon=True)
    closing.start()
    closing.join(30.0)
    assert not closing.is_alive()
    executor.close()
    robot.go.set()
    submitting.join(30.0)
    goals[0].future().result(30.0)
    assert (goals[0].state, goals[0].reason) == (GoalState.CANCELED, Reason.CLOSED)
    assert robot.at_rest


def _awaited(executor: Executor) -> Goal:
    async def program() -> Goal:
        return await asyncio.wait_for(executor.submit(LONG)[0], 30.0)

    return asyncio.run(program())


def test_a_goal_that_is_rejected_by_a_closed_executor_can_be_awaited():
    executor = Executor(RecordingRobot(), handle_sigterm=False)
    executor.close()
    assert _awaited(executor).reason is Reason.CLOSED
    executor.subscribe(lambda event: None)
    assert _awaited(executor).reason is Reason.CLOSED
    assert executor.submit(LONG)[0].future().result(30.0).reason is Reason.CLOSED


CHILD = """
import asyncio, os, threading
from intent_engine import Executor, Move, SimulatedRobot
executor = Executor(SimulatedRobot(), handle_sigterm=False)
held, go = threading.Event(), threading.Event()
def hold():
    with executor._books.lock:
        held.set()
        go.wait()
threading.Thread(target=hold).start()
held.wait()
async def program():
    return (await executor.submit(Move(0.5, 1.0, 2.0))[0]).reason
if os.fork() == 0:
    print(asyncio.run(program()), executor.wait(), executor.snapshot().closed, flush=True)
    executor.close()
    os._exit(0)
os.wait()
go.set()
executor.close()
"""


def test_a_child_that_was_forked_while_the_lock_was_held_is_answered():
    if not hasattr(os, "fork"):  # Windows: there is no such child, and the executor asks to be told of none
        assert not hasattr(os, "register_at_fork")
        return
    done = subprocess.run([sys.executable, "-c", CHILD], capture_output=True, text=True, timeout=30, check=True)
    assert done.stdout == "closed True True\n"


@pytest.mark.parametrize("error", [SystemExit, KeyboardInterrupt])
@pytest.mark.parametrize("end", ["stop", "estop", "close"])
def test_what_breaks_a_robots_stop_off_in_the_main_thread_leaves_no_goal_behind(error, end):
    clock = VirtualClock()
    robot = RecordingRobot(clock)
    executor = Executor(robot, clock=clock, handle_sigterm=False)
    goals = executor.submit([LONG, LONG])
    clock.advance(1.0)
    stop = robot.stop

    def broken_off() -> None:
        robot.stop = stop
        raise error

    robot.stop = broken_off
    with pytest.raises(error):
        getattr(executor, end)()
    reason = Reason.CLOSED if end == "close" else Reason(end)
    assert [(goal.state, goal.reason) for goal in goals] == [(GoalState.CANCELED, reason)] * 2
    executor.close()
    assert robot.at_rest
    Executor(robot, clock=clock, handle_sigterm=False).close()  # nobody drives it any more


def test_what_ends_in_the_instant_of_closing_can_be_waited_for():
    """Its end lies behind the end of the thread that would tell of it."""
    executor = Executor(RecordingRobot(), handle_sigterm=False)
    events = executor._events
    (goal,) = executor.submit(LONG)
    (results,) = events._lanes
    put = results.put

    def closing_first(event):
        results.put = put
        events.close()
        put(event)

    results.put = closing_first
    executor.stop()
    executor.close()
    assert goal.state is GoalState.CANCELED
    assert goal.future().result(30.0) is goal
