"""A motion that is done faster, or slower, while it is done: just as far, within the limits."""

from __future__ import annotations

import itertools
import math

import pytest
from execution_stage import Stage
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import ChangeSpeed, Executor, Move, Navigate, SimulatedRobot, Stop, Turn
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.limits import Limits

MOVE = Move(0.5, 5.0, 10.0)


@given(
    amount=st.floats(0.5, 5.0),
    speed=st.floats(0.1, 0.8),
    sign=st.sampled_from((-1.0, 1.0)),
    turning=st.booleans(),
    factors=st.lists(st.floats(0.3, 3.0), min_size=1, max_size=3),
    after=st.floats(0.0, 3.0),
    ramps=st.booleans(),
    keep=st.sampled_from(("distance", "duration")),
)
def test_it_comes_just_as_far_and_never_beyond_a_limit(amount, speed, sign, turning, factors, after, ramps, keep):
    limits = Limits(1.0, 1.0, *((1.0, 2.0) if ramps else ()))
    stage = Stage(limits)
    with stage.executor as executor:
        duration = amount / speed
        asked = Turn(sign * amount, sign * speed, duration) if turning else Move(sign * speed, amount, duration)
        (goal,) = executor.submit(asked, keep=keep)
        changes = []
        for factor in factors:
            stage.clock.advance(after)
            changes += executor.submit(ChangeSpeed(factor))
        executor.run_until_idle()
        assert goal.succeeded
        if keep == "distance" or any(change.succeeded for change in changes):
            assert goal.feedback.travelled == pytest.approx(sign * amount, abs=1e-6)
        assert max(abs(write.angular if turning else write.linear) for write in stage.robot.written) <= 1.0 + 1e-9
        if ramps:
            times = [write for write in stage.robot.written if not write.by_stop]
            for one, two in itertools.pairwise(times):
                change = abs((two.angular - one.angular) if turning else (two.linear - one.linear))
                assert change <= (2.0 if turning else 1.0) * 2 * executor.rates.period + 1e-6
        assert executor.snapshot().velocity == (0.0, 0.0)


@pytest.mark.parametrize(("factor", "speed", "ends"), [(1.5, 0.75, 8.0), (0.5, 0.25, 18.0)])
def test_the_rest_of_the_way_is_driven_at_the_new_speed(factor, speed, ends):
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        (goal,) = executor.submit(MOVE)
        clock.advance(2.0)
        (change,) = executor.submit(ChangeSpeed(factor))
        assert (change.state, change.detail) == (GoalState.SUCCEEDED, f"from 0.5 to {speed} m/s")
        clock.advance(0.1)
        assert executor.snapshot().velocity == (speed, 0.0)
        executor.wait()
        assert clock.now() == pytest.approx(2.0 + 4.0 / speed)
        assert goal.action == Move(speed, 5.0, 5.0 / speed)
        assert goal.asked == MOVE


def test_the_limit_is_kept_also_where_beyond_it_is_refused():
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), Limits(linear_velocity=0.6), clock=clock) as executor:
        (goal,) = executor.submit(MOVE)
        first, second = executor.submit([ChangeSpeed(2.0), ChangeSpeed(2.0)])
        assert (first.detail, goal.action.linear_velocity) == ("from 0.5 to 0.6 m/s, the limit of this robot", 0.6)
        assert (second.state, second.reason) == (GoalState.REJECTED, Reason.LIMIT)
        executor.wait()
        assert goal.feedback.travelled == pytest.approx(5.0)


def test_a_motion_that_would_take_too_long_is_left_as_it_is():
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), Limits(duration=12.0), clock=clock) as executor:
        (goal,) = executor.submit(MOVE)
        (change,) = executor.submit(ChangeSpeed(0.5))
        assert (change.reason, change.detail) == (
            Reason.LIMIT,
            "it cannot go slower: it would take 20 s, and this robot's limit is 12 s",
        )
        assert goal.action == MOVE


def test_nothing_to_do_faster():
    stage = Stage(Limits())
    with stage.executor as executor:
        (stands,) = executor.submit(ChangeSpeed(1.5))
        assert (stands.state, stands.reason) == (GoalState.REJECTED, Reason.NOTHING_MOVES)
        assert "does not move" in stands.detail
        executor.submit(MOVE)
        _, stopped = executor.submit([Stop(), ChangeSpeed(0.5)])
        assert stopped.reason is Reason.NOTHING_MOVES
        (way,) = executor.submit(Navigate("kitchen", 5.0, 2.0, 0.0))
        (driven,) = executor.submit(ChangeSpeed(0.5))
        assert (driven.reason, way.state) == (Reason.CAPABILITY, GoalState.EXECUTING)
        executor.estop()
        assert executor.submit(ChangeSpeed(0.5))[0].reason is Reason.ESTOP


def test_with_another_command_neither_is_done():
    """Its turn would come when that is over."""
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        (goal,) = executor.submit(MOVE)
        turn, change = executor.submit([Turn(1.0, 0.5, 2.0), ChangeSpeed(1.5)])
        assert (turn.reason, change.reason) == (Reason.EARLIER_FAILED, Reason.NOTHING_MOVES)
        assert goal.state is GoalState.EXECUTING
        assert goal.action == MOVE


def test_only_what_is_being_done_and_not_what_waits():
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        first, second = executor.submit([MOVE, Turn(1.0, 0.5, 2.0)])
        executor.submit(ChangeSpeed(2.0), policy="follow")
        executor.wait()
        assert (first.action.linear_velocity, second.action.angular_velocity) == (1.0, 0.5)
        assert first.succeeded
        assert second.succeeded


@pytest.mark.parametrize(("rest", "go_on"), [("hold", "release"), ("pause", "resume")])
@pytest.mark.parametrize("standing", [True, False])
def test_a_robot_that_is_held_goes_on_at_the_new_speed(rest, go_on, standing):
    stage = Stage(Limits(linear_acceleration=1.0))
    with stage.executor as executor:
        (goal,) = executor.submit(MOVE)
        stage.clock.advance(2.0)
        getattr(executor, rest)()
        stage.clock.advance(1.0 if standing else 0.1)
        written = len(stage.robot.written)
        executor.submit(ChangeSpeed(0.5))
        assert all(abs(write.linear) < 0.5 for write in stage.robot.written[written:])
        stage.clock.advance(1.0)
        assert executor.snapshot().velocity == (0.0, 0.0)
        getattr(executor, go_on)()
        stage.clock.advance(2.0)
        assert executor.snapshot().velocity == (0.25, 0.0)
        executor.run_until_idle()
        assert goal.feedback.travelled == pytest.approx(5.0)


def test_a_robot_that_brakes_at_the_end_is_left_alone():
    stage = Stage(Limits(linear_acceleration=1.0))
    with stage.executor as executor:
        (goal,) = executor.submit(Move(0.5, 1.0, 2.0))
        stage.clock.advance(2.3)
        (change,) = executor.submit(ChangeSpeed(1.5))
        assert (change.reason, change.detail) == (
            Reason.NOTHING_MOVES,
            "the robot is coming to rest at the end of its way",
        )
        executor.wait()
        assert goal.feedback.travelled == pytest.approx(1.0)


def test_what_was_asked_for_can_still_be_denied():
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        (goal,) = executor.submit(MOVE)
        executor.submit(ChangeSpeed(1.5))
        assert executor.deny(MOVE)
        assert goal.reason is Reason.STOP


def test_a_guard_that_forbids_it():
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        (goal,) = executor.submit(MOVE)
        (change,) = executor.submit(ChangeSpeed(1.5), guards=[lambda: "there are people"])
        assert (change.state, change.reason, change.detail) == (
            GoalState.REJECTED,
            Reason.FORBIDDEN,
            "there are people",
        )
        assert goal.action == MOVE


def test_a_speed_that_no_number_is_large_enough_for_is_refused():
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        (goal,) = executor.submit(MOVE)
        executor.pause()
        first, second = executor.submit([ChangeSpeed(1e200), ChangeSpeed(1e200)])
        assert first.succeeded
        assert (second.state, second.reason) == (GoalState.REJECTED, Reason.LIMIT)
        assert not goal.done


def test_a_robot_that_fails_meanwhile():
    """As with any motion, its goal is aborted and the robot stopped."""
    from execution_stage import FailingRobot

    clock = VirtualClock()
    robot = FailingRobot(clock)
    with Executor(robot, clock=clock, handle_sigterm=False) as executor:
        (goal,) = executor.submit(MOVE)
        clock.advance(1.0)
        robot.fail_in = 0
        executor.submit(ChangeSpeed(1.5))
        clock.advance(1.0)
        assert (goal.state, goal.reason) == (GoalState.ABORTED, Reason.ROBOT_ERROR)
        assert executor.snapshot().velocity == (0.0, 0.0)


@pytest.mark.parametrize("factor", [0.0, -1.0, math.nan, math.inf])
def test_a_factor_that_is_none(factor):
    with pytest.raises(ValueError, match=r"ChangeSpeed\.factor"):
        ChangeSpeed(factor)
