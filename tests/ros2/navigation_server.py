"""Stands in for Nav2: a real action server ``navigate_to_pose``, run as a program of its own.

nav2_msgs has no wheel, so its type is that of test_msgs; the protocol around it (UUIDs, acceptance, status, cancel,
result) is the same for every action. A goal of order N "drives" for N hundredths of a second. With ``goal_pose`` it
also does what Nav2's bt_navigator does with that topic: sends the goal to itself, through a client of its own.

Prints a JSON line for each goal that begins or ends, so that what it did is not hearsay.
"""

from __future__ import annotations

import contextlib
import json
import sys
import time

import rclpy
from geometry_msgs.msg import PoseStamped
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from test_msgs.action import Fibonacci


def say(**what) -> None:
    print(json.dumps(what), flush=True)


def main() -> None:
    rclpy.init()
    node = rclpy.create_node("navigation")
    group = ReentrantCallbackGroup()

    def drive(handle):
        uuid = bytes(handle.goal_id.uuid).hex()
        order = handle.request.order
        say(goal=uuid, state="driving", order=order)
        result = Fibonacci.Result()
        end = time.monotonic() + order * 0.01
        while (left := end - time.monotonic()) > 0:
            if handle.is_cancel_requested:
                handle.canceled()
                say(goal=uuid, state="canceled", order=order)
                return result
            handle.publish_feedback(Fibonacci.Feedback(sequence=[int(left * 1000)]))
            time.sleep(min(0.005, left))
        if order % 10 == 7:
            handle.abort()
            say(goal=uuid, state="aborted", order=order)
        else:
            handle.succeed()
            say(goal=uuid, state="succeeded", order=order)
        return result

    ActionServer(
        node,
        Fibonacci,
        "navigate_to_pose",
        drive,
        callback_group=group,
        goal_callback=lambda request: GoalResponse.REJECT if request.order < 0 else GoalResponse.ACCEPT,
        cancel_callback=lambda handle: CancelResponse.ACCEPT,
    )
    if "goal_pose" in sys.argv:
        own = ActionClient(node, Fibonacci, "navigate_to_pose", callback_group=group)
        node.create_subscription(
            PoseStamped,
            "goal_pose",
            lambda message: own.send_goal_async(Fibonacci.Goal(order=int(message.pose.position.x))),
            10,
            callback_group=group,
        )
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(node)
    say(ready=True)
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        executor.spin()


if __name__ == "__main__":
    main()
