"""Hears a topic from publishers that are reliable, and from those that are not.

In DDS a reliable subscription is not connected to a publisher of best effort (``qos_profile_sensor_data``), whose stop
would go unheard; and one of best effort hears everybody, but may lose what a reliable publisher says. So the second is
made where it is needed, beside the first, and what comes by both counts once.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

from intent_engine.ros2.clock import mark_of

__all__ = ["HearAll"]


class HearAll:
    """Calls a function with each message on a topic, in the thread that spins the node.

    Args:
        node: an rclpy node.
        kind: type of the messages.
        topic: relative names can be remapped.
        heard: is given a message and what the middleware says of it.
    """

    LOOK_PERIOD = 0.5
    """s between two looks at who publishes"""
    DEPTH = 10
    """messages that may wait"""

    def __init__(self, node: Any, kind: Any, topic: str, heard: Callable[[Any, Any], object]) -> None:
        from rclpy.clock import Clock, ClockType

        self._node, self._kind, self._name, self._heard = node, kind, topic, heard
        self._before: deque[object] = deque(maxlen=4 * self.DEPTH)
        """Marks of the messages that came last: each counts once, whoever heard it."""
        self._reliable = self._subscribe(reliable=True)
        self._other: Any = None
        # Of the computer's time: a simulator that is paused keeps no stop from the node.
        node.create_timer(self.LOOK_PERIOD, self._look, clock=Clock(clock_type=ClockType.STEADY_TIME))

    @property
    def topic(self) -> str:
        """Its whole name."""
        return str(self._reliable.topic_name)

    def _hear(self, message: Any, info: Any) -> None:
        mark = mark_of(info)
        if mark is not None:
            if mark in self._before:
                return
            self._before.append(mark)
        self._heard(message, info)

    def _look(self) -> None:
        from rclpy.qos import ReliabilityPolicy

        publishers = self._node.get_publishers_info_by_topic(self.topic)
        wanted = any(each.qos_profile.reliability == ReliabilityPolicy.BEST_EFFORT for each in publishers)
        if wanted and self._other is None:
            self._other = self._subscribe(reliable=False)
        elif not wanted and self._other is not None:
            self._node.destroy_subscription(self._other)
            self._other = None

    def _subscribe(self, reliable: bool) -> Any:
        from rclpy.event_handler import SubscriptionEventCallbacks
        from rclpy.qos import QoSProfile, ReliabilityPolicy

        policy = ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT
        profile = QoSProfile(depth=self.DEPTH, reliability=policy)
        # What the first is not connected to, the second hears: no word of that.
        quiet = SubscriptionEventCallbacks(use_default_callbacks=False)
        return self._node.create_subscription(self._kind, self._name, self._hear, profile, event_callbacks=quiet)
