"""Navigation of a ROS 2 robot: ``NavigateToPose`` where nav2_msgs is installed, else ``goal_pose``.

Both speak the action protocol itself (its two services, its two topics) and not through ``rclpy.action.ActionClient``:
a goal is known by its own UUID from the moment it is sent, and one that somebody else's client sends (Nav2's, when it
hears a ``goal_pose``) can be watched and ended in the same way without any type but those of ``action_msgs``.
"""

from __future__ import annotations

import logging
import queue
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from intent_engine.errors import RobotError
from intent_engine.execution.robots.goal_keeper import GoalKeeper
from intent_engine.execution.robots.remote_task import RemoteTask
from intent_engine.execution.robots.robot import Pose
from intent_engine.execution.robots.ros2_support import fill_pose, pose_of

__all__ = ["NavigationAction", "NavigationWay", "Ros2Navigation", "nav2_action"]

log = logging.getLogger(__name__)


class NavigationWay(StrEnum):
    """How a goal is given to the navigation."""

    AUTO = "auto"
    """``action`` where nav2_msgs is installed, else ``goal_pose``."""
    ACTION = "action"
    """Nav2's action, with feedback and reasons."""
    GOAL_POSE = "goal_pose"
    """The topic that RViz uses too; needs no types of Nav2."""
    NONE = "none"
    """This robot does not navigate."""


@dataclass(frozen=True, slots=True)
class NavigationAction:
    """What has to be known of an action's type."""

    type: Any
    """The action, as ``nav2_msgs.action.NavigateToPose``"""
    make_goal: Callable[[Any], Any]
    """From a ``geometry_msgs/PoseStamped``"""
    distance_left: Callable[[Any], float] = lambda feedback: float("nan")
    """m, from its feedback"""
    pose: Callable[[Any], Pose | None] = lambda feedback: None
    """Where the robot is, from its feedback"""
    reason: Callable[[Any], str] = lambda result: ""
    """Why it failed, from its result"""


def nav2_action() -> NavigationAction | None:
    """Nav2's ``NavigateToPose``; None where nav2_msgs is not installed."""
    try:
        from nav2_msgs.action import NavigateToPose
    except ImportError:
        return None

    def make_goal(pose: Any) -> Any:
        goal = NavigateToPose.Goal()
        goal.pose = pose
        return goal

    def reason(result: Any) -> str:
        # The fields came with Iron (code) and Kilted (text).
        text = str(getattr(result, "error_msg", ""))
        code = int(getattr(result, "error_code", 0))
        return text or (f"the navigation gave up with Nav2's error code {code}" if code else "")

    return NavigationAction(
        NavigateToPose,
        make_goal,
        lambda feedback: float(feedback.distance_remaining),
        lambda feedback: pose_of(feedback.current_pose.pose, feedback.current_pose.header.frame_id or "map"),
        reason,
    )


class _Link:
    """The roads to the navigation server. Called by the navigation's thread; what is heard goes into its queue."""

    def __init__(
        self, node: Any, put: Callable[[Callable[[GoalKeeper, float], None]], None], action: NavigationAction | None,
        name: str, goal_topic: str,
    ) -> None:  # fmt: skip
        from action_msgs.msg import GoalStatusArray
        from action_msgs.srv import CancelGoal
        from geometry_msgs.msg import PoseStamped
        from rclpy.qos import DurabilityPolicy, QoSProfile

        self.names_goals = action is not None
        self.pose: Pose | None = None
        """Where the robot is, as the last feedback said."""
        self._node, self._put, self._action, self._name = node, put, action, name
        self._pose_stamped, self._cancel_goal = PoseStamped, CancelGoal
        self._goal_topic = goal_topic
        self._canceller = node.create_client(CancelGoal, f"{name}/_action/cancel_goal")
        self.cancel_service = str(node.resolve_service_name(f"{name}/_action/cancel_goal"))
        """Where goals are cancelled."""
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._made = [
            node.create_subscription(GoalStatusArray, f"{name}/_action/status", self._heard_status, latched),
        ]
        if action is None:
            self._goals = node.create_publisher(PoseStamped, goal_topic, 1)
        else:
            kinds = action.type.Impl
            self._sender = node.create_client(kinds.SendGoalService, f"{name}/_action/send_goal")
            self._results = node.create_client(kinds.GetResultService, f"{name}/_action/get_result")
            self._made.append(
                node.create_subscription(kinds.FeedbackMessage, f"{name}/_action/feedback", self._heard_feedback, 10)
            )

    @property
    def open(self) -> bool:
        """Whether the middleware is; where it was closed before us, nothing can be asked of the server any more."""
        return bool(self._node.context.ok())

    def unavailable(self) -> str:
        if not self._canceller.service_is_ready():
            return f"no action server {self._name}; is the navigation running, and active?"
        if self._action is None:
            if not self._goals.get_subscription_count():
                return f"nobody listens to {self._goal_topic}; is the navigation running, and active?"
        elif not self._sender.service_is_ready():
            return f"the action server {self._name} takes no goals; is the navigation active?"
        return ""

    def servers(self) -> frozenset[bytes]:
        there = self._node.get_publishers_info_by_topic(f"{self._name}/_action/status")
        return frozenset(bytes(each.endpoint_gid) for each in there)

    def send(self, goal: Pose, uuid: bytes) -> None:
        stamped = self._pose_stamped()
        stamped.header.frame_id = goal.frame
        stamped.header.stamp = self._node.get_clock().now().to_msg()
        fill_pose(stamped.pose, goal)
        if self._action is None:
            self._goals.publish(stamped)
            return
        request = self._action.type.Impl.SendGoalService.Request()
        request.goal_id.uuid = list(uuid)
        request.goal = self._action.make_goal(stamped)
        self._sender.call_async(request).add_done_callback(lambda future: self._heard_answer(uuid, future))

    def cancel(self, uuid: bytes | None, number: int) -> bool:
        if not self._canceller.service_is_ready():
            return False
        request = self._cancel_goal.Request()  # a UUID of zeros, and no time: all goals
        if uuid is not None:
            request.goal_info.goal_id.uuid = list(uuid)
        future = self._canceller.call_async(request)
        future.add_done_callback(lambda future: self._heard_cancel(number, future))
        return True

    # -- heard, in the thread that spins the node ----------------------------------------------------------------------

    def _heard_status(self, message: Any) -> None:
        # Servers keep their goals in no order; ours, where it has to be guessed, is the first new one.
        listed = sorted(message.status_list, key=lambda each: (each.goal_info.stamp.sec, each.goal_info.stamp.nanosec))
        statuses = {bytes(each.goal_info.goal_id.uuid): int(each.status) for each in listed}
        self._put(lambda keeper, now: keeper.heard_status(statuses, now))

    def _heard_answer(self, uuid: bytes, future: Any) -> None:
        if future.exception() is not None or future.result() is None:
            return
        accepted = bool(future.result().accepted)
        self._put(lambda keeper, now: keeper.heard_answer(uuid, accepted, now))
        if accepted and self._action is not None:
            request = self._action.type.Impl.GetResultService.Request()
            request.goal_id.uuid = list(uuid)
            self._results.call_async(request).add_done_callback(lambda future: self._heard_result(uuid, future))

    def _heard_cancel(self, number: int, future: Any) -> None:
        if future.exception() is None and future.result() is not None:
            refused = future.result().return_code == self._cancel_goal.Response.ERROR_REJECTED
            self._put(lambda keeper, now: keeper.heard_cancel(number, refused, now))

    def _heard_result(self, uuid: bytes, future: Any) -> None:
        if future.exception() is not None or future.result() is None or self._action is None:
            return
        code, reason = int(future.result().status), self._action.reason(future.result().result)
        self._put(lambda keeper, now: keeper.heard_result(uuid, code, reason, now))

    def _heard_feedback(self, message: Any) -> None:
        assert self._action is not None
        uuid, left = bytes(message.goal_id.uuid), self._action.distance_left(message.feedback)
        self.pose = self._action.pose(message.feedback) or self.pose
        self._put(lambda keeper, now: keeper.heard_progress(uuid, left))


class Ros2Navigation:
    """Navigation goals of one node, kept by a thread of its own.

    Life cycle: made -> ``navigate``, ``cancel``, ``stop`` from any thread, while the node is spun -> ``close``.

    Args:
        node: an rclpy node that somebody spins.
        way: how goals are given.
        name: of the action.
        goal_topic: for :attr:`NavigationWay.GOAL_POSE`.
        action: the action's type, if it is not Nav2's.

    Raises:
        RobotError: the action is wanted, and its type is not installed.
    """

    CLOSE = 4.0
    """s that :meth:`close` waits for goals to end: a busy server accepts a goal late, and then drives. ``ros2 launch``
    asks again after 5 s, and kills after 10 s."""

    def __init__(
        self,
        node: Any,
        way: NavigationWay | str = NavigationWay.AUTO,
        name: str = "navigate_to_pose",
        goal_topic: str = "goal_pose",
        action: NavigationAction | None = None,
    ) -> None:
        way = NavigationWay(way)
        found = (action or nav2_action()) if way is not NavigationWay.GOAL_POSE else None
        if way is NavigationWay.ACTION and found is None:
            raise RobotError(
                "navigation is to be an action, and nav2_msgs is not installed\n"
                "    install it (apt install ros-$ROS_DISTRO-nav2-msgs), or let navigation be goal_pose"
            )
        self.way = NavigationWay.ACTION if found is not None else NavigationWay.GOAL_POSE
        # Re-entrant: a signal handler may stop the robot in the middle of a put.
        self._inbox: queue.SimpleQueue[Callable[[GoalKeeper, float], None] | threading.Event | None]
        self._inbox = queue.SimpleQueue()
        self._link = _Link(node, self._inbox.put, found, name, goal_topic)
        self._keeper = GoalKeeper(self._link)
        self._numbers = 0
        self.when_gone: Callable[[], object] = lambda: None
        """Called when the middleware turns out to be closed, and the server cannot be asked any more."""
        self._thread = threading.Thread(target=self._run, name="navigation", daemon=True)
        self._thread.start()

    @property
    def pose(self) -> Pose | None:
        """Where the robot is, as the last feedback of a goal said."""
        return self._link.pose

    @property
    def quiet(self) -> bool:
        """Whether no goal is driven, or is to be ended. Once the middleware is closed, nothing changes in that."""
        return self._keeper.quiet

    @property
    def cancel_service(self) -> str:
        """The whole name of the service that cancels goals."""
        return self._link.cancel_service

    def navigate(self, goal: Pose) -> RemoteTask:
        self._numbers += 1
        task = RemoteTask(self._numbers)
        self._inbox.put(lambda keeper, now: keeper.navigate(task, goal, now))
        return task

    def cancel(self, task: RemoteTask) -> None:
        self._inbox.put(lambda keeper, now: keeper.cancel(task, now))

    def stop(self) -> None:
        """End every goal of the server. Takes no lock."""
        self._inbox.put(lambda keeper, now: keeper.stop(now))

    def wait(self, timeout: float) -> bool:
        """Wait until no goal has to be ended any more, and none is driven, after all that was asked for until now.

        Returns:
            False if ``timeout`` s went by first.
        """
        quiet = threading.Event()
        self._inbox.put(quiet)
        if self._thread.is_alive():
            return quiet.wait(timeout)
        return self._keeper.quiet or not self._link.open

    def close(self) -> None:
        """End every goal, and the thread."""
        if self._thread.is_alive():
            self.stop()
            if not self.wait(self.CLOSE):
                log.error(
                    "a navigation goal has not confirmed its end within %g s, and may be driven: cancel it in RViz, or "
                    "call the service %s",
                    self.CLOSE,
                    self._link.cancel_service,
                )
            self._inbox.put(None)
            self._thread.join(1.0)

    def _run(self) -> None:
        waiting: list[threading.Event] = []
        while True:
            due = self._keeper.due(time.monotonic())
            while waiting and due is None:
                waiting.pop().set()
            try:
                item = self._inbox.get(timeout=None if due is None else max(due - time.monotonic(), 0.0))
            except queue.Empty:
                item = GoalKeeper.step
            if item is None:
                return
            if isinstance(item, threading.Event):
                waiting.append(item)
                continue
            try:
                item(self._keeper, time.monotonic())
            except Exception:
                if not self._link.open:
                    self.when_gone()
                    self._keeper.lost("the middleware was shut down")
                    for each in waiting:
                        each.set()  # nothing can be asked of the server any more
                    return
                # A callback raised: what must end is tried again at the next step.
                log.exception("navigation")
                time.sleep(GoalKeeper.RESEND)
