"""A goal that puts an earlier one right: "turn left", and a moment later "ninety degrees"."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import Executor, Move, SimulatedRobot, Turn
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.limits import Limits

LIMITS = Limits(linear_acceleration=1.0, angular_acceleration=2.0)


def move(distance: float, speed: float = 0.5) -> Move:
    return Move(speed, distance, distance / abs(speed))


def turn(angle: float, speed: float = 0.5) -> Turn:
    return Turn(angle, math.copysign(speed, angle), abs(angle) / speed)


@given(
    first=st.floats(0.05, 3.0),
    second=st.floats(0.05, 3.0),
    back=st.booleans(),
    speeds=st.tuples(st.floats(0.1, 0.8), st.floats(0.1, 0.8)),
    after=st.floats(0.0, 4.0),
    ramps=st.booleans(),
)
def test_both_together_come_as_far_as_the_second_says(first, second, back, speeds, after, ramps):
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    sign = -1.0 if back else 1.0
    with Executor(robot, LIMITS if ramps else Limits(), clock=clock) as executor:
        (begun,) = executor.submit(move(first, sign * speeds[0]))
        clock.advance(after)
        (amended,) = executor.submit(move(second, sign * speeds[1]), amends=begun)
        covered = abs(robot.pose().x)
        braking = speeds[0] ** 2 / 2 if ramps else 0.0
        executor.wait()
        executor.run_until_idle()
        assert amended.succeeded
        reached = sign * robot.pose().x
        if covered + braking <= second:
            assert reached == pytest.approx(second, abs=1e-6)
        else:  # it has come further already, or nearly, and comes to rest
            assert covered - 1e-9 <= reached <= max(second, covered + braking) + 1e-6
        assert executor.snapshot().velocity == (0.0, 0.0)


def test_a_turn_that_goes_on_counts_what_was_turned():
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    with Executor(robot, clock=clock) as executor:
        (left,) = executor.submit(turn(0.75))
        clock.advance(0.8)
        (ninety,) = executor.submit(turn(math.pi / 2), amends=left)
        assert (left.state, left.reason) == (GoalState.CANCELED, Reason.PREEMPTED)
        executor.wait()
        assert robot.pose().yaw == pytest.approx(math.pi / 2)
        assert ninety.feedback.travelled == pytest.approx(math.pi / 2)
        assert ninety.feedback.progress == pytest.approx(1.0)


@pytest.mark.parametrize("second", [turn(-0.5), move(0.5)], ids=["the other way", "another motion"])
def test_another_way_begins_anew(second):
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    with Executor(robot, clock=clock) as executor:
        (left,) = executor.submit(turn(0.75))
        clock.advance(0.5)
        before = robot.pose()
        executor.submit(second, amends=left)
        executor.wait()
        after = robot.pose()
        moved = math.hypot(after.x - before.x, after.y - before.y)
        assert (after.yaw - before.yaw, moved) == pytest.approx((-0.5, 0.0) if second.type == "turn" else (0.0, 0.5))


def test_a_goal_that_was_stopped_is_not_gone_on_with():
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    with Executor(robot, clock=clock) as executor:
        (ahead,) = executor.submit(move(1.0))
        clock.advance(0.5)
        executor.stop()
        stood = robot.pose().x
        executor.submit(move(1.0), amends=ahead)
        executor.wait()
        assert robot.pose().x == pytest.approx(stood + 1.0)


def test_what_was_paused_counts_too():
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    with Executor(robot, LIMITS, clock=clock) as executor:
        (ahead,) = executor.submit(move(1.0))
        clock.advance(0.7)
        executor.pause()
        clock.advance(2.0)
        executor.submit(move(2.0), amends=ahead)
        executor.resume()
        executor.wait()
        assert robot.pose().x == pytest.approx(2.0)


def test_a_goal_that_has_ended_counts_as_a_whole():
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    with Executor(robot, clock=clock) as executor:
        (ahead,) = executor.submit(move(0.5))
        executor.wait()
        executor.submit(move(2.0), amends=ahead)
        executor.wait()
        assert robot.pose().x == pytest.approx(2.0)


def test_a_refused_amendment_leaves_the_first_alone():
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    with Executor(robot, Limits(distance=2.0), clock=clock) as executor:
        (ahead,) = executor.submit(move(1.0))
        clock.advance(0.5)
        (far,) = executor.submit(move(5.0), amends=ahead)
        assert far.reason is Reason.LIMIT
        executor.wait()
        assert ahead.succeeded
        assert robot.pose().x == pytest.approx(1.0)
