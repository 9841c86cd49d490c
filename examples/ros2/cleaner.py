"""A ROS 2 node that does an action of the user's: it cleans a room when told to, and ends when that is taken back.

The node ``intent_engine`` says on ``voice_commands/action`` what is to be done, and on the same topic what is to end,
so that neither can overtake the other::

    intent-engine-ros2 --ros-args -p grammar:=examples/ros2/clean.yaml
    python3 examples/ros2/cleaner.py
"""

import contextlib
import json

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class Cleaner(Node):
    """Cleans one room at a time."""

    def __init__(self) -> None:
        super().__init__("cleaner")
        self.room: str | None = None
        self.create_subscription(String, "voice_commands/action", self.told, 10)
        self.get_logger().info("ready")

    def told(self, message: String) -> None:
        told = json.loads(message.data)
        if told["type"] == "custom" and told["name"] == "clean":
            self.room = told["slots"].get("room") or "floor"  # "clean" alone names none
            self.get_logger().info(f"cleaning the {self.room}")  # here the brushes begin to turn
        elif told["type"] == "stop" or (told["type"] == "cancel" and any(map(self.is_meant, told["actions"]))):
            if self.room is not None:
                self.get_logger().info(f"no longer cleaning the {self.room}")  # and here they end
            self.room = None

    def is_meant(self, denied: dict) -> bool:
        """Whether what was denied is what is done: "don't clean" is any room."""
        if denied["type"] != "custom" or denied["name"] != "clean":
            return False
        return denied["slots"].get("room") in (None, self.room)


def main() -> None:
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(Cleaner())


if __name__ == "__main__":
    main()
