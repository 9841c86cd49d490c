"""A program of a user's, with the signal handlers of rclpy: it ends as asked, and the robot stands."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.ros2
HERE = Path(__file__).resolve().parent
PATH = os.pathsep.join([str(HERE.parent.parent), os.environ.get("PYTHONPATH", "")])


@pytest.fixture
def program(peer):
    """Starts the program, and has it drive."""
    from ros_stage import until

    made = []

    def start(*words: str) -> subprocess.Popen:
        command = [sys.executable, HERE / "tutorial_node.py", *words, "--ros-args", "-r", f"__ns:={peer.namespace}"]
        process = subprocess.Popen(
            command,
            cwd=HERE.parent.parent,
            env={**os.environ, "PYTHONPATH": PATH},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        made.append(process)
        until(lambda: peer.text.get_subscription_count())
        until(lambda: peer.node.count_publishers(f"{peer.namespace}/cmd_vel"))
        peer.say("go forward twenty meters")
        until(peer.moving)
        return process

    yield start
    for process in made:
        process.kill()
        process.wait()


@pytest.mark.parametrize(
    "words", [["given"], ["given", "close"], ["own"], ["own", "close"], ["given", "slow"]], ids=" ".join
)
@pytest.mark.parametrize(("number", "said"), [(signal.SIGINT, "Ctrl-C"), (signal.SIGTERM, "")])
def test_the_robot_stands_before_the_middleware_is_closed(peer, program, number, said, words):
    from ros_stage import until

    process = program(*words)
    process.send_signal(number)
    output = process.communicate(timeout=60)[0]
    until(peer.standing)
    assert process.returncode == 0, output
    assert said in output
    assert "Traceback" not in output
    assert "no zero velocity" not in output


@pytest.mark.parametrize("words", [["given"], ["own", "close"]], ids=" ".join)
def test_the_robot_stands_when_the_terminal_is_closed(peer, program, words):
    from ros_stage import until

    process = program(*words)
    process.send_signal(signal.SIGHUP)
    output = process.communicate(timeout=60)[0]
    until(peer.standing)
    peer.silence()
    assert peer.standing()
    assert process.returncode == -signal.SIGHUP, output


def test_a_signal_to_a_forked_child_is_the_childs_own(peer, program):
    from ros_stage import until

    process = program("given")
    peer.say("fork")
    assert "signal 15" in process.stdout.readline()
    peer.twists.clear()
    until(peer.moving)
    assert process.poll() is None
