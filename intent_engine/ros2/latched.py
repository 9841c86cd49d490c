"""Hears a topic from publishers that keep their last message for who comes late, and from those that do not.

In DDS a subscription that asks for kept messages is not connected to a publisher that keeps none, and one that does not
ask for them is given none. So there are two: one hears everybody from now on, reliable or not, the other is made where
somebody keeps messages, and brings what was said before. It is made only there because a publisher that keeps none is
warned of every subscription that asks: "no messages will be sent to it", which is not what happens.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from intent_engine.ros2.best_effort import HearAll
from intent_engine.ros2.clock import sent_at

__all__ = ["HearLatched", "Newest"]


class Newest:
    """Which of what two subscriptions bring is news.

    What comes from now on is, in the order in which it comes. What was kept is news only if it is younger than all of
    that: otherwise it has been heard already, or somebody has said something else since.
    """

    def __init__(self) -> None:
        self._heard = -1

    def live(self, sent: int) -> None:
        """A message came to the subscription that hears everybody.

        Args:
            sent: ns of the publisher's clock; 0: not known.
        """
        self._heard = max(self._heard, sent)

    def kept(self, sent: int) -> bool:
        """Whether a message that came to the other subscription is news.

        Args:
            sent: ns of the publisher's clock; 0: not known.
        """
        return sent > self._heard


class HearLatched:
    """Calls a function with each text on a topic, in the thread that spins the node.

    Args:
        node: an rclpy node.
        topic: of std_msgs/String; relative names can be remapped.
        heard: is given the text. It may be given the same one twice.
    """

    LOOK_PERIOD = 0.5
    """s between two looks at who publishes"""

    def __init__(self, node: Any, topic: str, heard: Callable[[str], object]) -> None:
        from rclpy.clock import Clock, ClockType
        from std_msgs.msg import String

        self._node, self._name, self._heard, self._string = node, topic, heard, String
        self._newest = Newest()
        self._live = HearAll(node, String, topic, self._hear_live)
        self._kept: Any = None
        # Of the computer's time: a simulator that is paused keeps no state from the node.
        node.create_timer(self.LOOK_PERIOD, self._look, clock=Clock(clock_type=ClockType.STEADY_TIME))

    def _hear_live(self, message: Any, info: Any) -> None:
        self._newest.live(sent_at(info))
        self._heard(message.data)

    def _hear_kept(self, message: Any, info: Any) -> None:
        if self._newest.kept(sent_at(info)):
            self._heard(message.data)

    def _look(self) -> None:
        from rclpy.event_handler import SubscriptionEventCallbacks
        from rclpy.qos import DurabilityPolicy, QoSProfile

        latched = DurabilityPolicy.TRANSIENT_LOCAL
        publishers = self._node.get_publishers_info_by_topic(self._live.topic)
        wanted = any(each.qos_profile.durability == latched for each in publishers)
        if wanted and self._kept is None:
            # Only the last message counts. What it is not connected to, the other hears: no word of that.
            self._kept = self._node.create_subscription(
                self._string,
                self._name,
                self._hear_kept,
                QoSProfile(depth=1, durability=latched),
                event_callbacks=SubscriptionEventCallbacks(use_default_callbacks=False),
            )
        elif not wanted and self._kept is not None:
            self._node.destroy_subscription(self._kept)
            self._kept = None
