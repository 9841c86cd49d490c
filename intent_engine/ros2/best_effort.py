"""Hears a topic from publishers that are reliable, and from those that are not.

In DDS a reliable subscription is not connected to a publisher of best effort (``qos_profile_sensor_data``), whose stop
would go unheard; and one of best effort hears everybody, but may lose what a reliable publisher says. So the second is
made where it is needed, beside the first, and what comes by both counts once: it is known by the time at which it was
published, or by its publisher and number. Where a middleware tells neither, the same words that come by the other way
within a second are taken for the same message, unless they stop the robot: a stop that is done twice costs nothing, and
one that is taken for another's is not done.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from typing import Any

from intent_engine.ros2.clock import mark_of

__all__ = ["HearAll", "Pairs"]


class Pairs:
    """Messages of which nobody tells what they are, each by the way by which it came first."""

    WINDOW = 1.0
    """s between the two ways of one message."""

    def __init__(self) -> None:
        self._waiting: deque[tuple[Any, bool, float]] = deque()

    def completes(self, message: Any, way: bool, now: float) -> bool:
        """Whether the message is the second of a pair: the same has come by the other way, and not been paired yet.

        Args:
            message: as it came.
            way: one of two.
            now: s, of any clock.
        """
        while self._waiting and now - self._waiting[0][2] > self.WINDOW:
            self._waiting.popleft()
        for each in self._waiting:
            if each[1] is not way and each[0] == message:
                self._waiting.remove(each)
                return True
        self._waiting.append((message, way, now))
        return False


class HearAll:
    """Calls a function with each message on a topic, in the thread that spins the node.

    Args:
        node: an rclpy node.
        kind: type of the messages.
        topic: relative names can be remapped.
        heard: is given a message and what the middleware says of it.
        stops: whether a message is one that is heard in any case: it may be taken for another's.
    """

    LOOK_PERIOD = 0.5
    """s between two looks at who publishes"""
    DEPTH = 10
    """messages that may wait"""

    def __init__(
        self,
        node: Any,
        kind: Any,
        topic: str,
        heard: Callable[[Any, Any], object],
        stops: Callable[[Any], object] = lambda message: True,
    ) -> None:
        from rclpy.clock import Clock, ClockType

        self._node, self._kind, self._name, self._heard, self._stops = node, kind, topic, heard, stops
        self._pairs = Pairs()
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

    def _hear(self, message: Any, info: Any, reliable: bool) -> None:
        mark = mark_of(info)
        if mark is None and self._pairs.completes(message, reliable, time.monotonic()) and not self._stops(message):
            return
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

        def hear(message: Any, info: Any) -> None:
            self._hear(message, info, reliable)

        return self._node.create_subscription(self._kind, self._name, hear, profile, event_callbacks=quiet)
