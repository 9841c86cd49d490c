"""Tests of the ROS 2 room: the real middleware, on this machine alone, between real processes."""

from __future__ import annotations

import importlib.util
import os

import pytest

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")

HAS_ROS = importlib.util.find_spec("rclpy") is not None


def pytest_collection_modifyitems(items):
    if not HAS_ROS:
        for item in items:
            if item.get_closest_marker("ros2"):
                item.add_marker(pytest.mark.skip(reason="needs rclpy: make test-ros2 installs it where it can"))


@pytest.fixture
def peer():
    """A program on the other side of the topics, in a namespace of its own."""
    from ros_stage import Peer

    with Peer() as made:
        yield made


@pytest.fixture(scope="module")
def driven():
    """A node that drives, and a program that listens, shared by the tests of a module."""
    from ros_stage import NodeProcess, Peer

    with Peer() as made, NodeProcess(made) as node:
        made.meet()
        yield made, node
