"""Robot files: what one robot is, may do, and how fast."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from typing import Any

from intent_engine.errors import ConfigError, Problem
from intent_engine.execution.clock import Clock
from intent_engine.execution.limits import IN_DEGREES, Limits, OverLimit
from intent_engine.execution.motion import Rates
from intent_engine.execution.robots.robot import Capability, Pose
from intent_engine.execution.robots.simulated import SimulatedRobot
from intent_engine.resources import find

__all__ = ["Footprint", "RobotFile", "load_robot", "robot_schema"]


@dataclass(frozen=True, slots=True)
class Footprint:
    """The ground that a robot covers: a circle, or a rectangle about its centre."""

    radius: float | None = None
    """m"""
    length: float | None = None
    """m, along x"""
    width: float | None = None
    """m, along y"""


@dataclass(frozen=True, slots=True)
class RobotFile:
    """A robot file, checked. ``Executor(robot, **file.executor_options())`` drives by it."""

    name: str
    file: str
    description: str = ""
    limits: Limits = field(default_factory=Limits)
    rates: Rates = field(default_factory=Rates)
    footprint: Footprint = field(default_factory=Footprint)
    capabilities: frozenset[Capability] = frozenset(Capability)
    policies: Mapping[str, str] = field(default_factory=dict, hash=False)
    expire_after: float = 5.0
    """s"""
    hold_limit: float = 10.0
    """s"""
    simulation: Mapping[str, Any] = field(default_factory=dict, hash=False)

    def executor_options(self) -> dict[str, Any]:
        """Keyword arguments for the executor."""
        return {
            "limits": self.limits,
            "rates": self.rates,
            "policies": self.policies,
            "expire_after": self.expire_after,
            "hold_limit": self.hold_limit,
        }

    def simulated(
        self, clock: Clock | None = None, locations: Mapping[str, Pose] | None = None, **changes: Any
    ) -> SimulatedRobot:
        """A simulated robot of this kind.

        Args:
            clock: shared with the executor.
            locations: name -> pose.
            changes: options of :class:`SimulatedRobot` that replace those of the file.

        Raises:
            ConfigError: an object of the file stands at a place that is not on the map.
        """
        options = {"navigation_speed": min(0.5, self.limits.linear_velocity)} | dict(self.simulation) | changes
        start = options.pop("start", None)
        if isinstance(start, Mapping):
            start = Pose(float(start["x"]), float(start["y"]), float(start.get("yaw", 0.0)))
        places = dict(locations or {})
        for name, where in (options.get("objects") or {}).items():
            if isinstance(where, str) and where not in places:
                raise ConfigError(
                    Problem(
                        f"simulation.objects: {name!r} stands at {where!r}, which is not on the map",
                        self.file,
                        hint="known: " + ", ".join(sorted(places)) if places else "give a map with the robot",
                    )
                )
        if start is not None:
            options["start"] = start
        return SimulatedRobot(clock, locations=places, capabilities=self.capabilities, **options)


@cache
def robot_schema() -> dict[str, Any]:
    """The JSON Schema of a robot file."""
    import json

    text = resources.files("intent_engine.execution.robots").joinpath("robot.schema.json").read_text("utf-8")
    schema: dict[str, Any] = json.loads(text)
    return schema


def load_robot(path: str | os.PathLike[str]) -> RobotFile:
    """Read and check a robot file: a path, or the name of one that comes with the engine (``"turtlebot3"``).

    Raises:
        ConfigError: with every problem in it, each with file, line and column.
        TypeError: neither a path nor a name was given.
    """
    if not isinstance(path, str | os.PathLike):
        raise TypeError(f"a robot file is given by path or name, not as {type(path).__name__}")
    # Reading YAML with the place of each value is the language room's; a program that drives without files needs none.
    from intent_engine.language.loading.file_kind import given_for
    from intent_engine.language.loading.schema_problems import schema_problems
    from intent_engine.language.loading.yaml_source import read_yaml

    source = read_yaml(find("robots", os.fspath(path)), shortest="the shortest robot file: {name: rover}")
    if source.problems:
        raise ConfigError(source.problems)
    if (other := given_for("robot file", source.data, source.file)) is not None:
        raise ConfigError(other)
    problems = schema_problems(source, robot_schema())
    if problems:
        raise ConfigError(problems)
    data: dict[str, Any] = source.data
    wrong: list[Problem] = []

    def problem(where: tuple[str, ...], message: str, hint: str | None = None) -> None:
        place = source.place(where)
        wrong.append(Problem(message, source.file, place.line, place.column, place.source, hint))

    for where in source.marks:
        value = _at(data, where)
        if type(value) in (int, float) and not _finite(value):
            problem(tuple(str(part) for part in where), f"{where[-1]!r} must be a finite number", "leave it out")
    turning = data.get("limits", {}).get("angular_velocity")
    fastest = turning["max"] if isinstance(turning, Mapping) else turning
    if fastest is not None and IN_DEGREES <= fastest < math.inf:
        message = f"{fastest:g} rad/s are {fastest / math.tau:.1f} turns a second, which limits no robot"
        hint = f"in rad/s; {fastest:g} degrees a second are {math.radians(fastest):.4g}"
        problem(("limits", "angular_velocity"), message, hint)
    rates = Rates()
    try:
        rates = Rates(**data.get("rates", {}))
    except ValueError as error:
        problem(("rates",), str(error), "a velocity must outlive the time to the next one")
    capabilities = frozenset(Capability(name) for name in data.get("capabilities", list(Capability)))
    if Capability.PLACE in capabilities and Capability.PICK not in capabilities:
        problem(("capabilities",), "a robot that can place must be able to pick", "add pick, or leave place out")
    if wrong:
        raise ConfigError(wrong)
    return RobotFile(
        name=data["name"],
        file=source.file,
        description=data.get("description", ""),
        limits=_limits(data.get("limits", {})),
        rates=rates,
        footprint=Footprint(**data.get("footprint", {})),
        capabilities=capabilities,
        policies=dict(data.get("policies", {})),
        expire_after=float(data.get("expire_after", 5.0)),
        hold_limit=float(data.get("hold_limit", 10.0)),
        simulation=dict(data.get("simulation", {})),
    )


def _limits(data: Mapping[str, Any]) -> Limits:
    values: dict[str, float] = {}
    over: dict[str, OverLimit] = {}
    for name, value in data.items():
        if name == "over":
            continue
        if isinstance(value, Mapping):
            values[name] = float(value["max"])
            if "over" in value:
                over[name] = OverLimit(value["over"])
        else:
            values[name] = float(value)
    return Limits(over=OverLimit(data.get("over", OverLimit.REFUSE)), over_each=over, **values)


def _finite(value: float) -> bool:
    """Whether it can be reckoned with: a whole number in YAML may have any number of digits."""
    try:
        return math.isfinite(value)
    except OverflowError:
        return False


def _at(data: Any, path: tuple[str | int, ...]) -> Any:
    for part in path:
        try:
            data = data[part]
        except (KeyError, IndexError, TypeError):
            return None
    return data
