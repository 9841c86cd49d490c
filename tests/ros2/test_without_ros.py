"""On a machine without ROS: everything can be imported, and what cannot work says what to do."""

from __future__ import annotations

import importlib.util
import subprocess
import sys

import pytest

from intent_engine.errors import RobotError
from intent_engine.execution.robots.ros2 import Ros2Robot

pytestmark = pytest.mark.skipif(importlib.util.find_spec("rclpy") is not None, reason="there is a ROS here")


@pytest.mark.parametrize("module", ["intent_engine.ros2.node", "intent_engine.ros2.speech"])
def test_a_node_says_what_is_missing(root, module):
    done = subprocess.run([sys.executable, "-m", module], cwd=root, capture_output=True, text=True, check=False)
    assert done.returncode == RobotError.exit_code
    assert done.stderr.startswith("error: no ROS 2 in this Python")
    assert "setup.bash" in done.stderr
    assert "Traceback" not in done.stderr


def test_the_robot_says_what_is_missing():
    with pytest.raises(RobotError, match=r"pip install 'intent-engine\[ros2\]'"):
        Ros2Robot()


def test_help_needs_no_ros(root):
    done = subprocess.run(
        [sys.executable, "-m", "intent_engine.ros2.node", "--help"],
        cwd=root,
        capture_output=True,
        text=True,
        check=True,
    )
    assert "voice_commands/text" in done.stdout
    assert "--ros-args -p" in done.stdout
