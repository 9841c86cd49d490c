"""Actions that other nodes do: they are told when to begin, and what is to end, however it ends."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
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


def test_whoever_does_it_is_told_what_was_denied_and_every_stop(peer, told):
    from ros_stage import NodeProcess, until

    with NodeProcess(peer, grammar=GRAMMAR) as node:
        peer.meet()
        until(lambda: peer.node.count_publishers(f"{peer.namespace}/voice_commands/action"))
        peer.say("stop")
        until(lambda: told)
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
        assert len(peer.commands) == 3  # what is denied is no command: weather and the like are not, either
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
    try:
        with NodeProcess(peer, grammar=GRAMMAR):
            peer.meet()
            until(lambda: len(peer.node.get_subscriptions_info_by_topic(f"{peer.namespace}/voice_commands/action")) > 1)
            until(lambda: peer.node.count_publishers(f"{peer.namespace}/voice_commands/action"))
            for text in ("clean the lab", "don't clean the hall", "don't clean the lab", "clean the hall", "clean"):
                peer.say(text)
            until(lambda: ANY in told)
        until(lambda: STOP in told)
        while not (lines and "no longer cleaning the floor" in lines[-1]):
            lines.append(cleaner.stdout.readline())
            assert lines[-1], lines
    finally:
        cleaner.send_signal(signal.SIGINT)
        lines += cleaner.communicate(timeout=60)[0].splitlines()
    said = [line.rsplit(": ", 1)[1].strip() for line in lines if ": " in line]
    assert said == [
        "ready",
        *("cleaning the lab", "no longer cleaning the lab"),
        "cleaning the hall",
        *("cleaning the floor", "no longer cleaning the floor"),
    ]
