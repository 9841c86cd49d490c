"""The simulated robot is a robot: closed-form motion, tasks, slip, delay and things to carry."""

from __future__ import annotations

import math
import threading

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.errors import RobotError
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.robots.robot import Pose, TaskState
from intent_engine.execution.robots.simulated import SimulatedRobot

KITCHEN = Pose(5.0, 2.0, 0.5)


def make(**options) -> tuple[VirtualClock, SimulatedRobot]:
    clock = VirtualClock()
    return clock, SimulatedRobot(clock, locations={"kitchen": KITCHEN}, **options)


@given(st.floats(-2, 2), st.floats(-3, 3), st.floats(0.01, 10), st.integers(1, 50))
def test_the_pose_does_not_depend_on_how_often_it_is_asked(linear, angular, seconds, looks):
    clock, robot = make()
    _, other = make()
    other_clock = other.clock
    robot.velocity(linear, angular, 100.0)
    other.velocity(linear, angular, 100.0)
    for _ in range(looks):
        clock.advance(seconds / looks)
        robot.pose()
    other_clock.advance_to(clock.now())  # type: ignore[attr-defined]
    here, there = robot.pose(), other.pose()
    assert here.x == pytest.approx(there.x, abs=1e-9)
    assert here.y == pytest.approx(there.y, abs=1e-9)
    assert here.yaw == pytest.approx(angular * seconds, abs=1e-9)


def test_a_full_circle_comes_back():
    clock, robot = make()
    robot.velocity(1.0, 1.0, 100.0)
    clock.advance(math.tau)
    assert (robot.pose().x, robot.pose().y) == (pytest.approx(0.0, abs=1e-12), pytest.approx(0.0, abs=1e-12))


def test_a_velocity_ends_when_it_is_no_longer_valid():
    clock, robot = make()
    robot.velocity(0.5, 0.0, 0.3)
    clock.advance(10.0)
    assert robot.pose().x == pytest.approx(0.15)
    assert robot.speed() == (0.0, 0.0)


def test_wheels_that_accelerate_need_their_way():
    clock, robot = make(acceleration=0.5)
    robot.velocity(1.0, 0.0, 2.0)
    clock.advance(2.0)
    assert robot.pose().x == pytest.approx(1.0)
    clock.advance(2.0)
    assert robot.pose().x == pytest.approx(2.0)
    assert robot.speed() == (0.0, 0.0)


@given(st.floats(0.1, 2.0), st.floats(0.1, 2.0), st.floats(0.5, 4.0))
def test_a_ramp_on_a_curve_is_integrated_finely(linear, angular, seconds):
    clock, robot = make(acceleration=0.7, angular_acceleration=0.9)
    robot.velocity(linear, angular, 100.0)
    clock.advance(seconds)
    x = y = 0.0
    n = 4000
    for i in range(n):
        t = (i + 0.5) * seconds / n
        ramp = min(t, angular / 0.9)
        yaw = 0.45 * ramp**2 + max(t - angular / 0.9, 0.0) * angular
        v = min(0.7 * t, linear)
        x += v * math.cos(yaw) * seconds / n
        y += v * math.sin(yaw) * seconds / n
    assert robot.pose().x == pytest.approx(x, abs=1e-5)
    assert robot.pose().y == pytest.approx(y, abs=1e-5)


def test_a_delay_moves_the_effect_and_not_the_stop():
    clock, robot = make(delay=0.2)
    robot.velocity(1.0, 0.0, 1.0)
    clock.advance(0.2)
    assert robot.pose().x == 0.0
    clock.advance(0.5)
    robot.stop()
    clock.advance(5.0)
    assert robot.pose().x == pytest.approx(0.5)


def test_slip_is_the_same_for_the_same_seed():
    def drive(seed: int) -> Pose:
        clock, robot = make(slip=0.1, seed=seed)
        for _ in range(20):
            robot.velocity(0.5, 0.1, 0.3)
            clock.advance(0.05)
        return robot.pose()

    assert drive(1) == drive(1)
    assert drive(1) != drive(2)
    assert drive(1).x == pytest.approx(0.5, abs=0.05)


def test_navigation_arrives_at_its_own_time():
    clock, robot = make()
    told = []
    task = robot.navigate(KITCHEN)
    task.add_done_callback(lambda task: told.append((clock.now(), task.state)))
    clock.advance(3.0)
    assert task.state is TaskState.RUNNING
    assert 0.1 < task.progress < 0.5
    clock.run_until_idle()
    assert robot.pose() == KITCHEN
    turn, way = math.atan2(2.0, 5.0), math.hypot(2.0, 5.0)
    assert told == [(pytest.approx(turn + way / 0.5 + abs(0.5 - turn)), TaskState.SUCCEEDED)]
    late = []
    task.add_done_callback(lambda task: late.append(task.state))
    assert late == [TaskState.SUCCEEDED]


@pytest.mark.parametrize("how", ["cancel", "stop", "replace", "drive"])
def test_what_ends_a_navigation(how):
    clock, robot = make()
    task = robot.navigate(KITCHEN)
    clock.advance(4.0)
    where = robot.pose()
    if how == "cancel":
        robot.cancel(task)
    elif how == "stop":
        robot.stop()
    elif how == "replace":
        robot.navigate(where)
    else:
        robot.velocity(0.1, 0.0, 0.1)
    assert task.state is (TaskState.FAILED if how == "drive" else TaskState.CANCELED)
    assert task.reason
    if how != "drive":
        clock.run_until_idle()
        assert robot.pose() == where


def test_things_are_picked_where_they_are_and_put_where_one_is():
    clock, robot = make(objects={"cup": "kitchen", "pen": None})

    def run(task):
        clock.run_until_idle()
        return task.state, task.reason

    assert run(robot.pick("cup"))[1] == "the cup is 5.4 m away, and it reaches 1 m"
    assert run(robot.pick("ball"))[1] == "there is no ball here; there is: cup, pen"
    assert run(robot.place(None, None))[1] == "it holds nothing"
    assert run(robot.pick("pen"))[0] is TaskState.SUCCEEDED
    run(robot.navigate(KITCHEN))
    assert run(robot.pick("cup"))[1] == "it holds the pen already"
    assert run(robot.place("cup", None))[1] == "it holds the pen, not the cup"
    assert run(robot.place(None, "table"))[0] is TaskState.SUCCEEDED
    assert robot.objects["pen"] == KITCHEN
    assert run(robot.pick("cup"))[0] is TaskState.SUCCEEDED


def test_an_open_world_has_everything():
    clock, robot = make()
    task = robot.pick("anything")
    clock.run_until_idle()
    assert (task.state, robot.holding) == (TaskState.SUCCEEDED, "anything")


def test_errors_are_told():
    _, robot = make()
    with pytest.raises(RobotError, match="nan"):
        robot.velocity(math.nan, 0.0, 0.3)
    with pytest.raises(RobotError, match="different clocks"):
        robot.use_clock(VirtualClock())
    with pytest.raises(RobotError, match="cellar"):
        make(objects={"cup": "cellar"})
    robot.close()
    robot.close()
    robot.stop()
    with pytest.raises(RobotError, match="closed"):
        robot.velocity(0.1, 0.0, 0.3)


def test_a_task_that_ends_as_somebody_asks_to_be_told_tells_it():
    """In another thread, right after it was seen to run."""
    robot = SimulatedRobot()
    task, told = robot.navigate(Pose(5.0, 0.0, 0.0)), threading.Event()

    class Late(list):
        def append(self, callback) -> None:
            self.other = threading.Thread(target=robot.stop)
            self.other.start()
            self.other.join(0.05)
            super().append(callback)

    task._callbacks = late = Late()
    task.add_done_callback(lambda task: told.set())
    late.other.join(10.0)
    assert told.is_set()
