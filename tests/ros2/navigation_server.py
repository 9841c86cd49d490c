"""Stands in for Nav2: a real action server ``navigate_to_pose``, run as a program of its own.

With ``nav2`` its type is Nav2's; without, it is one of test_msgs, which is in a wheel: the protocol around it (UUIDs,
acceptance, status, cancel, result) is the same for every action. A goal at x = N "drives" for N hundredths of a
second; one that ends in 7 fails, one below zero is refused. With ``goal_pose`` it also does what Nav2's bt_navigator
does with that topic: sends the goal to itself, through a client of its own.

With ``slow`` it says so when it is asked for a goal, and takes a while to accept it.

Prints a JSON line for each goal that begins or ends, so that what it did is not hearsay; before it tells that to who
gave the goal, so that what they know has been printed. Answers each line that it is given with one of its own, so that
it is known what has been read of it.
"""

from __future__ import annotations

import contextlib
import json
import sys
import threading
import time

import rclpy
from geometry_msgs.msg import PoseStamped
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.impl.implementation_singleton import rclpy_implementation

RCLError = rclpy_implementation.RCLError
_saying = threading.Lock()


def say(**what) -> None:
    """One line, whole: ``print`` writes its end apart, and two goals that say something at once would mix theirs."""
    with _saying:
        sys.stdout.write(json.dumps(what) + "\n")
        sys.stdout.flush()


class Counted:
    """test_msgs/Fibonacci: the order is the length of the drive."""

    def __init__(self) -> None:
        from test_msgs.action import Fibonacci

        self.type = Fibonacci

    def goal(self, pose):
        return self.type.Goal(order=int(pose.pose.position.x))

    def order(self, request) -> int:
        return request.order

    def told(self, request) -> dict:
        return {}

    def feedback(self, left: float):
        return self.type.Feedback(sequence=[int(left * 1000)])

    def failure(self):
        return self.type.Result()


class Nav2:
    """nav2_msgs/NavigateToPose, at a metre a second."""

    def __init__(self) -> None:
        from nav2_msgs.action import NavigateToPose

        self.type = NavigateToPose

    def goal(self, pose):
        return self.type.Goal(pose=pose)

    def order(self, request) -> int:
        return int(request.pose.pose.position.x)

    def told(self, request) -> dict:
        pose = request.pose.pose
        return {
            "frame": request.pose.header.frame_id,
            "at": [pose.position.x, pose.position.y],
            "facing": [pose.orientation.z, pose.orientation.w],
        }

    def feedback(self, left: float):
        message = self.type.Feedback(distance_remaining=left)
        message.current_pose.header.frame_id = "map"
        message.current_pose.pose.position.x = 1.5
        return message

    def failure(self):
        return self.type.Result(error_code=9002, error_msg="the map has no way there")


def begin(handle) -> None:
    """Drive an accepted goal. rclpy looks whether it is to be canceled and changes its state in two steps; where the
    cancellation comes between them it raises, and sees it when it is asked again."""
    try:
        handle.execute()
    except RCLError:
        handle.execute()


def answer() -> None:
    for line in sys.stdin:
        say(heard=int(line))


def main() -> None:
    threading.Thread(target=answer, daemon=True).start()
    rclpy.init()
    node = rclpy.create_node("navigation")
    group = ReentrantCallbackGroup()
    kind = Nav2() if "nav2" in sys.argv else Counted()

    def drive(handle):
        uuid = bytes(handle.goal_id.uuid).hex()
        order = kind.order(handle.request)
        say(goal=uuid, state="driving", order=order, **kind.told(handle.request))
        end = time.monotonic() + order * 0.01
        while (left := end - time.monotonic()) > 0:
            if handle.is_cancel_requested:
                say(goal=uuid, state="canceled", order=order)
                handle.canceled()
                return kind.type.Result()
            handle.publish_feedback(kind.feedback(left))
            time.sleep(min(0.005, left))
        if order % 10 == 7:
            say(goal=uuid, state="aborted", order=order)
            handle.abort()
            return kind.failure()
        say(goal=uuid, state="succeeded", order=order)
        handle.succeed()
        return kind.type.Result()

    def accept(goal):
        if "slow" in sys.argv:
            say(asked=True)
            time.sleep(2.0)
        return GoalResponse.REJECT if kind.order(goal) < 0 else GoalResponse.ACCEPT

    ActionServer(
        node,
        kind.type,
        "navigate_to_pose",
        drive,
        callback_group=group,
        goal_callback=accept,
        handle_accepted_callback=begin,
        cancel_callback=lambda handle: CancelResponse.ACCEPT,
    )
    if "goal_pose" in sys.argv:
        own = ActionClient(node, kind.type, "navigate_to_pose", callback_group=group)
        node.create_subscription(
            PoseStamped, "goal_pose", lambda pose: own.send_goal_async(kind.goal(pose)), 10, callback_group=group
        )
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(node)
    say(ready=True)
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        executor.spin()


if __name__ == "__main__":
    main()
