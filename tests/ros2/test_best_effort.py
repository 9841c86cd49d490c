"""What a publisher of best effort says is heard, and what comes by two ways is heard once."""

from __future__ import annotations

import time

import pytest

pytestmark = pytest.mark.ros2


def test_a_stop_of_best_effort_stops_and_nothing_is_done_twice(peer):
    from rclpy.qos import qos_profile_sensor_data
    from ros_stage import NodeProcess, until
    from std_msgs.msg import Empty, String

    stop = peer.node.create_publisher(Empty, "voice_commands/stop", qos_profile_sensor_data)
    text = peer.node.create_publisher(String, "voice_commands/text", qos_profile_sensor_data)
    with NodeProcess(peer) as node:
        peer.meet()
        until(stop.get_subscription_count)
        until(text.get_subscription_count)
        peer.say("go forward five meters")
        until(peer.moving)
        stop.publish(Empty())
        until(peer.standing)
        until(lambda: peer.goals("canceled"))
        assert [goal["reason"] for goal in peer.goals("canceled")] == ["stop"]
        text.publish(String(data="turn left"))
        until(peer.moving)
        peer.halt()
        until(lambda: len(peer.goals("canceled")) == 2)
        peer.say("go forward ten centimeters")  # by both ways, since somebody publishes with best effort
        until(lambda: peer.goals("succeeded") and "go forward ten centimeters" in peer.heard_texts())
        time.sleep(0.2)  # what came a second time would be heard by now
        assert peer.heard_texts() == ["go forward five meters", "turn left", "go forward ten centimeters"]
        assert node.end() == 0
    assert "incompatible QoS" not in node.output
