"""A robot and a loop that fail in everything they are asked: nothing of it leaves, and what failed is known."""

from __future__ import annotations

import math

import pytest

from intent_engine.errors import RobotError
from intent_engine.execution.events import Dispatcher, Event, EventKind
from intent_engine.execution.failsafe import Failsafe
from intent_engine.execution.gate import Gate
from intent_engine.execution.goal import Reason
from intent_engine.execution.guardian import VelocityLoopError
from intent_engine.execution.motion import Travel
from intent_engine.execution.robots.robot import Pose


class Wreck:
    """A robot, or a velocity loop, that raises in all that it is told to; ``asked`` is what it heard."""

    moving = False

    def __init__(self, *broken: str) -> None:
        self.broken = broken
        self.asked: list[str] = []

    def __getattr__(self, name: str):
        def ask(*arguments, **options):
            self.asked.append(f"{name}{arguments}" if name == "velocity" else name)
            if name in self.broken:
                raise OSError("the bus is off")
            return Travel(1.5) if name == "halt" else None

        return ask


class Broken:
    def __init__(self, robot: Wreck, loop: Wreck) -> None:
        self.robot, self.loop, self.gate = robot, loop, Gate(robot)
        self.told: list[Event] = []
        events = Dispatcher(lambda: 0.0, threaded=False)
        events.subscribe(self.told.append)
        self.failsafe = Failsafe(robot, loop, self.gate, events, 0.3)
        self.flush = events.flush

    def drives(self) -> bool:
        """Whether a velocity reaches the robot."""
        before = len(self.robot.asked)
        self.gate.velocity(0.5, 0.0, 0.3)
        return "velocity(0.5, 0.0, 0.3)" in self.robot.asked[before:]


@pytest.fixture
def broken():
    return Broken(Wreck("stop", "velocity", "pose"), Wreck("halt", "silence"))


@pytest.fixture
def sound():
    return Broken(Wreck(), Wreck())


def test_a_robot_that_cannot_stop_is_sent_zero_and_told_of(broken):
    assert broken.failsafe.stop_robot() is False
    assert broken.robot.asked == ["stop", "velocity(0.0, 0.0, 0.3)"]
    broken.flush()
    assert [(event.kind, event.detail) for event in broken.told] == [
        (EventKind.ERROR, "the robot raised in stop(): the bus is off")
    ]
    assert broken.failsafe.pose() is None


def test_a_stop_and_a_failure_shut_the_gate(sound):
    for end in (sound.failsafe.stop, lambda: sound.failsafe.failed(RobotError("gone"))):
        sound.failsafe.begin()
        assert sound.drives()
        assert end() is True
        assert sound.robot.asked[-1] == "stop"
        assert not sound.drives()


def test_a_loop_that_cannot_halt_must_not_be_used(broken, sound):
    assert broken.failsafe.halt_loop(1.0) is None
    assert broken.failsafe.fault == "the bus is off"
    broken.flush()
    assert [(event.kind, event.reason) for event in broken.told] == [(EventKind.ERROR, Reason.VELOCITY_LOOP)]
    assert sound.failsafe.halt_loop(1.0) == Travel(1.5)
    assert sound.failsafe.fault == ""


@pytest.mark.parametrize(("error", "fault"), [(RobotError("gone"), ""), (VelocityLoopError("killed"), "killed")])
def test_only_a_lost_loop_is_a_fault_that_lasts(sound, error, fault):
    sound.failsafe.failed(error)
    sound.failsafe.begin()
    assert sound.failsafe.fault == fault


def test_after_two_failures_in_a_row_not_even_zeros_are_written_until_a_goal_begins(broken):
    failsafe, loop = broken.failsafe, broken.loop
    for asked in (True, False):
        failsafe.failed(RobotError("gone"))
        assert failsafe.loop_is_asked is asked
        assert failsafe.end_motion(1.0) is None
    assert loop.asked == ["halt", "silence"]
    failsafe.let_through()
    assert not failsafe.loop_is_asked
    failsafe.begin()
    assert failsafe.loop_is_asked


def test_a_motion_is_halted_however_often_the_robot_failed(broken):
    broken.failsafe.failures, broken.loop.moving = 5, True
    broken.failsafe.end_motion(1.0)
    assert broken.loop.asked == ["halt"]


def test_a_robot_that_never_knows_where_it_is_says_so_once_for_each_goal(broken, caplog):
    for count in (1, 2):
        broken.failsafe.begin()
        assert [broken.failsafe.pose() for _ in range(3)] == [None] * 3
        assert len([record for record in caplog.records if "cannot tell its pose" in record.getMessage()]) == count


@pytest.mark.parametrize("where", [Pose(math.nan, 0.0, 0.0), Pose(0.0, math.inf, 0.0), (1.0, 2.0, 0.0)], ids=str)
def test_what_is_no_pose_is_none(broken, caplog, where):
    """A localisation that has diverged says NaN, which no line of JSON can hold."""
    broken.robot.pose = lambda: where
    assert [broken.failsafe.pose() for _ in range(3)] == [None] * 3
    assert len(caplog.records) == 1
    broken.robot.pose = lambda: Pose(1.0, 2.0, 0.5)
    assert broken.failsafe.pose() == Pose(1.0, 2.0, 0.5)
