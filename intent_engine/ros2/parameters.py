"""The node's parameters, declared and checked: every mistake is told at once, with what to write instead."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from enum import StrEnum
from pathlib import Path
from typing import Any, TypeVar

from intent_engine.errors import ConfigError, Problem
from intent_engine.execution.limits import Limits, OverLimit
from intent_engine.execution.motion import Rates
from intent_engine.execution.robots.robot import Capability
from intent_engine.execution.robots.robot_file import RobotFile, load_robot
from intent_engine.execution.robots.ros2_navigation import NavigationWay
from intent_engine.execution.robots.ros2_velocity import Stamped
from intent_engine.hints import did_you_mean
from intent_engine.resources import default_locations, find
from intent_engine.ros2.messages import CommandForm
from intent_engine.ros2.robot_states import PARAMETER, state_names

__all__ = ["NodeParameters", "Parameters", "read_parameters"]

E = TypeVar("E", bound=StrEnum)


class Parameters:
    """Declares parameters of a node one by one, and keeps what is wrong with their values."""

    def __init__(self, node: Any) -> None:
        self._node = node
        self.problems: list[Problem] = []
        self._declared: list[str] = []

    def text(self, name: str, default: str, meaning: str) -> str:
        value = self._declare(name, default, meaning)
        if value is None or (isinstance(value, Iterable) and not isinstance(value, str)):
            self._wrong(name, list(value or ()), "one text")  # None: as rclpy has an empty list
            return default
        # `-p robot:=1` is a number to YAML; whoever wrote it meant a name.
        return str(value)

    def service(self, name: str, default: str, meaning: str) -> str:
        """The name of a service or an action."""
        from rclpy.expand_topic_name import expand_topic_name
        from rclpy.validate_full_topic_name import validate_full_topic_name

        value = self.text(name, default, meaning)
        try:
            whole = expand_topic_name(value, self._node.get_name(), self._node.get_namespace())
            validate_full_topic_name(whole, is_service=True)
        except Exception:  # rclpy has one for each kind of name
            self._wrong(name, value, "a name of ROS: letters, digits and _, with / between them")
            return default
        return value

    def texts(self, name: str, default: str, meaning: str) -> tuple[str, ...]:
        """One text or a list of texts."""
        value = self._declare(name, default, f"{meaning}; one, or a list")
        if value is None:  # as rclpy has an empty list
            self._wrong(name, [], "a name, or a list of names")
            return (default,)
        return tuple(
            str(each) for each in (value if isinstance(value, Iterable) and not isinstance(value, str) else [value])
        )

    def truth(self, name: str, default: bool, meaning: str) -> bool:
        value = self._declare(name, default, meaning)
        if not isinstance(value, bool):
            self._wrong(name, value, "true or false")
            return default
        return value

    def number(self, name: str, default: float, meaning: str) -> float:
        """A number above zero; a whole one may be written without its point."""
        value = self._declare(name, default, meaning)
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value) or value <= 0:
            self._wrong(name, value, "a number above zero")
            return default
        return float(value)

    def choice(self, name: str, kind: Callable[[str], E], default: E, meaning: str) -> E:
        known = ", ".join(type(default))
        value = self._declare(name, default.value, f"{meaning}: {known}")
        try:
            # `stamped:=true` arrives as a truth value.
            return kind(str(value).lower())
        except ValueError:
            self._wrong(name, value, f"one of {known}")
            return default

    def language(self) -> tuple[tuple[Path, ...], tuple[Path, ...]]:
        """Grammar files and map files, which every node of ours takes; without a map, that of the home in the
        grammar's language."""
        grammars = self._files("grammars", self.texts("grammar", "en", "Grammar file, or the name of a shipped one"))
        meaning = "Map file, or the name of a shipped one; empty: the home in the grammar's language"
        named = [name for name in self.texts("locations", "", meaning) if name]
        return grammars, self._files("locations", named) if named else tuple(default_locations(grammars))

    def states(self) -> frozenset[str]:
        """States that the robot is in, which may be set while the node runs; whether the grammar asks for them is not
        known here."""
        value = self._declare("states", [], "States that the robot is in, as the grammar names them", read_only=False)
        try:
            return state_names(value, PARAMETER)
        except ConfigError as error:
            self.problems += error.problems
            return frozenset()

    def check(self) -> None:
        """Call when all are declared.

        Parameters that were given and are none of this node are told of: a misspelled limit limits nothing. They are no
        mistake, since a file's ``/**`` is for other nodes too.

        Raises:
            ConfigError: with everything that is wrong.
        """
        if self.problems:
            raise ConfigError(self.problems)
        given = getattr(self._node, "_parameter_overrides", {})  # rclpy tells of them in no other way
        for name in given:
            if not self._node.has_parameter(name) and not name.startswith("qos_overrides."):
                meant = did_you_mean(name, self._declared)
                message = f"parameter {name}: this node has none of that name, and goes on without it"
                self._node.get_logger().warning(f"{message}; {meant}" if meant else message)

    def _declare(self, name: str, default: Any, meaning: str, read_only: bool = True) -> Any:
        from rcl_interfaces.msg import ParameterDescriptor

        self._declared.append(name)
        # Typed here and not by rclpy, which takes no 20 for a 20.0 and says so with a traceback.
        descriptor = ParameterDescriptor(description=meaning, read_only=read_only, dynamic_typing=True)
        return self._node.declare_parameter(name, default, descriptor).value

    def _files(self, kind: str, names: Iterable[str]) -> tuple[Path, ...]:
        found = []
        for name in names:
            try:
                found.append(find(kind, name))
            except ConfigError as error:
                self.problems += error.problems
        return tuple(found)

    def _wrong(self, name: str, value: Any, wanted: str) -> None:
        self.problems.append(
            Problem(f"parameter {name}: {value!r} is not {wanted}", hint=f"ros2 run ... -p {name}:=...")
        )


@dataclass(frozen=True, slots=True)
class NodeParameters:
    """What the node ``intent_engine`` was told."""

    grammar: tuple[Path, ...]
    locations: tuple[Path, ...]
    robot: RobotFile
    """Limits, rates, policies and capabilities; of a robot file, with what parameters say in their place."""
    stamped: Stamped
    frame_id: str
    navigation: NavigationWay
    navigate_to_pose: str
    """Name of the action."""
    command_form: CommandForm
    guardian: bool
    """Whether the velocity is written by a process of its own."""
    journal: str
    """File; empty: none."""
    states: frozenset[str]
    """That hold from the start."""


DEFAULT = RobotFile(
    name="ros2",
    file="",
    limits=Limits(
        linear_velocity=0.5,
        angular_velocity=1.0,
        distance=20.0,
        angle=4 * math.pi,
        duration=120.0,
        over_each={"linear_velocity": OverLimit.CLAMP, "angular_velocity": OverLimit.CLAMP},
    ),
    capabilities=frozenset({Capability.MOVE, Capability.TURN, Capability.NAVIGATE}),
)
"""A robot of which nothing is known: the tutorials' speed and no more."""


def read_parameters(node: Any) -> NodeParameters:
    """Declare the parameters of the node ``intent_engine`` and read them.

    Raises:
        ConfigError: with everything that is wrong.
    """
    declared = Parameters(node)
    grammar, locations = declared.language()
    name = declared.text("robot", "", "Robot file, or the name of a shipped one; empty: the limits given here")
    robot = DEFAULT
    if name:
        try:
            robot = load_robot(find("robots", name))
        except ConfigError as error:
            declared.problems += error.problems
    limits = _limits(node, declared, robot)
    rate = declared.number("rate", robot.rates.rate, "Hz at which velocities are published while the robot moves")
    ttl = declared.number("ttl", robot.rates.valid_for, "s; a velocity that is not renewed for so long becomes zero")
    rates = robot.rates
    try:
        rates = Rates(rate, ttl, robot.rates.zeros)
    except ValueError as error:
        declared.problems.append(Problem(f"parameters rate and ttl: {error}", hint="ttl must be longer than 1 / rate"))
    expire = declared.number("expire_after", robot.expire_after, "s; text older than this is not acted on")
    navigation = declared.choice("navigation", NavigationWay, NavigationWay.AUTO, "How goals are given to Nav2")
    parameters = NodeParameters(
        grammar=grammar,
        locations=locations,
        robot=replace(robot, limits=limits, rates=rates, expire_after=expire),
        stamped=declared.choice("stamped", Stamped, Stamped.AUTO, "Twist, TwistStamped or what is subscribed to"),
        frame_id=declared.text("frame_id", "base_link", "Frame of TwistStamped"),
        navigation=navigation if Capability.NAVIGATE in robot.capabilities else NavigationWay.NONE,
        navigate_to_pose=declared.service("navigate_to_pose", "navigate_to_pose", "Name of Nav2's action"),
        command_form=declared.choice(
            "command_form", CommandForm, CommandForm.JSON, "How commands are published on voice_commands/command"
        ),
        guardian=declared.truth(
            "guardian", True, "Write velocities from a process of its own, which outlives this one"
        ),
        journal=declared.text("journal", "", "File that every goal is written to, as JSON lines"),
        states=declared.states(),
    )
    declared.check()
    return parameters


def _limits(node: Any, declared: Parameters, robot: RobotFile) -> Limits:
    """A robot's limits. What its file allows, a parameter makes less and never more: nobody who sets it says that this
    robot can do what its file says it cannot."""
    limits = robot.limits
    for name, limit, unit in (("max_linear", "linear_velocity", "m/s"), ("max_angular", "angular_velocity", "rad/s")):
        of_file: float = math.inf if robot is DEFAULT else getattr(robot.limits, limit)
        usual: float = of_file if math.isfinite(of_file) else getattr(DEFAULT.limits, limit)
        told = declared.number(name, usual, f"{unit}; faster is driven at this")
        if told > of_file:
            node.get_logger().warning(f"parameter {name}: the robot file allows no more than {of_file:g} {unit}")
        changes: dict[str, Any] = {limit: min(told, of_file)}
        if math.isinf(of_file):
            changes["over_each"] = {**limits.over_each, limit: OverLimit.CLAMP}
        try:
            limits = replace(limits, **changes)
        except ValueError as error:  # in degrees
            declared.problems.append(Problem(f"parameter {name}: {error}", hint=f"ros2 run ... -p {name}:=..."))
    return limits
