"""ROS 2: from a text that is published to the velocity that follows, and goals that are stopped at once.

The node runs as it is started, with its guardian, in processes of its own; the times are those of another process that
publishes and listens, so they hold two ways through the middleware. Beside it, in the same run, one trial after the
other: a node with regular expressions that writes ``cmd_vel`` from a 20 Hz timer, and one that sleeps as the tutorials'
does. A navigation that is cancelled once is the peer of one that is cancelled until it has ended.

rclpy lives in an environment of its own (``make test-ros2`` makes it); called from another, this starts itself there.
"""

from __future__ import annotations

import contextlib
import importlib.util
import json
import os
import random
import signal
import statistics
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
ENVIRONMENT = ROOT / ".venv-ros2" / "bin" / "python"
COMMAND = "python -m benchmarks --only ros2"
TIMER, SLEEP = "a node with a 20 Hz timer", "a node that sleeps"


def run(quick: bool) -> list[dict[str, Any]]:
    """The rows of this benchmark.

    Raises:
        FileNotFoundError: there is no rclpy anywhere.
    """
    if importlib.util.find_spec("rclpy") is not None:
        return measure(quick)
    if not ENVIRONMENT.exists():
        raise FileNotFoundError("needs rclpy: run make test-ros2 first, which installs it where it can be installed")
    done = subprocess.run(
        [ENVIRONMENT, "-m", "benchmarks.ros2", *(["--quick"] if quick else [])],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        check=True,
        env={**os.environ, "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"},
    )
    rows: list[dict[str, Any]] = json.loads(done.stdout)
    return rows


def measure(quick: bool) -> list[dict[str, Any]]:
    """All of it, in a process that has rclpy."""
    trials = 20 if quick else 150
    with Ears("ours") as ours, Ears("timer") as timer, Ears("sleep") as sleep:
        nodes = [
            started(ours, "intent_engine.ros2.node"),
            started(timer, "benchmarks.ros2", "--timer"),
            started(sleep, "benchmarks.ros2", "--sleep"),
        ]
        try:
            for ears in (ours, timer, sleep):
                ears.meet()
            times = {ears: [trial(ears) for _ in range(3)] for ears in (ours, timer)}
            times = {ears: [] for ears in times}
            for _ in range(trials):
                for ears, measured in times.items():
                    measured.append(trial(ears))
            slept = [trial(sleep) for _ in range(3 if quick else 10)]
            away = {
                name: [lost(number) for _ in range(3 if quick else 8)]
                for name, number in (("killed", signal.SIGKILL), ("frozen", signal.SIGSTOP))
            }
        finally:
            for node in nodes:
                node.terminate()
    rows = []
    for share, name in ((0.5, "p50"), (0.99, "p99")):
        first = [[at for at, _ in times[ears]] for ears in (ours, timer)]
        zero = [[at for _, at in times[ears]] for ears in (ours, timer)]
        rows.append(row(f"text published -> first Twist, {name}", first[0], share, TIMER, first[1]))
        rows.append(row(f"stop published -> zero Twist, {name}", zero[0], share, TIMER, zero[1]))
    rows.append(row("stop published -> zero Twist, p50", zero[0], 0.5, SLEEP, [at for _, at in slept]))
    for name, measured in away.items():
        rows.append(row(f"node {name} while it drives -> zero Twist, p50", measured, 0.5, None, None))
        rows.append(row(f"node {name} while it drives -> zero Twist, max", measured, 1.0, None, None))
    return rows + left_driving(50 if quick else 1000)


def row(figure: str, values: list[float], share: float, peer: str | None, peers: list[float] | None) -> dict[str, Any]:
    """Times in s, as a row in ms."""
    value = quantile(values, share) * 1000
    other = quantile(peers, share) * 1000 if peers else None
    return {
        "figure": figure,
        "value": round(value, 3),
        "unit": "ms",
        "peer": peer,
        "peer_value": round(other, 3) if other is not None else None,
        "ratio": round(other / value, 2) if other is not None and value else None,
        "spread": [round(min(values) * 1000, 3), round(max(values) * 1000, 3)],
        "runs": len(values),
        "command": COMMAND,
    }


def quantile(values: list[float], share: float) -> float:
    ordered = sorted(values)
    return ordered[min(int(share * len(ordered)), len(ordered) - 1)] if share != 0.5 else statistics.median(ordered)


# -- the process that publishes and listens ----------------------------------------------------------------------------


class Ears:
    """Publishes text in a namespace, and notes when which velocity came."""

    def __init__(self, name: str) -> None:
        from geometry_msgs.msg import Twist
        from rclpy.executors import SingleThreadedExecutor
        from std_msgs.msg import String

        from intent_engine.execution.robots.ros2_support import own_node

        self.namespace = f"/benchmark{os.getpid()}_{name}"
        self.context, self.node = own_node("ears", self.namespace)
        self.heard: list[tuple[float, float]] = []
        self.news = threading.Event()
        self.node.create_subscription(Twist, "cmd_vel", self._twist, 10)
        self._string, self._text = String, self.node.create_publisher(String, "voice_commands/text", 10)
        self._executor = SingleThreadedExecutor(context=self.context)
        self._executor.add_node(self.node)
        self._thread = threading.Thread(target=self._executor.spin, daemon=True)

    def _twist(self, message: Any) -> None:
        self.heard.append((time.monotonic(), message.linear.x))
        self.news.set()

    def meet(self) -> None:
        while not (self._text.get_subscription_count() and self.node.count_publishers(f"{self.namespace}/cmd_vel")):
            time.sleep(0.05)
        time.sleep(1.0)

    def say(self, text: str) -> float:
        message = self._string(data=text)
        self.heard.clear()
        self.news.clear()
        now = time.monotonic()
        self._text.publish(message)
        return now

    def wait(self, wanted: Callable[[float], bool]) -> float:
        """When a velocity came that is wanted."""
        while True:
            for at, linear in list(self.heard):
                if wanted(linear):
                    return at
            if not self.news.wait(20.0):
                raise TimeoutError("no velocity within 20 s")
            self.news.clear()

    def __enter__(self) -> Ears:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._executor.shutdown(timeout_sec=1.0)
        self._thread.join(2.0)
        self.node.destroy_node()
        self.context.shutdown()


def started(ears: Ears, module: str, *flags: str) -> subprocess.Popen[bytes]:
    arguments = ["--ros-args", "--log-level", "error", "-r", f"__ns:={ears.namespace}"]
    return subprocess.Popen([sys.executable, "-m", module, *flags, *arguments], cwd=ROOT, stdout=sys.stderr)


def trial(ears: Ears) -> tuple[float, float]:
    """s to the first velocity after a command, and s to zero after a stop."""
    said = ears.say("go forward two meters")
    first = ears.wait(lambda linear: linear > 0) - said
    time.sleep(random.uniform(0.2, 0.3))
    said = ears.say("stop")
    zero = ears.wait(lambda linear: linear == 0) - said
    time.sleep(0.25)
    return first, zero


def lost(number: int) -> float:
    """s from the end of a node to zero."""
    with Ears(f"lost{random.randrange(1 << 30)}") as alone:
        node = started(alone, "intent_engine.ros2.node")
        alone.meet()
        time.sleep(1.0)
        alone.say("go forward twenty meters")
        alone.wait(lambda linear: linear > 0)
        time.sleep(random.uniform(0.1, 0.2))
        alone.heard.clear()
        gone = time.monotonic()
        node.send_signal(number)
        zero = alone.wait(lambda linear: linear == 0) - gone
        node.kill()
        node.wait()
    return zero


# -- peers -------------------------------------------------------------------------------------------------------------


def peer_node(sleeping: bool) -> None:
    """What the tutorials write, in its two kinds: a timer that sends the last velocity, or a motion that is slept."""
    import re

    import rclpy
    from geometry_msgs.msg import Twist
    from std_msgs.msg import String

    rclpy.init(args=sys.argv)
    node = rclpy.create_node("peer")
    publisher = node.create_publisher(Twist, "cmd_vel", 10)
    twist, moving = Twist(), False

    def send() -> None:
        nonlocal moving
        if moving or twist.linear.x:
            moving = bool(twist.linear.x)
            publisher.publish(twist)

    def heard(message: Any) -> None:
        text = message.data.lower()
        if re.search(r"stop|halt", text):
            twist.linear.x = 0.0
        elif re.search(r"(go|move) (forward|backward)", text):
            twist.linear.x = 0.5
        if sleeping and twist.linear.x:
            publisher.publish(twist)
            time.sleep(2.0)
            twist.linear.x = 0.0
            publisher.publish(twist)

    node.create_subscription(String, "voice_commands/text", heard, 10)
    if not sleeping:
        node.create_timer(0.05, send)
    with contextlib.suppress(KeyboardInterrupt, rclpy.executors.ExternalShutdownException):
        rclpy.spin(node)


def left_driving(trials: int) -> list[dict[str, Any]]:
    """Goals that drive on after a stop right behind them; the server is another process."""
    from action_msgs.srv import CancelGoal
    from geometry_msgs.msg import PoseStamped

    from intent_engine.execution.robots.robot import Pose
    from intent_engine.execution.robots.ros2 import Ros2Robot

    counts: dict[str, int] = {}
    with Ears("navigation") as ears:
        server = Path(ROOT / "tests" / "ros2" / "navigation_server.py")
        process = subprocess.Popen(
            [sys.executable, server, "goal_pose", "--ros-args", "-r", f"__ns:={ears.namespace}"],
            stdout=subprocess.PIPE,
            text=True,
        )
        assert process.stdout is not None
        lines = process.stdout
        driving = {"now": 0}

        def read() -> None:
            for line in lines:
                state = json.loads(line).get("state")
                driving["now"] += {"driving": 1, None: 0}.get(state, -1)

        threading.Thread(target=read, daemon=True).start()
        robot = Ros2Robot(ears.node, navigation="goal_pose")
        navigation = robot.navigation
        assert navigation is not None
        goals = ears.node.create_publisher(PoseStamped, "goal_pose", 1)
        cancel = ears.node.create_client(CancelGoal, "navigate_to_pose/_action/cancel_goal")
        cancel.wait_for_service(20.0)
        while not goals.get_subscription_count():
            time.sleep(0.05)
        time.sleep(1.0)

        def once() -> None:
            pose = PoseStamped()
            pose.pose.position.x = 2000.0
            goals.publish(pose)
            cancel.call_async(CancelGoal.Request())

        def until_it_has_ended() -> None:
            robot.navigate(Pose(2000.0, 0.0, 0.0))
            robot.stop()

        ways = {"once": (once, min(trials, 100)), "until it has ended": (until_it_has_ended, trials)}
        for name, (stop_at_once, count) in ways.items():
            counts[name] = 0
            for _ in range(count):
                stop_at_once()
                time.sleep(0.15 if name == "once" else 0.0)
                navigation.wait(10.0)
                if name == "once" and driving["now"]:
                    counts[name] += 1
                    robot.stop()
                    navigation.wait(10.0)
            time.sleep(0.5)
            if name != "once":
                counts[name] = driving["now"]
        robot.close()
        process.kill()
        process.wait()
    share = [counts[name] / count * 100 for name, (_, count) in ways.items()]
    return [
        {
            "figure": f"goals left driving by a stop right after them, of {trials}",
            "value": round(share[1], 2),
            "unit": "%",
            "peer": f"cancelled once (of {ways['once'][1]})",
            "peer_value": round(share[0], 2),
            "ratio": None,
            "spread": None,
            "runs": trials,
            "command": COMMAND,
        }
    ]


if __name__ == "__main__":
    if "--timer" in sys.argv or "--sleep" in sys.argv:
        peer_node("--sleep" in sys.argv)
    else:
        print(json.dumps(measure("--quick" in sys.argv)))
