"""A program that shuts rclpy down while the robot moves, and only then, or never, closes its executor."""

from __future__ import annotations

import contextlib
import sys
import threading
import time

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.signals import SignalHandlerOptions

from intent_engine import Executor, Move, Navigate
from intent_engine.execution.robots.ros2 import Ros2Robot


def spin(node: rclpy.node.Node) -> None:
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    with contextlib.suppress(ExternalShutdownException):
        executor.spin()


def main() -> None:
    words = set(sys.argv)
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    node = rclpy.create_node("program")
    robot = Ros2Robot(node, navigation="goal_pose" if "navigate" in words else "none")
    loop = None
    if "guardian" in words:
        from intent_engine.execution.guardian import Guardian
        from intent_engine.execution.robots.ros2_velocity import GUARDIAN_SINK

        loop = Guardian(GUARDIAN_SINK, {"topic": robot.topic})
    executor = Executor(robot, loop=loop)
    spinning = threading.Thread(target=spin, args=(node,))
    spinning.start()
    if robot.navigation is not None:
        while robot.navigation._link.unavailable():
            time.sleep(0.02)
    print("ready", flush=True)
    sys.stdin.readline()
    goal_of = Navigate("far", 90000.0, 0.0, 0.0) if "navigate" in words else Move(0.5, 50.0, 100.0)
    (goal,) = executor.submit(goal_of)
    sys.stdin.readline()
    if "silently" in words:  # as a signal's handler of rclpy's does, which is C and calls nobody
        node.context.handle.shutdown()
    else:
        rclpy.shutdown()
    spinning.join(30.0)
    sys.stdout.write(f"ended: {goal.result(30.0).reason}\n")  # whole: others write, too
    (late,) = executor.submit(goal_of)
    sys.stdout.write(f"late: {late.result(30.0).detail}\n") if loop is None else executor.stop()
    begin = time.monotonic()
    if "close" in words:
        executor.close()
        robot.close()
    print(f"closed: {time.monotonic() - begin < 10.0}", flush=True)


main()
