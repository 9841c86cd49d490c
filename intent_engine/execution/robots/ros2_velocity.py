"""Velocities as ``Twist`` or ``TwistStamped``, for the ROS 2 robot and for the guardian's process."""

from __future__ import annotations

import contextlib
import logging
import math
import threading
from enum import StrEnum
from typing import Any

from intent_engine.errors import RobotError
from intent_engine.execution.robots.ros2_support import acknowledge, import_rclpy, own_node

__all__ = ["GUARDIAN_SINK", "Ros2Velocity", "Stamped", "TwistWriter"]

log = logging.getLogger(__name__)

GUARDIAN_SINK = "intent_engine.execution.robots.ros2_velocity:Ros2Velocity"
"""For ``Guardian(GUARDIAN_SINK, {"topic": "/cmd_vel"})``."""


class Stamped(StrEnum):
    """Which message a velocity is sent as."""

    TRUE = "true"
    """``geometry_msgs/TwistStamped``: ros2_control since Jazzy, Nav2 since Kilted."""
    FALSE = "false"
    """``geometry_msgs/Twist``: most bases before."""
    AUTO = "auto"
    """What is subscribed to, now and whenever that changes; Twist, as long as nobody listens."""


_TYPES = {Stamped.FALSE: "geometry_msgs/msg/Twist", Stamped.TRUE: "geometry_msgs/msg/TwistStamped"}


class TwistWriter:
    """Publishes velocities of one node. Thread-safe.

    Args:
        node: an rclpy node; need not be spun.
        topic: relative names can be remapped.
        stamped: see :class:`Stamped`.
        frame_id: of the stamped message.
    """

    LOOK_PERIOD = 0.25
    """s between two looks at who subscribes, with ``auto``"""
    PATIENCE = 0.02
    """s that a write waits for another thread's"""

    def __init__(
        self, node: Any, topic: str = "cmd_vel", stamped: Stamped | str = Stamped.AUTO, frame_id: str = "base_link"
    ) -> None:
        from geometry_msgs.msg import Twist, TwistStamped

        self._node, self._name, self.frame_id = node, topic, frame_id
        self._classes = {Stamped.FALSE: Twist, Stamped.TRUE: TwistStamped}
        self._stamped = Stamped(str(stamped).lower())
        # Re-entrant: a signal handler may stop the robot in the middle of a write.
        self._lock = threading.RLock()
        self._told = False
        self._kind = self._wanted(Stamped.FALSE)
        self._publisher = self._make(self._kind)
        self.topic: str = self._publisher.topic_name
        """The whole name, remapped."""
        self._closed = threading.Event()
        self._thread: threading.Thread | None = None
        if self._stamped is Stamped.AUTO:
            self._thread = threading.Thread(target=self._keep_looking, name="cmd_vel-type", daemon=True)
            self._thread.start()

    def write(self, linear: float, angular: float) -> None:
        """Publish one velocity.

        Raises:
            RobotError: not a number, or the node is gone.
        """
        if not (math.isfinite(linear) and math.isfinite(angular)):
            raise RobotError(f"velocity({linear}, {angular}): not numbers to drive by")
        # The lock is for a change of the type alone; a write that hangs must not keep a stop from the robot.
        locked = self._lock.acquire(timeout=self.PATIENCE)
        try:
            self._publisher.publish(self._message(float(linear), float(angular)))
        except Exception as error:  # rclpy raises InvalidHandle, RCLError and others, of no common kind
            raise RobotError(f"{self.topic} cannot be written: {error}") from error
        finally:
            if locked:
                self._lock.release()

    @property
    def listeners(self) -> int:
        """Who subscribes to what is written."""
        with self._lock:
            return int(self._publisher.get_subscription_count())

    @property
    def stamped(self) -> bool:
        """Whether it writes ``TwistStamped`` at present."""
        return self._kind is Stamped.TRUE

    def close(self) -> None:
        """Wait for the last message to arrive, and let go."""
        if self._closed.is_set():
            return
        self._closed.set()
        if self._thread is not None:
            self._thread.join(1.0)
        self.acknowledge()
        with contextlib.suppress(Exception):
            self._node.destroy_publisher(self._publisher)

    def acknowledge(self, timeout: float = 0.3) -> bool:
        """Wait for the last message to arrive, for ``timeout`` s at the most; whether it has, where the middleware can
        tell."""
        return acknowledge(self._publisher, timeout)

    def _message(self, linear: float, angular: float) -> Any:
        message = self._classes[self._kind]()
        twist = message
        if self._kind is Stamped.TRUE:
            message.header.stamp = self._node.get_clock().now().to_msg()
            message.header.frame_id = self.frame_id
            twist = message.twist
        twist.linear.x, twist.angular.z = linear, angular
        return message

    def _make(self, kind: Stamped) -> Any:
        from rclpy.event_handler import PublisherEventCallbacks
        from rclpy.qos import QoSProfile, ReliabilityPolicy

        # Only the newest velocity is worth anything; and a zero must arrive.
        profile = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE)
        # A publisher whose events are waited for lives on, in the wait, after it was destroyed.
        quiet = PublisherEventCallbacks(use_default_callbacks=False)
        return self._node.create_publisher(self._classes[kind], self._name, profile, event_callbacks=quiet)

    def _keep_looking(self) -> None:
        while not self._closed.wait(self.LOOK_PERIOD):
            try:
                self._look()
            except Exception:
                if self._node.context.ok():  # else the program ends
                    log.warning("cannot see who subscribes to %s", self.topic, exc_info=True)
                return

    def _look(self) -> None:
        """Write what is subscribed to. Fast DDS lets one program have only one type on a topic, so never both."""
        kind = self._wanted(self._kind)
        if kind is self._kind:
            return
        with self._lock:
            before = self._kind
            self._node.destroy_publisher(self._publisher)
            try:
                self._publisher, self._kind = self._make(kind), kind
            except Exception:
                self._publisher = self._make(before)
                raise
        log.info("%s: %s", self.topic, _TYPES[kind])

    def _wanted(self, present: Stamped) -> Stamped:
        if self._stamped is not Stamped.AUTO:
            return self._stamped
        types = {info.topic_type for info in self._node.get_subscriptions_info_by_topic(self._name)}
        wanted = {kind for kind, name in _TYPES.items() if name in types}
        if len(wanted) == 1:
            return wanted.pop()
        if wanted and not self._told:
            self._told = True
            log.warning("Twist and TwistStamped are both subscribed to: say with 'stamped' which one the robot takes")
        return present


class Ros2Velocity:
    """A ROS node of its own that does nothing but write velocities: what the guardian's process drives.

    Args:
        topic: the whole name; nothing is remapped here.
        stamped, frame_id: as :class:`TwistWriter`.
        node_name, namespace: of the node.
    """

    def __init__(
        self,
        topic: str = "/cmd_vel",
        stamped: str = "auto",
        frame_id: str = "base_link",
        node_name: str = "intent_engine_velocity",
        namespace: str = "",
    ) -> None:
        import_rclpy()
        self._context, self._node = own_node(node_name, namespace)
        self._writer = TwistWriter(self._node, topic, stamped, frame_id)

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        self._writer.write(linear, angular)

    def stop(self) -> None:
        self._writer.write(0.0, 0.0)

    def close(self) -> None:
        self._writer.close()
        with contextlib.suppress(Exception):
            self._node.destroy_node()
            self._context.shutdown()
