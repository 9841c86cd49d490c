"""What the tests stand on: the node in a process of its own, and a program that speaks and listens to it."""

from __future__ import annotations

import itertools
import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import rclpy
from geometry_msgs.msg import Twist, TwistStamped
from std_msgs.msg import Bool, Empty, String

from intent_engine.execution.robots.ros2_spinning import Spinning
from intent_engine.execution.robots.ros2_support import own_node

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
_names = itertools.count(1)
LIMIT = 60.0
"""s after which a test that waits is broken; no test asserts how long something took."""


def until(condition: Callable[[], object], what: str = "") -> None:
    """Wait for something that must happen."""
    end = time.monotonic() + LIMIT
    while not condition():
        assert time.monotonic() < end, f"did not happen within {LIMIT:g} s: {what or condition}"
        time.sleep(0.005)


class Peer:
    """A node in this process: publishes text, and remembers everything that it hears, in order.

    What comes on one topic comes in order; of two topics, either may be late. So a test that has waited for a word on
    one waits for what another brings, too.
    """

    def __init__(self, stamped: bool | None = False) -> None:
        self.namespace = f"/test{os.getpid()}_{next(_names)}"
        self.context, self.node = own_node("peer", self.namespace)
        self.twists: list[tuple[float, float]] = []
        """m/s and rad/s"""
        self.frames: list[str] = []
        self.commands: list[str] = []
        self.status: list[dict] = []
        if stamped is not None:
            self.listen(TwistStamped if stamped else Twist)
        self.node.create_subscription(String, "voice_commands/command", lambda m: self.commands.append(m.data), 50)
        self.node.create_subscription(
            String, "voice_commands/status", lambda m: self.status.append(json.loads(m.data)), 500
        )
        self.text = self.node.create_publisher(String, "voice_commands/text", 10)
        self.amended = self.node.create_publisher(String, "voice_commands/amended_text", 10)
        self.stop = self.node.create_publisher(Empty, "voice_commands/stop", 10)
        self.hold = self.node.create_publisher(Bool, "voice_commands/hold", 10)
        self._spinning = Spinning(self.node)

    def listen(self, kind: type, topic: str = "cmd_vel") -> None:
        self.node.create_subscription(kind, topic, self._heard, 100)

    def _heard(self, message) -> None:
        if isinstance(message, TwistStamped):
            self.frames.append(message.header.frame_id)
            message = message.twist
        self.twists.append((round(message.linear.x, 6), round(message.angular.z, 6)))

    def meet(self, topic: str = "cmd_vel", velocities: int = 2) -> None:
        """Wait until the node and its velocity process are connected, and the node hears and is heard: each side finds
        the other for itself, so one may be deaf when the other can speak. Lists are empty then.

        Args:
            topic: of velocities.
            velocities: publishers of them: the node and its velocity process.
        """
        until(lambda: self.text.get_subscription_count() >= 1, "the node subscribes to text")
        until(lambda: self.node.count_publishers(f"{self.namespace}/voice_commands/status") >= 1)
        until(lambda: self.node.count_publishers(f"{self.namespace}/{topic}") >= velocities, "velocities")

        def heard() -> bool:
            self.say("what lovely weather")
            time.sleep(0.05)
            return bool(self.heard_texts())

        until(heard, "the node hears and is heard")
        self._hear_all()
        self._clear()

    def say(self, text: str) -> None:
        self.text.publish(String(data=text))

    def amend(self, text: str) -> None:
        until(lambda: self.amended.get_subscription_count() >= 1)
        self.amended.publish(String(data=text))

    def halt(self) -> None:
        until(lambda: self.stop.get_subscription_count() >= 1)
        self.stop.publish(Empty())

    def moving(self) -> bool:
        return bool(self.twists) and any(self.twists[-1])

    def standing(self) -> bool:
        return bool(self.twists) and not any(self.twists[-1])

    def moved(self) -> list[tuple[float, float]]:
        """The velocities that were no zero."""
        return [twist for twist in list(self.twists) if any(twist)]

    def come_to_rest(self) -> bool:
        """Whether it has moved, and stands."""
        return bool(self.moved()) and self.standing()

    def silence(self, seconds: float = 0.3) -> None:
        """Wait until no velocity comes any more: what is written from two processes has been heard from both. A robot
        that is driven on is never silent."""
        heard, since = len(self.twists), time.monotonic()

        def over() -> bool:
            nonlocal heard, since
            if len(self.twists) != heard:
                heard, since = len(self.twists), time.monotonic()
            return time.monotonic() - since >= seconds

        until(over, "no velocity comes any more")

    def goals(self, state: str) -> list[dict]:
        return [each for each in list(self.status) if each["event"] == "goal" and each["state"] == state]

    def heard_texts(self) -> list[str]:
        return [e["interpretation"]["text"] for e in list(self.status) if e["event"] == "interpretation"]

    def forget(self) -> None:
        """Stop the robot, wait until all of that was told, and begin with empty lists."""
        self.twists.clear()
        self.say("stop")
        self._hear_all()
        stops = self.heard_texts().count("stop")
        until(lambda: sum(goal["action"]["type"] == "stop" for goal in self.goals("succeeded")) >= stops)
        until(lambda: sum(json.loads(command)["text"] == "stop" for command in list(self.commands)) >= stops)
        until(self.standing)
        self._clear()

    def _hear_all(self) -> None:
        """Wait until every text that was said has been heard."""
        self.say("what lovely weather it is")  # what was said before it comes before it
        until(lambda: "what lovely weather it is" in self.heard_texts())

    def _clear(self) -> None:
        """Wait for silence, and begin with empty lists."""
        self.silence(0.25)
        for each in (self.twists, self.frames, self.commands, self.status):
            each.clear()

    def __enter__(self) -> Peer:
        return self

    def __exit__(self, *_) -> None:
        assert self._spinning.end()
        self.node.destroy_node()
        rclpy.shutdown(context=self.context)


class NodeProcess:
    """A node of ours, started as its script starts it."""

    def __init__(self, peer: Peer, *arguments: str, module: str = "intent_engine.ros2.node", **parameters) -> None:
        given = [part for name, value in parameters.items() for part in ("-p", f"{name}:={_yaml(value)}")]
        self.process = subprocess.Popen(
            [sys.executable, "-m", module, "--ros-args", "-r", f"__ns:={peer.namespace}", *given, *arguments],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self.output = ""

    @property
    def pid(self) -> int:
        return self.process.pid

    def children(self) -> list[int]:
        return [int(pid) for pid in Path(f"/proc/{self.pid}/task/{self.pid}/children").read_text().split()]

    def freeze(self) -> None:
        """Keep it from running, until it gets a SIGCONT. The kernel needs a moment to stop each of its threads."""
        self.process.send_signal(signal.SIGSTOP)
        tasks = Path(f"/proc/{self.pid}/task")
        until(lambda: all((task / "stat").read_text().rsplit(")", 1)[1].split()[0] == "T" for task in tasks.iterdir()))

    def end(self, number: int = signal.SIGTERM) -> int:
        self.process.send_signal(number)
        return self.wait()

    def wait(self) -> int:
        self.output = self.process.communicate(timeout=LIMIT)[0]
        return self.process.returncode

    def __enter__(self) -> NodeProcess:
        return self

    def __exit__(self, *_) -> None:
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGCONT)
            self.end()
        elif not self.output:
            self.wait()
        print(self.output)  # shown with the test, if it failed


class Server:
    """The navigation's process, and what it says it did."""

    def __init__(self, namespace: str, *words: str) -> None:
        program = [sys.executable, str(HERE / "navigation_server.py"), *words]
        self.process = subprocess.Popen(
            [*program, "--ros-args", "-r", f"__ns:={namespace}"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            bufsize=1,
        )
        self.said: list[dict] = []
        self._heard = 0
        self.thread = threading.Thread(target=self._read, daemon=True)
        self.thread.start()

    def _read(self) -> None:
        for line in self.process.stdout:
            try:
                said = json.loads(line)
            except ValueError:
                said = {"garbled": line}
            if "heard" in said:
                self._heard = said["heard"]
            else:
                self.said.append(said)

    def told(self) -> None:
        """Wait until all that it has said by now has been read: what it did is known from the middleware first."""
        number = self._heard + 1
        self.process.stdin.write(f"{number}\n")
        until(lambda: self._heard == number, "the server answers")

    def count(self, *states: str) -> int:
        return sum(each.get("state") in states for each in list(self.said))

    def driving(self) -> int:
        """Goals that began and have not ended. By their names: a test may have forgotten the beginning of one."""
        said = list(self.said)
        garbled = [each for each in said if "garbled" in each]
        assert not garbled, f"what the server said cannot be read: {garbled}"
        ended = {each["goal"] for each in said if each.get("state") in ("canceled", "succeeded", "aborted")}
        return len({each["goal"] for each in said if each.get("state") == "driving"} - ended)

    def leave(self) -> None:
        """Go away as a program does that is asked to; or by force, since rclpy's executor sleeps on now and then when
        the signal comes (3 of 50 on a busy machine)."""
        self.process.terminate()
        try:
            self.process.wait(10.0)
        except subprocess.TimeoutExpired:
            self.process.kill()

    def end(self) -> None:
        self.process.kill()
        self.process.wait()
        self.process.stdin.close()
        self.thread.join(5.0)


def _yaml(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def alive(pid: int) -> bool:
    """Whether a process runs."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().split(") ")[1][0] != "Z"
    except OSError:
        return False
