"""Navigation goals against a real action server in another process, in both ways in which they are given."""

from __future__ import annotations

import os
import random
import time

import pytest

from intent_engine.actions import Navigate
from intent_engine.execution.executor import Executor
from intent_engine.execution.robots.robot import Pose, TaskState

pytestmark = pytest.mark.ros2

TRIALS = int(os.environ.get("INTENT_ENGINE_ROS2_TRIALS", "100"))
"""Goals that are stopped at once, in each way; 1000 for the whole of it."""
WAYS = ["action", "goal_pose"]


class Stage:
    """A robot in this process, its server in another, and an executor."""

    def __init__(self, way: str, *words: str) -> None:
        from ros_stage import Peer, Server, until
        from test_msgs.action import Fibonacci

        from intent_engine.execution.robots.ros2 import Ros2Robot
        from intent_engine.execution.robots.ros2_navigation import NavigationAction

        self.peer = Peer()
        self.server = Server(self.peer.namespace, "goal_pose", *words)
        action = NavigationAction(
            Fibonacci,
            lambda pose: Fibonacci.Goal(order=int(pose.pose.position.x)),
            lambda feedback: float(feedback.sequence[0]),
        )
        self.robot = Ros2Robot(self.peer.node, navigation=way, action=action)
        assert self.robot.navigation is not None
        self.keeper = self.robot.navigation._keeper
        until(lambda: self.server.said)
        until(lambda: not self.keeper._link.unavailable(), "the server is there")
        self.executor = Executor(self.robot, handle_sigterm=False)

    def go(self, order: int):
        """Drive for ``order`` hundredths of a second."""
        (goal,) = self.executor.submit([Navigate("somewhere", float(order), 0.0, 0.0)])
        return goal

    def close(self) -> None:
        self.executor.close()
        self.robot.close()
        self.server.end()
        self.peer.__exit__()


@pytest.fixture(scope="module", params=WAYS)
def stage(request):
    made = Stage(request.param)
    yield made
    made.close()


@pytest.fixture
def quiet(stage):
    """Nothing is driven any more, and what was said is forgotten."""
    from ros_stage import until

    stage.executor.stop()
    assert stage.robot.navigation.wait(10.0)
    stage.server.told()
    until(lambda: stage.server.driving() == 0)
    stage.server.said.clear()
    return stage


def test_a_goal_is_driven_to_its_end(quiet):
    from ros_stage import until

    goal = quiet.go(20)
    assert goal.result(20.0).state == "succeeded"
    until(lambda: [each["state"] for each in list(quiet.server.said)] == ["driving", "succeeded"])


def test_a_goal_that_fails_says_so(quiet):
    goal = quiet.go(17)
    assert goal.result(20.0).state == "aborted"
    assert goal.reason == "robot_error"
    assert "gave up" in goal.detail


def test_a_goal_that_is_refused_says_so(quiet):
    if quiet.keeper._link.names_goals:
        goal = quiet.go(-1)
        assert goal.result(20.0).state == "aborted"
        assert goal.detail == "the navigation server refused the goal"


def test_progress_is_told(quiet):
    if quiet.keeper._link.names_goals:
        task = quiet.robot.navigate(Pose(2000.0, 0.0, 0.0))
        seen = set()
        while task.state is TaskState.RUNNING and len(seen) <= 10:
            seen.add(task.progress)
            time.sleep(0.01)
        numbers = [value for value in seen if value is not None]
        assert len(numbers) > 5
        assert all(0.0 <= value <= 1.0 for value in numbers)


def test_cancel_ends_the_goal_of_the_server(quiet):
    from ros_stage import until

    goal = quiet.go(2000)
    until(lambda: quiet.server.driving() == 1)
    quiet.executor.cancel(goal)
    assert goal.result(20.0).state == "canceled"
    until(lambda: quiet.server.count("canceled") == 1)


def test_a_newer_goal_takes_the_place_of_the_older(quiet):
    from ros_stage import until

    first = quiet.go(2000)
    until(lambda: quiet.server.driving() == 1)
    second = quiet.go(21)
    assert second.result(20.0).state == "succeeded"
    assert (first.state, first.reason) == ("canceled", "preempted")
    states = ["driving", "canceled", "driving", "succeeded"]
    until(lambda: [each["state"] for each in list(quiet.server.said)] == states)


def test_a_goal_given_right_after_a_stop_is_driven(quiet):
    """The cancels of the stop must not reach what came after it."""
    for _ in range(20):
        quiet.server.said.clear()
        first = quiet.go(2000)
        quiet.executor.stop()
        second = quiet.go(5)
        assert second.result(20.0).state == "succeeded", second
        assert first.state == "canceled"


def test_stop_ends_goals_of_others_too(quiet):
    from rclpy.action import ActionClient
    from ros_stage import until
    from test_msgs.action import Fibonacci

    client = ActionClient(quiet.peer.node, Fibonacci, "navigate_to_pose")
    until(client.server_is_ready)
    client.send_goal_async(Fibonacci.Goal(order=2000))
    until(lambda: quiet.server.driving() == 1)
    quiet.executor.stop()
    until(lambda: quiet.server.count("canceled") == 1)
    client.destroy()


def test_a_goal_stopped_at_once_never_goes_on(quiet):
    """Each would drive for 20 s. They are stopped between at once and when they are being driven."""
    from ros_stage import until

    chance = random.Random(5)
    for trial in range(TRIALS):
        goal = quiet.go(2000)
        time.sleep(chance.choice([0.0, 0.0, chance.uniform(0.0, 0.003), chance.uniform(0.0, 0.03)]))
        quiet.executor.stop()
        assert goal.state == "canceled"
        assert quiet.robot.navigation.wait(10.0), f"trial {trial}"
    quiet.server.told()
    until(lambda: quiet.server.driving() == 0, "goals left driving")
    time.sleep(0.5)  # one that came late would be driving now
    quiet.server.told()
    assert quiet.server.driving() == 0
    assert quiet.server.count("succeeded", "aborted") == 0
    assert quiet.server.count("driving") == quiet.server.count("canceled")
    # The trials must have been trials: most goals have reached the server.
    assert quiet.server.count("driving") > TRIALS * 0.5


@pytest.mark.parametrize("way", WAYS)
def test_a_server_that_goes_away_is_noticed(way):
    """One that is killed is noticed too, when the middleware has given it up (20 s with Fast DDS)."""
    from ros_stage import until

    stage = Stage(way)
    try:
        goal = stage.go(2000)
        until(lambda: stage.server.driving() == 1)
        stage.server.leave()
        assert goal.result(60.0).state == "aborted"
        assert "gone" in goal.detail
        goal = stage.go(10)
        assert goal.result(20.0).state == "aborted"
        assert "is the navigation running" in goal.detail
    finally:
        stage.close()


@pytest.mark.parametrize("way", WAYS)
def test_a_server_that_is_started_anew_ends_the_goal_and_drives_the_next(way):
    """What it was doing it has forgotten; the robot that said so is told where to go again."""
    from ros_stage import Server, until

    stage = Stage(way)
    try:
        goal = stage.go(2000)
        until(lambda: stage.server.driving() == 1)
        stage.server.end()
        stage.server = Server(stage.peer.namespace, "goal_pose")
        assert goal.result(60.0).state == "aborted", goal
        until(lambda: stage.server.said)
        until(lambda: not stage.keeper._link.unavailable(), "the new server is there")
        assert stage.go(10).result(20.0).state == "succeeded"
    finally:
        stage.close()


@pytest.mark.parametrize("way", WAYS)
def test_a_goal_that_is_being_accepted_when_the_program_ends_is_not_driven(way):
    from ros_stage import until

    slow = Stage(way, "slow")
    try:
        slow.go(500)
        until(lambda: any("asked" in each for each in slow.server.said))
        slow.executor.close()
        slow.robot.close()
        assert slow.robot.navigation.wait(0.0), "closed before the goal was known to have ended"
        # The server tells it to us (its standard output) after it has told it to the robot (its status).
        until(lambda: slow.server.count("canceled") == 1, "the goal is canceled")
        assert slow.server.count("driving") == 1
    finally:
        slow.close()
