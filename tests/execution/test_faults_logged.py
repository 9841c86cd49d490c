"""What somebody else's code raises: the goal says what, and the log where."""

from __future__ import annotations

import logging

from execution_stage import FailingRobot

from intent_engine import Custom, Executor, Move
from intent_engine.errors import RobotError
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.testing import RecordingRobot

FORWARD = Move(0.5, 1.0, 2.0)


def _aim_the_servo(action):
    return {}[action.name]


def _refuse(action):
    raise RobotError("the arm is folded")


def test_where_a_handler_raised_is_logged(stage, caplog) -> None:
    s = stage(handlers={"tilt": _aim_the_servo})
    (goal,) = s.executor.submit(Custom("tilt"))
    s.executor.wait(goal)
    assert (goal.state, goal.reason, goal.detail) == (GoalState.ABORTED, Reason.HANDLER_ERROR, "KeyError: 'tilt'")
    (record,) = caplog.records
    assert record.levelno == logging.ERROR
    assert "Custom(name='tilt'" in record.getMessage()
    assert "_aim_the_servo" in caplog.text


def test_a_handler_that_says_why_it_does_not_is_no_fault(stage, caplog) -> None:
    s = stage(handlers={"tilt": _refuse})
    (goal,) = s.executor.submit(Custom("tilt"))
    s.executor.wait(goal)
    assert (goal.reason, goal.detail) == (Reason.HANDLER_ERROR, "the arm is folded")
    assert not caplog.records


def test_where_a_robot_raised_is_logged_once_for_a_command(caplog) -> None:
    clock = VirtualClock()
    robot = FailingRobot(clock)
    robot.fail_in = 3
    with Executor(robot, clock=clock) as executor:
        (goal,) = executor.submit(FORWARD)
        executor.wait(goal)
        clock.advance(1.0)
    assert (goal.reason, goal.detail) == (Reason.ROBOT_ERROR, "the motor driver is gone")
    (record,) = caplog.records
    assert record.getMessage() == "the robot raised"
    assert "the motor driver is gone" in caplog.text


def test_a_robot_that_is_gone_and_says_so_is_no_fault(caplog) -> None:
    class Gone(RecordingRobot):
        def velocity(self, linear, angular, valid_for):
            raise RobotError("the base does not answer")

    clock = VirtualClock()
    with Executor(Gone(clock), clock=clock) as executor:
        (goal,) = executor.submit(FORWARD)
        executor.wait(goal)
    assert (goal.reason, goal.detail) == (Reason.ROBOT_ERROR, "the base does not answer")
    assert not caplog.records


def test_a_name_that_is_nearly_registered_is_told(stage) -> None:
    s = stage(handlers={"phto": _aim_the_servo})
    (goal,) = s.executor.submit(Custom("photo"))
    assert goal.reason is Reason.NO_HANDLER
    assert goal.detail == "nothing is registered for 'photo': executor.register('photo', ...); did you mean 'phto'?"
