"""The robot in a program of the user's, without our node."""

from __future__ import annotations

import math
import time

import pytest

from intent_engine.actions import Move
from intent_engine.errors import RobotError
from intent_engine.execution.executor import Executor

pytestmark = pytest.mark.ros2


@pytest.fixture
def robot(peer):
    """With a node of its own, met by the peer."""
    from ros_stage import until

    from intent_engine.execution.robots.ros2 import Ros2Robot

    made = Ros2Robot(cmd_vel=f"{peer.namespace}/cmd_vel", navigation="none")
    until(lambda: made.listeners)
    until(lambda: peer.node.count_publishers(f"{peer.namespace}/cmd_vel"))  # each side finds the other for itself
    yield made
    made.close()


def test_a_program_of_a_few_lines(peer, robot):
    from ros_stage import until

    with Executor(robot, handle_sigterm=False) as executor:
        (goal,) = executor.submit(Move(0.5, 0.25, 0.5))
        assert goal.result(20.0).succeeded
    until(peer.come_to_rest)
    assert set(peer.moved()) == {(0.5, 0.0)}


def test_a_velocity_that_is_not_renewed_runs_out(peer, robot):
    from ros_stage import until

    robot.velocity(0.3, 0.1, 0.2)
    until(lambda: peer.twists == [(0.3, 0.1), (0.0, 0.0)])
    robot.velocity(0.3, 0.0, 30.0)
    until(peer.moving)  # of two that have not arrived the middleware may bring the newer alone
    robot.velocity(0.2, 0.0, 0.1)  # shorter than the one before
    until(lambda: peer.twists[-2:] == [(0.2, 0.0), (0.0, 0.0)])
    peer.silence()
    assert len(peer.twists) == 5  # and then there is silence


class Simulators:
    """A clock that is moved by hand, however long that takes."""

    def __init__(self) -> None:
        self.time = 100.0

    def now(self) -> float:
        return self.time

    def wait_until(self, condition, deadline) -> bool:
        condition.wait(0.005)
        return deadline is not None and self.time >= deadline


def test_a_velocity_holds_as_long_as_the_clock_says(peer, monkeypatch):
    """In a simulator that is ten times slower, the next one comes ten times later."""
    from ros_stage import until

    from intent_engine.execution.robots.ros2 import Ros2Robot

    monkeypatch.setattr(Ros2Robot, "STANDS", math.inf)
    clock = Simulators()
    robot = Ros2Robot(cmd_vel=f"{peer.namespace}/cmd_vel", navigation="none", clock=clock)
    try:
        until(lambda: robot.listeners)
        until(lambda: peer.node.count_publishers(f"{peer.namespace}/cmd_vel"))
        robot.velocity(0.3, 0.0, 0.01)
        until(peer.moving)
        peer.silence(0.1)
        assert peer.moving()
        clock.time += 0.02
        until(peer.standing)
        monkeypatch.setattr(Ros2Robot, "STANDS", 0.05)
        robot.velocity(0.3, 0.0, 30.0)
        until(lambda: peer.twists[-2:] == [(0.3, 0.0), (0.0, 0.0)], "a clock that stands still stops it as well")
    finally:
        robot.close()


def test_what_a_robot_cannot_do_is_refused(peer):
    from intent_engine.actions import Turn
    from intent_engine.execution.robots.ros2 import Ros2Robot

    robot = Ros2Robot(cmd_vel=f"{peer.namespace}/cmd_vel", navigation="none", capabilities=["move", "navigate", "pick"])
    try:
        assert robot.capabilities == {"move"}
        with Executor(robot, handle_sigterm=False) as executor:
            (goal,) = executor.submit(Turn(1.0, 0.5, 2.0))
        assert goal.reason == "capability"
    finally:
        robot.close()


def test_what_is_no_number_never_leaves(peer, robot):
    for wrong in (math.nan, math.inf, -math.inf):
        with pytest.raises(RobotError, match="not numbers"):
            robot.velocity(wrong, 0.0, 0.3)
        with pytest.raises(RobotError, match="not numbers"):
            robot.velocity(0.0, wrong, 0.3)
    assert robot._valid_until is None


def test_close_leaves_zero_and_may_be_called_again(peer, robot):
    from ros_stage import until

    robot.velocity(0.3, 0.0, 30.0)
    robot.close()
    robot.close()
    until(peer.standing)
    with pytest.raises(RobotError, match="closed"):
        robot.velocity(0.3, 0.0, 0.3)
    robot.stop()  # never raises, even when there is nothing left to send by


def test_a_robot_without_navigation_or_arm_refuses(peer, robot):
    from intent_engine.actions import Navigate, Pick

    with Executor(robot, handle_sigterm=False) as executor:
        for action in (Navigate("kitchen", 1.0, 2.0, 0.0), Pick("cup")):
            (goal,) = executor.submit(action)
            assert goal.reason == "capability"


def test_where_it_is(peer, robot):
    from geometry_msgs.msg import PoseWithCovarianceStamped
    from ros_stage import until

    assert robot.pose() is None
    publisher = peer.node.create_publisher(PoseWithCovarianceStamped, "/amcl_pose", 1)
    until(publisher.get_subscription_count)
    message = PoseWithCovarianceStamped()
    message.header.frame_id = "map"
    message.pose.pose.position.x = 2.0
    message.pose.pose.orientation.z = message.pose.pose.orientation.w = math.sqrt(0.5)

    def heard() -> bool:
        publisher.publish(message)  # of best effort: what is sent before the other side knows of us is lost
        time.sleep(0.02)
        return robot.pose() is not None

    until(heard)
    pose = robot.pose()
    assert (pose.x, pose.y, pose.frame) == (2.0, 0.0, "map")
    assert pose.yaw == pytest.approx(math.pi / 2)
