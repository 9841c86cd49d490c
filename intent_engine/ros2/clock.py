"""Time in ROS: for the executor, where with ``use_sim_time`` a second is one of the simulator, and of messages."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

__all__ = ["RosClock", "mark_of", "sent_at"]


class RosClock:
    """The clock of a node, made to only grow.

    When the simulator is reset its time goes back: then this clock goes on from where it was, and ``on_reset`` is
    called, in the thread that spins the node.

    Args:
        node: an rclpy node that somebody spins.
    """

    POLL = 0.005
    """s of real time between two looks at a simulated clock, which may run at any speed."""

    def __init__(self, node: Any) -> None:
        from rclpy.clock import JumpThreshold
        from rclpy.duration import Duration

        self._clock = node.get_clock()
        self._lock = threading.Lock()
        self._ahead = 0.0
        """s by which this clock is ahead of ROS time, after resets"""
        self._last = 0.0
        self.on_reset: Callable[[], object] = lambda: None
        back = JumpThreshold(min_forward=None, min_backward=Duration(nanoseconds=-1), on_clock_change=True)
        self._handle = self._clock.create_jump_callback(back, post_callback=lambda jump: self._jumped())
        self._last = self._ros()

    @property
    def runs(self) -> bool:
        """Whether there is a time at all: in ROS it is 0 until somebody publishes ``/clock``."""
        return self._ros() > 0

    def now(self) -> float:
        with self._lock:
            time = self._ros() + self._ahead
            if time < self._last:
                self._ahead += self._last - time
                time = self._last
            self._last = time
            return time

    def wait_until(self, condition: threading.Condition, deadline: float | None) -> bool:
        if deadline is None:
            condition.wait()
            return False
        if self.now() >= deadline:
            return True
        condition.wait(self.POLL)
        return self.now() >= deadline

    def _ros(self) -> float:
        return float(self._clock.now().nanoseconds) * 1e-9

    def _jumped(self) -> None:
        self.on_reset()


def sent_at(info: Any) -> int:
    """When a message was published, in ns of the publisher's clock; 0: not known.

    Args:
        info: what the middleware says of the message.
    """
    return int(info.get("source_timestamp", 0)) if isinstance(info, dict) else 0


def mark_of(info: Any) -> object:
    """By what a message is the same when it comes a second time, to another subscription; None: nobody can tell.

    Args:
        info: what the middleware says of the message.
    """
    if sent := sent_at(info):
        return sent
    if not isinstance(info, dict) or info.get("publication_sequence_number") is None:
        return None
    who = info.get("publisher_gid")
    data = who.get("data") if isinstance(who, dict) else None
    return (data, info["publication_sequence_number"]) if data is not None else None
