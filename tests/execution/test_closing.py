"""Closing an executor: of a robot that hangs, and of one that exits in its stop."""

from __future__ import annotations

import threading

import pytest

from intent_engine import Executor, GoalState, Move, Reason
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
    goals[0].result(30.0)
    assert (goals[0].state, goals[0].reason) == (GoalState.CANCELED, Reason.CLOSED)
    assert robot.at_rest


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
