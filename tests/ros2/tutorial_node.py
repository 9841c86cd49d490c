"""The command node of a tutorial, with the engine put in: a program of a user's, as they write it."""

from __future__ import annotations

import os
import signal
import sys
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String

from intent_engine import Executor, IntentEngine
from intent_engine.execution.robots.ros2 import Ros2Robot


class CommandNode(Node):
    def __init__(self) -> None:
        super().__init__("command_node")
        self.engine = IntentEngine.from_files("en", locations="home")
        topic = self.resolve_topic_name("cmd_vel")
        self.robot = Ros2Robot(self) if "given" in sys.argv else Ros2Robot(cmd_vel=topic)
        self.motions = Executor(self.robot)
        self.create_subscription(String, "voice_commands/text", self.heard, 10)

    def heard(self, message: String) -> None:
        if message.data == "fork":
            child = os.fork()
            if child == 0:
                os.kill(os.getpid(), signal.SIGTERM)
                os._exit(1)
            print(f"the child ended by signal {os.waitpid(child, 0)[1]}", flush=True)
            return
        self.motions.submit(self.engine.parse(message.data).actions)


def main() -> None:
    rclpy.init()
    node = CommandNode()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        print("Ctrl-C", flush=True)
    except ExternalShutdownException:
        print("shutdown", flush=True)
    finally:
        if "slow" in sys.argv:
            time.sleep(1.0)  # a program has more to end than its node
        if "close" in sys.argv:
            node.motions.close()
            node.robot.close()
        node.destroy_node()
        rclpy.try_shutdown()


main()
