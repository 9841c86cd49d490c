"""Which end a goal has when several things end it at once, and what is not written beside a task of the robot."""

from __future__ import annotations

import pytest

from intent_engine.actions import Move, Navigate
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.limits import Limits
from intent_engine.execution.robots.robot import TaskState

FORWARD, KITCHEN = Move(0.5, 1.0, 2.0), Navigate("kitchen", 5.0, 2.0, 0.0)


def fail(*_) -> None:
    raise OSError("the bus is off")


class Task:
    """Confirms no cancellation; raises when it is looked at, once it is ``broken``."""

    reason, progress, broken = "", None, False

    @property
    def state(self) -> TaskState:
        if self.broken:
            fail()
        return TaskState.RUNNING

    def add_done_callback(self, callback) -> None:
        pass


def navigating(stage):
    s, task = stage(), Task()
    s.robot.navigate = lambda goal: task
    (goal,) = s.executor.submit(KITCHEN)
    s.clock.advance(1.0)
    assert goal.state is GoalState.EXECUTING
    return s, task, goal


def test_no_zeros_are_written_beside_a_navigation(stage):
    s = stage()
    goals = s.executor.submit([FORWARD, KITCHEN])
    s.executor.wait(goals)
    assert all(goal.succeeded for goal in goals)
    assert [write for write in s.robot.written if write.time > goals[1].times.started] == []


def test_what_was_making_way_when_a_stop_came_keeps_its_reason(stage):
    s, _, first = navigating(stage)
    (second,) = s.executor.submit(FORWARD)
    assert first.state is GoalState.CANCELING
    s.executor.stop()
    assert (first.state, first.reason) == (GoalState.CANCELED, Reason.PREEMPTED)
    assert second.reason is Reason.STOP


def test_a_task_that_fails_while_it_makes_way_is_cancelled_and_not_aborted(stage):
    s, task, first = navigating(stage)
    s.executor.submit(FORWARD)
    task.broken = True
    s.clock.advance(0.1)
    assert (first.state, first.reason) == (GoalState.CANCELED, Reason.ROBOT_ERROR)


def test_a_task_that_fails_is_cancelled_by_name_where_the_robot_cannot_stop(stage):
    s, task, goal = navigating(stage)
    cancelled: list = []
    s.robot.cancel, s.robot.stop, task.broken = cancelled.append, fail, True
    s.clock.advance(0.1)
    assert (goal.state, goal.reason) == (GoalState.ABORTED, Reason.ROBOT_ERROR)
    assert cancelled == [task]
    del s.robot.stop


def test_a_held_task_is_cancelled_by_name_where_the_robot_cannot_stop(stage):
    """Else it would go on through the hold, and nobody would know it any more when that becomes a stop."""
    s, task, goal = navigating(stage)
    cancelled: list = []
    s.robot.cancel, s.robot.stop = cancelled.append, fail
    s.executor.hold()
    assert (cancelled, goal.state) == ([task], GoalState.EXECUTING)
    del s.robot.stop


def test_who_makes_way_is_asked_once_however_many_commands_follow(stage):
    s, task, _ = navigating(stage)
    cancelled: list = []
    s.robot.cancel = cancelled.append
    for _ in range(3):
        (last,) = s.executor.submit(FORWARD)
        s.clock.advance(0.5)
    assert cancelled == [task]
    assert last.state is GoalState.ACCEPTED
    s.clock.advance(0.6)
    assert last.state is GoalState.EXECUTING, "2 s after the first of them the robot is stopped, and it begins"


def test_wheels_that_a_hold_stopped_while_they_were_braked_stay_at_rest(stage):
    s = stage(Limits(linear_acceleration=0.5))
    s.executor.submit(Move(0.5, 5.0, 10.0))
    s.clock.advance(3.0)
    (goal,) = s.executor.submit(KITCHEN)
    s.clock.advance(0.3)
    assert s.robot.speed()[0] > 0.0
    s.executor.hold()
    before = len(s.robot.written)
    s.executor.release()
    s.executor.wait(goal)
    assert goal.succeeded
    assert [write for write in s.robot.written[before:] if write.linear or write.angular] == []


def test_no_more_goals_wait_than_the_queue_holds(stage):
    s = stage(queue_limit=2)
    running = s.executor.submit([FORWARD, FORWARD])
    (third,) = s.executor.submit(FORWARD, policy="queue")
    refused = s.executor.submit(FORWARD, policy="queue")
    assert [goal.state for goal in (*running, third)] == [GoalState.EXECUTING, GoalState.ACCEPTED, GoalState.ACCEPTED]
    assert [(goal.state, goal.reason) for goal in refused] == [(GoalState.REJECTED, Reason.BUSY)]
    assert refused[0].detail == "more than 2 goals would wait"


@pytest.mark.parametrize(("away", "reason"), [(1.9, Reason.TIMEOUT), (6.0, Reason.WATCHDOG)])
def test_a_motion_that_is_given_up_ends_in_zeros(stage, away, reason):
    """As after Ctrl-Z and fg: the robot stands when its goal has ended."""
    s = stage()
    (goal,) = s.executor.submit(Move(0.5, 0.5, 1.0))
    s.clock.advance(0.5)
    s.clock._now += away
    s.clock.advance(1.0)
    assert (goal.state, goal.reason) == (GoalState.ABORTED, reason)
    assert [write.linear for write in s.robot.written[-3:]] == [0.0] * 3
    assert not any(write.linear for write in s.robot.written if write.time > goal.times.ended)


def test_a_program_that_was_away_does_not_drive_on_when_it_wakes(stage):
    s = stage()
    (goal,) = s.executor.submit(Move(0.5, 5.0, 10.0))
    (later,) = s.executor.submit(FORWARD, policy="queue")
    s.clock.advance(0.5)
    before = len(s.robot.written)
    s.clock._now += 4.0
    s.clock.advance(1.0)
    assert (goal.reason, later.reason) == (Reason.WATCHDOG, Reason.WATCHDOG)
    assert {write.linear for write in s.robot.written[before:]} == {0.0}
    assert goal.feedback.travelled == s.robot.pose().x
