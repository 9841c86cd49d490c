"""Actions that other nodes do: they are told when to begin, and what is to end, however it ends."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

pytestmark = pytest.mark.ros2
ROOT = Path(__file__).resolve().parent.parent.parent
LAB, HALL, ANY = ({"type": "custom", "name": "clean", "slots": {"room": room}} for room in ("lab", "hall", None))
STOP = {"type": "stop"}
GRAMMAR = ROOT / "examples/ros2/clean.yaml"


@pytest.fixture
def told(peer):
    """What is said on the topic of actions."""
    from std_msgs.msg import String

    heard: list[dict] = []
    peer.node.create_subscription(String, "voice_commands/action", lambda m: heard.append(json.loads(m.data)), 50)
    return heard


def until_told(peer, condition) -> None:
    """Wait until those who do actions hear the node, which finds each of them when it comes to it; they are stopped."""
    from ros_stage import until

    def heard() -> bool:
        peer.say("clean the lab")
        time.sleep(0.05)
        return condition()

    until(heard, "the node is heard by those who do actions")
    peer.forget()


def test_whoever_does_it_is_told_what_was_denied_and_every_stop(peer, told):
    from ros_stage import NodeProcess, until

    with NodeProcess(peer, grammar=GRAMMAR) as node:
        peer.meet()
        until(lambda: peer.node.count_publishers(f"{peer.namespace}/voice_commands/action"))
        until_told(peer, lambda: bool(told))
        until(lambda: told[-1] == STOP)
        told.clear()
        peer.say("clean the lab")
        until(lambda: any(goal["action"] == LAB for goal in peer.goals("succeeded")))  # its part of it is done
        for text in ("don't clean the hall", "don't clean", "don't go to the kitchen", "stop"):
            peer.say(text)
        until(lambda: STOP in told)
        assert told == [
            LAB,
            {"type": "cancel", "actions": [HALL]},
            {"type": "cancel", "actions": [ANY]},
            STOP,
        ]
        told.clear()
        peer.halt()
        until(lambda: told == [STOP])
        until(lambda: len(peer.commands) == 2)
        # What is denied is no command: weather and the like are not, either.
        assert [json.loads(each)["text"] for each in peer.commands] == ["clean the lab", "stop"]
        told.clear()
        assert node.end() == 0
        until(lambda: told == [STOP])


def test_the_example_begins_and_ends(peer, told):
    from ros_stage import NodeProcess, until

    cleaner = subprocess.Popen(
        [sys.executable, "-u", "examples/ros2/cleaner.py", "--ros-args", "-r", f"__ns:={peer.namespace}"],
        cwd=ROOT,
        env={**os.environ, "RCUTILS_LOGGING_BUFFERED_STREAM": "0"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    lines: list[str] = []

    def read() -> None:
        for line in cleaner.stdout:
            lines.append(line)

    reader = threading.Thread(target=read, daemon=True)
    reader.start()

    def said() -> list[str]:
        return [line.rsplit(": ", 1)[1].strip() for line in list(lines) if ": " in line]

    try:
        with NodeProcess(peer, grammar=GRAMMAR):
            peer.meet()
            until_told(peer, lambda: told and "cleaning the lab" in said())
            until(lambda: said()[-1] == "no longer cleaning the lab")
            assert said()[0] == "ready"
            lines.clear()
            for text in ("clean the lab", "don't clean the hall", "don't clean the lab", "clean the hall", "clean"):
                peer.say(text)
            until(lambda: ANY in told)
        until(lambda: told[-1] == STOP)
        until(lambda: "no longer cleaning the floor" in said())
    finally:
        cleaner.send_signal(signal.SIGINT)
        cleaner.wait(60)
        reader.join(60)
    assert said() == [
        *("cleaning the lab", "no longer cleaning the lab"),
        "cleaning the hall",
        *("cleaning the floor", "no longer cleaning the floor"),
    ]
