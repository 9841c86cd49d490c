"""The thread that keeps navigation goals, without a middleware: nobody is told too soon that all have ended."""

from __future__ import annotations

import threading
from collections.abc import Callable
from types import SimpleNamespace

import pytest

from intent_engine.execution.robots import ros2_navigation
from intent_engine.execution.robots.robot import Pose
from intent_engine.execution.robots.ros2_navigation import Ros2Navigation


class Link:
    """A server that is asked to cancel, and answers when a test lets it."""

    names_goals = True
    open = True
    pose = None
    cancel_service = "cancel"

    def __init__(self) -> None:
        self.asked = 0

    def unavailable(self) -> str:
        return ""

    def servers(self) -> frozenset[bytes]:
        return frozenset()

    def send(self, goal: Pose, uuid: bytes) -> None: ...

    def cancel(self, uuid: bytes | None, number: int) -> bool:
        self.asked = number
        return True


class Told(threading.Event):
    """Before it is set, something else may happen."""

    then: Callable[[], object] | None = None

    def set(self) -> None:
        then, Told.then = Told.then, None
        if then is not None:
            then()
        super().set()


@pytest.fixture
def navigation(monkeypatch):
    monkeypatch.setattr(ros2_navigation, "_Link", lambda *arguments: Link())
    monkeypatch.setattr(ros2_navigation, "threading", SimpleNamespace(Event=Told, Thread=threading.Thread))
    made = Ros2Navigation(None, "goal_pose")
    yield made
    made._inbox.put(None)
    made._thread.join(10.0)


def answered(navigation: Ros2Navigation) -> None:
    """The server has answered all that it was asked."""
    navigation._inbox.put(lambda keeper, now: keeper.heard_cancel(navigation._link.asked, False, now))


def test_a_stop_is_waited_for_until_the_server_has_answered(navigation):
    assert navigation.wait(10.0), "nothing is driven yet"
    navigation.stop()
    assert not navigation.wait(0.05)
    answered(navigation)
    assert navigation.wait(10.0)


def test_also_one_that_comes_as_somebody_is_told_that_nothing_is_left_to_do(navigation):
    assert navigation.wait(10.0)
    stopped = threading.Event()
    Told.then = lambda: (navigation.stop(), stopped.set())
    navigation._inbox.put(lambda keeper, now: None)  # the thread looks once more
    assert navigation.wait(10.0)
    assert stopped.wait(10.0)
    assert not navigation.wait(0.05), "the stop has not been answered"
    answered(navigation)
    assert navigation.wait(10.0)


def test_after_the_end_it_is_known_whether_all_had_ended(navigation):
    navigation._inbox.put(None)
    navigation._thread.join(10.0)
    assert navigation.wait(0.0)
