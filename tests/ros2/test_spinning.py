"""A node that is spun in a thread can be destroyed at any moment."""

from __future__ import annotations

import threading
import time

import pytest

pytestmark = pytest.mark.ros2


def test_it_ends_whenever_it_is_told_to() -> None:
    import rclpy

    from intent_engine.execution.robots.ros2_spinning import Spinning
    from intent_engine.execution.robots.ros2_support import own_node

    for turn in range(40):
        context, node = own_node(f"spun_{turn}")
        spinning = Spinning(node)
        time.sleep(0.001 * (turn % 4))
        assert spinning.end()
        node.destroy_node()
        rclpy.shutdown(context=context)


def test_a_callback_that_raises_ends_it_and_is_told() -> None:
    import rclpy
    from std_msgs.msg import Empty

    from intent_engine.execution.robots.ros2_spinning import Spinning
    from intent_engine.execution.robots.ros2_support import own_node

    context, node = own_node("failing")
    errors: list[Exception] = []
    over = threading.Event()

    def fail(_: object) -> None:
        raise ValueError("no good")

    node.create_subscription(Empty, "anything", fail, 1)
    publisher = node.create_publisher(Empty, "anything", 1)
    spinning = Spinning(node, failed=errors.append, over=over.set)
    end = time.monotonic() + 60
    while not over.wait(0.05):
        publisher.publish(Empty())
        assert time.monotonic() < end
    assert [str(error) for error in errors] == ["no good"]
    assert spinning.end()
    node.destroy_node()
    rclpy.shutdown(context=context)
