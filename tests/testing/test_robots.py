"""The recording robot, driven by the real executor on the virtual clock."""

from __future__ import annotations

import pytest

from intent_engine import Executor, Move, Navigate, Pick
from intent_engine.execution.goal import GoalState
from intent_engine.testing import RecordingRobot, VirtualClock


@pytest.fixture
def clock():
    return VirtualClock()


def test_it_remembers_what_it_was_told_and_when(clock):
    robot = RecordingRobot(clock)
    with Executor(robot, handle_sigterm=False) as executor:
        (goal,) = executor.submit([Move(0.2, 0.4, 2.0)])
        clock.run_until_idle()
    assert goal.state is GoalState.SUCCEEDED
    assert (0.2, 0.0) in robot.velocities
    assert robot.at_rest
    times = [command.time for command in robot.commands]
    assert times == sorted(times)
    assert robot.names[-1] in ("stop", "close")


def test_tasks_end_at_once_or_when_the_test_says_so(clock):
    robot = RecordingRobot(clock, finish_tasks=False)
    with Executor(robot, handle_sigterm=False) as executor:
        (goal,) = executor.submit([Navigate("dock", 1.0, 2.0, 0.0)])
        clock.advance(5.0)
        assert robot.names[-1] == "navigate"
        assert goal.state is GoalState.EXECUTING
        assert not robot.at_rest
        robot.tasks[-1].fail("the way is blocked")
        clock.run_until_idle()
        assert goal.state is GoalState.ABORTED
        (picking,) = executor.submit([Pick("cup")])
        clock.advance(1.0)
        executor.stop()
        assert picking.state is GoalState.CANCELED
    assert robot.at_rest


def test_a_task_ends_once():
    robot = RecordingRobot(finish_tasks=False)
    task = robot.pick("cup")
    ended = []
    task.add_done_callback(ended.append)
    robot.tasks[0].succeed()
    robot.tasks[0].fail("too late")
    task.add_done_callback(ended.append)
    assert ended == [task, task]
    assert (task.state.value, task.reason) == ("succeeded", "")
