"""What every part that speaks ROS 2 needs: rclpy, imported only when it is wanted, and help where it is missing."""

from __future__ import annotations

import contextlib
import math
from typing import Any

from intent_engine.errors import RobotError
from intent_engine.execution.robots.robot import Pose

__all__ = ["acknowledge", "fill_pose", "import_rclpy", "own_node", "pose_of", "yaw_of"]


def import_rclpy() -> Any:
    """The module ``rclpy``.

    Raises:
        RobotError: there is no ROS 2 in this Python; says how to get it.
    """
    try:
        import rclpy
    except ImportError as error:
        raise RobotError(
            f"no ROS 2 in this Python ({error})\n"
            "    with a ROS installed: source /opt/ros/<distribution>/setup.bash, and use the Python it came with\n"
            "    without, on Linux x86-64: pip install 'intent-engine[ros2]' in an environment of its own"
        ) from None
    return rclpy


def own_node(name: str, namespace: str = "") -> tuple[Any, Any]:
    """A context and a small node in it, for a part that is no node of the user's.

    The context leaves signals alone: rclpy's own handlers would close it before the last zero is sent.
    """
    rclpy = import_rclpy()
    from rclpy.signals import SignalHandlerOptions

    context = rclpy.Context()
    rclpy.init(args=[], context=context, signal_handler_options=SignalHandlerOptions.NO)
    node = rclpy.create_node(
        name,
        context=context,
        namespace=namespace,
        use_global_arguments=False,
        enable_rosout=False,
        start_parameter_services=False,
    )
    return context, node


def acknowledge(publisher: Any, timeout: float = 0.3) -> bool:
    """Wait until what was published has arrived, for ``timeout`` s at the most; whether it has, where the middleware
    can tell."""
    from rclpy.duration import Duration

    with contextlib.suppress(Exception):  # not every middleware can
        return bool(publisher.wait_for_all_acked(Duration(seconds=timeout)))
    return False


def fill_pose(message: Any, pose: Pose) -> None:
    """Write a pose on the floor into a ``geometry_msgs/Pose``."""
    message.position.x, message.position.y = pose.x, pose.y
    message.orientation.z, message.orientation.w = math.sin(pose.yaw / 2), math.cos(pose.yaw / 2)


def pose_of(message: Any, frame: str) -> Pose:
    """The pose on the floor of a ``geometry_msgs/Pose``."""
    return Pose(float(message.position.x), float(message.position.y), yaw_of(message.orientation), frame)


def yaw_of(quaternion: Any) -> float:
    """rad about z of a ``geometry_msgs/Quaternion``."""
    x, y, z, w = quaternion.x, quaternion.y, quaternion.z, quaternion.w
    return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
