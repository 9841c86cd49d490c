"""``rclpy.shutdown()`` before ``executor.close()``: the robot stands, the program ends, and is told what it did."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.ros2
HERE = Path(__file__).resolve().parent
PATH = os.pathsep.join([str(HERE.parent.parent), os.environ.get("PYTHONPATH", "")])
TOLD = "rclpy was shut down before the executor was closed: call executor.close() and robot.close() first"


class Program:
    def __init__(self, namespace: str, *words: str) -> None:
        command = [sys.executable, HERE / "shutting_down.py", *words, "--ros-args", "-r", f"__ns:={namespace}"]
        self.process = subprocess.Popen(
            command,
            cwd=HERE.parent.parent,
            env={**os.environ, "PYTHONPATH": PATH},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        assert self.process.stdout is not None
        assert self.process.stdout.readline() == "ready\n"

    def go_on(self) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write("\n")
        self.process.stdin.flush()

    def end(self) -> str:
        return self.process.communicate(timeout=90)[0]


@pytest.fixture
def program():
    made: list[Program] = []

    def start(*words: str) -> Program:
        made.append(Program(*words))
        return made[-1]

    yield start
    for each in made:
        each.process.kill()
        each.process.wait()


@pytest.mark.parametrize("words", [["close"], [], ["silently", "close"], ["guardian", "close"]], ids=" ".join)
def test_a_robot_that_drives_stands(peer, program, words):
    from ros_stage import until

    driver = program(peer.namespace, *words)
    until(lambda: peer.node.count_publishers(f"{peer.namespace}/cmd_vel"))
    driver.go_on()
    until(peer.moving)
    driver.go_on()
    output = driver.end()
    assert driver.process.returncode == 0, output
    assert "Traceback" not in output
    assert "ended: robot_error\n" in output
    if "guardian" not in words:
        assert f"{TOLD}; the robot was stopped all the same" in output
        assert f"late: {TOLD}" in output
    assert "closed: True" in output
    until(peer.standing)


@pytest.mark.parametrize("words", [["navigate", "close"], ["navigate", "silently", "close"]], ids=" ".join)
def test_a_navigation_goal_is_cancelled(peer, program, words):
    from ros_stage import Server, until

    server = Server(peer.namespace, "goal_pose")
    try:
        until(lambda: server.said)
        driver = program(peer.namespace, *words)
        until(lambda: peer.node.count_subscribers(f"{peer.namespace}/goal_pose"))
        until(lambda: peer.node.count_publishers(f"{peer.namespace}/goal_pose"))
        driver.go_on()
        until(server.driving)
        driver.go_on()
        output = driver.end()
        until(lambda: not server.driving())
    finally:
        server.end()
    assert driver.process.returncode == 0, output
    assert "Traceback" not in output
    assert "the robot was stopped all the same" in output
    assert "ended: robot_error\n" in output
    assert "closed: True" in output
