"""Robot files: the shipped ones, and what is said about wrong ones."""

from __future__ import annotations

from pathlib import Path

import pytest

from intent_engine.actions import Move, Pick
from intent_engine.errors import ConfigError
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import Reason
from intent_engine.execution.limits import OverLimit
from intent_engine.execution.robots.robot import Capability, Pose
from intent_engine.execution.robots.robot_file import load_robot
from intent_engine.language.locations import load

ROBOTS = sorted((Path(__file__).resolve().parents[2] / "robots").glob("*.yaml"))


def test_a_shipped_robot_is_known_by_its_name():
    assert load_robot("turtlebot3").limits == load_robot(next(p for p in ROBOTS if p.stem == "turtlebot3")).limits
    with pytest.raises(TypeError, match="a robot file is given by path or name, not as NoneType"):
        load_robot(None)


@pytest.mark.parametrize("path", ROBOTS, ids=lambda path: path.stem)
def test_every_shipped_robot_drives(path):
    file = load_robot(path)
    assert file.name == path.stem
    clock = VirtualClock()
    with Executor(file.simulated(clock, slip=0.0, delay=0.0), handle_sigterm=False, **file.executor_options()) as ex:
        (goal,) = ex.submit(Move(0.2, 1.0, 5.0))
        ex.wait(goal)
        assert goal.succeeded
        assert ex.robot.pose().x == pytest.approx(1.0, abs=2e-3)


def test_a_robot_without_an_arm_refuses_to_pick():
    file = load_robot(next(path for path in ROBOTS if path.stem == "turtlebot3"))
    with Executor(file.simulated(VirtualClock()), handle_sigterm=False, **file.executor_options()) as ex:
        (goal,) = ex.submit(Pick("cup"))
        assert goal.reason is Reason.CAPABILITY


def test_everything_in_a_file_is_used(tmp_path):
    path = tmp_path / "r.yaml"
    path.write_text(
        """
name: r
limits: {linear_velocity: {max: 0.3, over: clamp}, distance: 4, over: refuse, linear_deceleration: 2}
footprint: {radius: 0.2}
rates: {rate: 10, valid_for: 0.5, zeros: 2}
capabilities: [move]
policies: {move: queue}
expire_after: 2
hold_limit: 3
simulation: {start: {x: 1, y: 2}, objects: {cup: kitchen}, seed: 4}
"""
    )
    file = load_robot(path)
    assert file.limits.over_each == {"linear_velocity": OverLimit.CLAMP}
    assert (file.limits.distance, file.limits.linear_deceleration, file.footprint.radius) == (4.0, 2.0, 0.2)
    assert (file.rates.rate, file.rates.zeros, file.capabilities) == (10, 2, {Capability.MOVE})
    robot = file.simulated(VirtualClock(), {"kitchen": Pose(3, 0, 0)})
    assert robot.pose() == Pose(1.0, 2.0, 0.0)
    assert robot.objects == {"cup": Pose(3, 0, 0)}
    with pytest.raises(ConfigError, match="kitchen"):
        file.simulated(VirtualClock())


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("name: r\nlimits: {linear_velocty: 1}\n", 2, "did you mean 'linear_velocity'"),
        ("name: r\nlimits:\n  linear_velocity: fast\n", 3, "must be a number"),
        ("name: r\nlimits:\n  linear_velocity: 50 cm/s\n", 3, "in SI units, without a unit: 0.5"),
        ("name: r\nlimits:\n  angular_velocity: 90 deg/s\n", 3, "in SI units, without a unit: 1.5708"),
        ("name: r\nrates: {rate: 20 Hz}\n", 2, "a plain number, in SI units"),
        ("name: r\nhold_limit: 1" + 400 * "0" + "\n", 2, "must be a finite number"),
        ("name: r\nsimulation: {objects: {cup: 1}}\n", 2, "must be text or nothing"),
        ("name: r\nlimits: {angular_velocity: 90}\n", 2, "in rad/s; 90 degrees a second are 1.571"),
        ("name: r\nlimits: {angular_velocity: {max: 45, over: clamp}}\n", 2, "45 rad/s are 7.2 turns a second"),
        ("name: r\nlimits:\n  linear_velocity: -1\n", 3, "must be more than 0"),
        ("name: r\nlimits:\n  distance: .inf\n", 3, "finite"),
        ("name: r\nlimits: {over: clmp}\n", 2, "did you mean 'clamp'"),
        ("name: r\ncapabilities: [move, flying]\n", 2, "'flying' is not known here"),
        ("name: r\ncapabilities: [place]\n", 2, "must be able to pick"),
        ("name: r\nrates: {rate: 2, valid_for: 0.3}\n", 2, "runs out before the next one"),
        ("limits: {}\n", 1, "needs 'name'"),
        ("name: r\nlimits: {linear_velocity: 0}\n", 2, "'linear_velocity' must be more than 0, not 0"),
        ("name: [\n", 1, "is not valid YAML"),
        ("", None, "is empty"),
    ],
)
def test_a_wrong_file_is_told_where_and_what(tmp_path, text, line, words):
    path = tmp_path / "wrong.yaml"
    path.write_text(text)
    with pytest.raises(ConfigError) as caught:
        load_robot(path)
    (problem,) = caught.value.problems
    assert words in str(problem)
    assert problem.line == line
    assert problem.file == str(path)


def test_all_problems_come_at_once(tmp_path):
    path = tmp_path / "wrong.yaml"
    path.write_text("nam: r\nlimits: {distance: 0}\nrate: 3\n")
    with pytest.raises(ConfigError) as caught:
        load_robot(path)
    assert len(caught.value.problems) == 3


def test_a_missing_file_is_told():
    with pytest.raises(ConfigError, match="no such file"):
        load_robot("robots/turtlebot33.yaml")


def test_files_limits_and_maps_that_are_equal_have_one_hash():
    assert len({load_robot("turtlebot3"), load_robot("turtlebot3")}) == 1
    assert len({load("locations/home.yaml"), load("locations/home.yaml")}) == 1
