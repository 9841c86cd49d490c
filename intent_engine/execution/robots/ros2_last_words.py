"""Zero velocity, and the end of navigation, when the middleware was shut down before the robot was stopped.

``rclpy.shutdown()`` destroys the nodes of its context before it tells anybody: what the robot has written with so far
is gone. A node in a context of its own says the last words; it has to find those who listen first.
"""

from __future__ import annotations

import contextlib
import time
from typing import Any

from intent_engine.execution.robots.ros2_support import own_node
from intent_engine.execution.robots.ros2_velocity import TwistWriter

__all__ = ["cancel_all", "write_zeros"]

PATIENCE = 5.0
"""s in which somebody who listens is found, and an answer comes."""
GATHER = 0.5
"""s in which all who listen are, once one was found: the base may not be the first."""
PERIOD = 0.05
"""s between two zeros."""


def write_zeros(topic: str, stamped: str, frame_id: str) -> bool:
    """Send zero velocities; whether they have arrived.

    Args:
        topic: the whole name.
        stamped: as what, as ``TwistWriter`` takes it; not ``auto``, since nobody is known yet.
        frame_id: of a stamped one.
    """
    context, node = own_node("intent_engine_last_zero")
    try:
        writer = TwistWriter(node, topic, stamped, frame_id)
        until = time.monotonic() + PATIENCE
        found = False
        while time.monotonic() < until:
            if writer.listeners and not found:
                found, until = True, time.monotonic() + GATHER
            writer.write(0.0, 0.0)
            time.sleep(PERIOD)
        arrived = found and writer.acknowledge(PATIENCE)
        writer.close()
        return arrived
    finally:
        _let_go(context, node)


def cancel_all(service: str) -> bool:
    """Have a navigation server cancel every goal; whether it answered."""
    from action_msgs.srv import CancelGoal
    from rclpy.executors import SingleThreadedExecutor

    context, node = own_node("intent_engine_last_cancel")
    spinner = SingleThreadedExecutor(context=context)
    try:
        spinner.add_node(node)
        client = node.create_client(CancelGoal, service)
        if not client.wait_for_service(PATIENCE):
            return False
        answer = client.call_async(CancelGoal.Request())  # a UUID of zeros, and no time: all goals
        spinner.spin_until_future_complete(answer, PATIENCE)
        return bool(answer.done() and answer.exception() is None)
    finally:
        spinner.shutdown(timeout_sec=PATIENCE)
        _let_go(context, node)


def _let_go(context: Any, node: Any) -> None:
    with contextlib.suppress(Exception):
        node.destroy_node()
        context.shutdown()
