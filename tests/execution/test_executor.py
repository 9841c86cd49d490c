"""What the executor promises, on a virtual clock."""

from __future__ import annotations

import asyncio
import math

import pytest

from intent_engine.actions import Custom, Move, Navigate, Pick, Place, Stop, Turn
from intent_engine.execution.clock import MonotonicClock
from intent_engine.execution.events import EventKind
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.limits import Limits, OverLimit
from intent_engine.execution.motion import Keep
from intent_engine.execution.policy import Policy
from intent_engine.execution.robots.robot import Capability, Pose
from intent_engine.execution.robots.simulated import SimulatedRobot

FORWARD = Move(0.5, 1.0, 2.0)
LEFT = Turn(math.pi / 2, 0.5, math.pi)
KITCHEN = Navigate("kitchen", 5.0, 2.0, 0.0)


def test_a_move_ends_where_and_when_it_was_asked_to(stage):
    s = stage()
    (goal,) = s.executor.submit(FORWARD)
    assert goal.state is GoalState.EXECUTING
    assert s.executor.wait(goal)
    assert (goal.state, goal.times.ended) == (GoalState.SUCCEEDED, 2.0)
    assert s.robot.pose() == Pose(1.0, 0.0, 0.0)


def test_ramps_keep_the_distance_and_cost_time(stage):
    s = stage(Limits(linear_acceleration=0.5))
    (goal,) = s.executor.submit(FORWARD)
    s.executor.wait(goal)
    assert s.robot.pose().x == pytest.approx(1.0, abs=1e-9)
    assert goal.times.ended == pytest.approx(2.0 + 1.0)


def test_a_duration_includes_its_ramps(stage):
    s = stage(Limits(linear_acceleration=0.5))
    (goal,) = s.executor.submit(FORWARD, keep=Keep.DURATION)
    s.executor.wait(goal)
    assert goal.times.ended == pytest.approx(2.0)
    assert s.robot.pose().x == pytest.approx(0.5, abs=1e-9)


def test_the_actions_of_one_utterance_are_done_in_order(stage):
    s = stage(objects={"cup": "kitchen"})
    goals = s.executor.submit([KITCHEN, Pick("cup"), LEFT, FORWARD, Place(None, None)])
    assert s.executor.wait(goals)
    assert [goal.state for goal in goals] == [GoalState.SUCCEEDED] * 5
    ends = [goal.times.ended for goal in goals]
    assert ends == sorted(ends)
    assert s.robot.pose().y == pytest.approx(3.0)


def test_stop_ends_everything_before_it_returns(stage):
    s = stage(Limits(linear_acceleration=0.3))
    goals = s.executor.submit([FORWARD, LEFT])
    s.clock.advance(0.7)
    s.executor.stop()
    where, writes = s.robot.pose(), len(s.robot.written)
    assert [goal.reason for goal in goals] == [Reason.STOP, Reason.STOP]
    assert all(goal.state is GoalState.CANCELED for goal in goals)
    s.clock.advance(5.0)
    assert s.robot.pose() == where
    later = s.robot.written[writes - 1 :]
    assert 2 <= len(later) <= 4
    assert all(write.linear == write.angular == 0 for write in later)


def test_a_spoken_stop_acts_at_once_even_late_and_in_an_emergency(stage):
    s = stage()
    (goal,) = s.executor.submit(KITCHEN)
    s.clock.advance(100.0 - 90.0)
    s.executor.estop()
    (stop,) = s.executor.submit(Stop(), spoken_at=0.0)
    assert stop.succeeded
    assert goal.reason is Reason.ESTOP
    (refused,) = s.executor.submit(FORWARD)
    assert (refused.state, refused.reason) == (GoalState.REJECTED, Reason.ESTOP)
    s.executor.reset()
    assert s.executor.submit(FORWARD)[0].result().succeeded


def test_a_stop_in_the_middle_of_a_sentence_is_done_in_its_turn(stage):
    s = stage()
    goals = s.executor.submit([FORWARD, Stop(), LEFT])
    s.executor.wait(goals)
    assert [goal.state for goal in goals] == [GoalState.SUCCEEDED] * 3


def test_old_words_are_not_acted_on(stage):
    s = stage(expire_after=3.0)
    s.clock.advance(10.0)
    (late,) = s.executor.submit(FORWARD, spoken_at=6.9)
    (fresh,) = s.executor.submit(FORWARD, spoken_at=7.1)
    assert (late.state, late.reason) == (GoalState.REJECTED, Reason.EXPIRED)
    assert fresh.state is GoalState.EXECUTING


def test_a_newer_command_takes_over_from_the_present_velocity(stage):
    s = stage(Limits(linear_acceleration=1.0))
    (first,) = s.executor.submit(Move(1.0, 5.0, 5.0))
    s.clock.advance(2.0)
    where = s.robot.pose().x
    (second,) = s.executor.submit(Move(0.5, 2.0, 4.0))
    assert (first.state, first.reason) == (GoalState.CANCELED, Reason.PREEMPTED)
    assert s.robot.written[-1].linear > 0.9
    s.executor.wait(second)
    assert s.robot.pose().x - where == pytest.approx(2.0)


def test_a_navigation_makes_way_before_the_next_goal_begins(stage):
    s = stage()
    (first,) = s.executor.submit(KITCHEN)
    s.clock.advance(1.0)
    (second,) = s.executor.submit(FORWARD)
    s.executor.wait(second)
    assert (first.state, first.reason) == (GoalState.CANCELED, Reason.PREEMPTED)
    assert second.succeeded


def test_a_motion_is_braked_before_the_robot_navigates_itself(stage):
    s = stage(Limits(linear_acceleration=1.0))
    s.executor.submit(Move(1.0, 5.0, 5.0))
    s.clock.advance(2.0)
    (goal,) = s.executor.submit(KITCHEN)
    assert goal.state is GoalState.ACCEPTED
    s.executor.wait(goal)
    assert goal.succeeded
    assert goal.times.started == pytest.approx(3.0)
    assert s.robot.pose() == Pose(5.0, 2.0, 0.0)


@pytest.mark.parametrize("policy", list(Policy))
def test_policies(stage, policy):
    s = stage(policies={"turn": policy})
    (first,) = s.executor.submit(FORWARD)
    (second,) = s.executor.submit(LEFT)
    s.executor.wait()
    expected = {
        Policy.REPLACE: (Reason.PREEMPTED, Reason.NONE),
        Policy.QUEUE: (Reason.NONE, Reason.NONE),
        Policy.FOLLOW: (Reason.NONE, Reason.NONE),
        Policy.REFUSE: (Reason.NONE, Reason.BUSY),
    }
    assert (first.reason, second.reason) == expected[policy]


@pytest.mark.parametrize("policy", [Policy.QUEUE, Policy.FOLLOW])
@pytest.mark.parametrize("fails", ["before", "running"])
def test_what_follows_is_not_done_if_what_it_follows_fails(stage, policy, fails):
    """ "Go to the kitchen", and a moment later "when you get there, turn left"."""
    s = stage(handlers={"fine": lambda action: None, "broken": lambda action: 1 / 0})
    fine, bad = Custom("fine"), Custom("broken")
    goals = s.executor.submit(FORWARD)
    goals += s.executor.submit([bad, fine] if fails == "before" else fine, policy=policy)
    goals += s.executor.submit(LEFT, policy=policy)
    if fails == "running":
        s.executor.cancel(goals[0])
    s.executor.run_until_idle()
    assert goals[-1].succeeded == (policy is Policy.QUEUE)
    assert s.executor.idle


def test_what_follows_nothing_is_done_at_once(stage):
    s = stage()
    (goal,) = s.executor.submit(LEFT, policy="follow")
    assert goal.state is GoalState.EXECUTING


def test_half_a_command_is_never_done(stage):
    s = stage(Limits(distance=0.5))
    goals = s.executor.submit([LEFT, FORWARD])
    assert [goal.state for goal in goals] == [GoalState.REJECTED] * 2
    assert [goal.reason for goal in goals] == [Reason.EARLIER_FAILED, Reason.LIMIT]
    assert "0.5 m" in goals[1].detail
    assert s.robot.written == []


def test_a_clamped_action_says_so_and_is_done(stage):
    s = stage(Limits(linear_velocity=0.25, over=OverLimit.CLAMP))
    (goal,) = s.executor.submit(FORWARD)
    s.executor.wait(goal)
    assert goal.succeeded
    assert "0.25 m/s" in goal.detail
    assert (goal.asked, goal.times.ended, s.robot.pose().x) == (FORWARD, 4.0, 1.0)


def test_what_the_robot_cannot_do_is_refused_by_name():
    robot = SimulatedRobot(capabilities={Capability.MOVE})
    with Executor(robot, handle_sigterm=False) as executor:
        (goal,) = executor.submit(Pick("cup"))
        assert (goal.state, goal.reason) == (GoalState.REJECTED, Reason.CAPABILITY)
        assert "pick" in goal.detail


def test_a_task_that_fails_ends_its_utterance_with_the_robots_words(stage):
    s = stage(objects={"cup": "dock"})
    goals = s.executor.submit([Pick("cup"), FORWARD])
    s.executor.wait(goals)
    assert [goal.state for goal in goals] == [GoalState.ABORTED, GoalState.CANCELED]
    assert "10.0 m away" in goals[0].detail
    assert goals[1].reason is Reason.EARLIER_FAILED


def test_hold_is_at_once_and_release_goes_on_with_what_is_left(stage):
    s = stage(Limits(linear_acceleration=1.0))
    (goal,) = s.executor.submit(FORWARD)
    s.clock.advance(0.987)
    s.executor.hold()
    where = s.robot.pose()
    assert s.robot.speed() == (0.0, 0.0)
    s.clock.advance(3.0)
    assert s.robot.pose() == where
    assert goal.state is GoalState.EXECUTING
    s.executor.release()
    s.executor.wait(goal)
    assert goal.succeeded
    assert s.robot.pose().x == pytest.approx(1.0, abs=1e-9)


def test_a_held_navigation_is_given_again(stage):
    s = stage()
    (goal,) = s.executor.submit(KITCHEN)
    s.clock.advance(2.0)
    s.executor.hold()
    where = s.robot.pose()
    s.clock.advance(1.0)
    assert s.robot.pose() == where
    s.executor.release()
    s.executor.wait(goal)
    assert goal.succeeded
    assert s.robot.pose() == Pose(5.0, 2.0, 0.0)


def test_a_hold_that_nobody_releases_becomes_a_stop(stage):
    s = stage(hold_limit=4.0)
    (goal,) = s.executor.submit(FORWARD)
    s.clock.advance(1.0)
    s.executor.hold()
    s.executor.run_until_idle()
    assert (goal.state, goal.reason, goal.times.ended) == (GoalState.CANCELED, Reason.HOLD_EXPIRED, 5.0)
    assert not s.executor.snapshot().held


def test_what_comes_in_a_hold_waits_for_the_release(stage):
    s = stage()
    s.executor.hold()
    (goal,) = s.executor.submit(FORWARD)
    s.clock.advance(1.0)
    assert goal.state is GoalState.ACCEPTED
    assert s.robot.pose().x == 0.0
    s.executor.release()
    s.executor.wait(goal)
    assert s.robot.pose().x == 1.0


@pytest.mark.parametrize("moment", [0.3, 1.0, 1.9, 2.3])
@pytest.mark.parametrize("gap", [0.2, 3.0])
def test_pause_brakes_and_resume_keeps_the_distance(stage, moment, gap):
    s = stage(Limits(linear_acceleration=1.0))
    (goal,) = s.executor.submit(FORWARD)
    s.clock.advance(moment)
    s.executor.pause()
    s.clock.advance(gap)
    s.executor.resume()
    s.executor.wait(goal)
    assert goal.succeeded
    assert s.robot.pose().x == pytest.approx(1.0, abs=1e-9)


def test_a_handler_gets_its_action_and_its_result_is_told(stage):
    s = stage()
    seen = []
    s.executor.register("wave", lambda action: seen.append(action) or f"waved at {action.slots['person']}")
    (goal,) = s.executor.submit(Custom("wave", {"person": "Ada"}))
    s.executor.wait(goal)
    assert (goal.state, goal.detail) == (GoalState.SUCCEEDED, "waved at Ada")


def test_a_handler_that_raises_aborts_its_goal_and_nothing_else(stage):
    s = stage(policies={"move": "queue"})

    def broken(action):
        raise KeyError("arm")

    s.executor.register("wave", broken)
    goals = s.executor.submit(Custom("wave")) + s.executor.submit(FORWARD)
    s.executor.wait(goals)
    assert (goals[0].state, goals[0].reason) == (GoalState.ABORTED, Reason.HANDLER_ERROR)
    assert "arm" in goals[0].detail
    assert goals[1].succeeded


def test_an_action_that_nobody_registered_for_is_refused(stage):
    (goal,) = stage().executor.submit(Custom("dance"))
    assert (goal.state, goal.reason) == (GoalState.REJECTED, Reason.NO_HANDLER)
    assert "dance" in goal.detail


def test_a_listener_that_raises_breaks_nothing(stage, caplog):
    s = stage()

    def broken(event):
        raise RuntimeError("listener")

    s.executor.subscribe(broken)
    (goal,) = s.executor.submit(FORWARD)
    s.executor.wait(goal)
    assert goal.succeeded
    assert [e.state for e in s.events if e.kind is EventKind.GOAL][-1] is GoalState.SUCCEEDED
    assert "listener" in caplog.text


def test_a_listener_may_command(stage):
    s = stage()

    def follow(event):
        if event.goal is not None and event.state is GoalState.SUCCEEDED and event.goal.action == FORWARD:
            s.executor.submit(LEFT)

    s.executor.subscribe(follow)
    s.executor.submit(FORWARD)
    s.executor.run_until_idle()
    assert s.robot.pose().yaw == pytest.approx(math.pi / 2)


def test_feedback_tells_how_far(stage):
    s = stage()
    (goal,) = s.executor.submit(FORWARD)
    s.clock.advance(1.0)
    assert goal.feedback.progress == pytest.approx(0.5)
    assert goal.feedback.time_left == pytest.approx(1.0)
    assert goal.feedback.pose.x == pytest.approx(0.5)


def test_one_goal_can_be_cancelled_alone(stage):
    s = stage(Limits(linear_acceleration=1.0), policies={"turn": "queue"})
    (first,) = s.executor.submit(FORWARD)
    (second,) = s.executor.submit(LEFT)
    s.clock.advance(1.0)
    s.executor.cancel(first)
    s.executor.wait()
    assert (first.reason, second.state) == (Reason.CANCELED, GoalState.SUCCEEDED)


@pytest.mark.parametrize("which", [1, 2, 3, 4, 5])
def test_what_is_cancelled_takes_along_what_was_said_with_it_after_it_and_nothing_else(stage, which):
    s = stage()
    goals = s.executor.submit([FORWARD, LEFT, FORWARD]) + s.executor.submit([LEFT, FORWARD, LEFT], policy="queue")
    s.executor.cancel(goals[which])
    s.executor.run_until_idle()
    gone = [goal for goal in goals if goal.state is GoalState.CANCELED]
    assert gone == (goals[which:3] if which < 3 else goals[which:])
    assert {goal.reason for goal in gone} == {Reason.CANCELED}
    assert all(goal.succeeded for goal in goals if goal not in gone)


@pytest.mark.parametrize("end", ["stop", "replace", "cancel", "fail"])
def test_a_command_may_be_as_long_as_the_queue(stage, end):
    s = stage(queue_limit=3000, handlers={"broken": lambda action: 1 / 0})
    goals = s.executor.submit([Custom("broken") if end == "fail" else FORWARD, *[LEFT] * 2500])
    if end == "stop":
        s.executor.stop()
    elif end == "replace":
        s.executor.submit(LEFT)
    elif end == "cancel":
        s.executor.cancel(goals[0])
    else:
        s.clock.advance(0.0)
    assert all(goal.done for goal in goals)


def test_after_close_everything_is_rejected(stage):
    s = stage()
    (goal,) = s.executor.submit(FORWARD)
    s.clock.advance(1.0)
    s.executor.close()
    s.executor.close()
    assert goal.reason is Reason.CLOSED
    assert s.executor.submit(FORWARD)[0].reason is Reason.CLOSED
    assert all(write.linear == 0 for write in s.robot.written[-3:])


@pytest.mark.parametrize("wrong", ["go", [FORWARD, None], 3])
def test_what_is_no_action_is_a_type_error_and_moves_nothing(stage, wrong):
    s = stage()
    with pytest.raises(TypeError, match="submit takes actions"):
        s.executor.submit(wrong)
    assert s.robot.written == []


def test_a_stop_stops_though_what_follows_is_no_action(stage):
    s = stage()
    (goal,) = s.executor.submit(FORWARD)
    s.clock.advance(1.0)
    with pytest.raises(TypeError, match="submit takes actions"):
        s.executor.submit([Stop(), "go"])
    assert goal.reason is Reason.STOP
    assert s.robot.written[-1].linear == 0


@pytest.mark.parametrize(("name", "handler"), [("wave", None), ("wave", "wave"), (5, print), (print, "wave")])
def test_a_handler_is_a_name_and_a_function(stage, name, handler):
    with pytest.raises(TypeError, match="register takes a name and a function"):
        stage().executor.register(name, handler)


def test_a_goal_can_be_awaited():
    async def drive():
        with Executor(SimulatedRobot(), clock=MonotonicClock(), handle_sigterm=False) as executor:
            (goal,) = executor.submit(Move(1.0, 0.02, 0.02))
            return await goal

    assert asyncio.run(drive()).succeeded


def test_a_missing_step_of_the_clock_is_told_apart_from_the_end(stage):
    s = stage()
    (goal,) = s.executor.submit(FORWARD)
    s.executor.pause()
    assert not s.executor.wait(goal)
    with pytest.raises(TimeoutError):
        goal.result(timeout=1.0)
