"""What a robot is told to do: frozen values in SI units and ROS axes.

Axes follow REP 103: x forward, y left, z up; angles are in radians, positive to the left (counter-clockwise).
Every action goes to JSON with :func:`to_json` and comes back with :func:`from_json`; the shape is fixed by
``actions.schema.json`` in this package (:func:`json_schema`).
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from dataclasses import MISSING, Field, dataclass, field, fields
from functools import cache
from pathlib import Path
from typing import Any, ClassVar, TypeAlias

from intent_engine.values import WHOLE_TURN, check_text, is_number

__all__ = [
    "ACTION_TYPES",
    "Action",
    "ChangeSpeed",
    "Custom",
    "Move",
    "Navigate",
    "Pick",
    "Place",
    "Stop",
    "Turn",
    "actions_of",
    "from_json",
    "json_schema",
    "to_json",
]


def _finite(owner: object, **values: float) -> None:
    for name, value in values.items():
        if type(value) is not float and type(value) is not int:
            if not is_number(value):
                raise TypeError(f"{type(owner).__name__}.{name} is a number in SI units, not {value!r:.80}")
            object.__setattr__(owner, name, float(value))  # of NumPy, say, which JSON has no word for
        if not math.isfinite(value):
            raise ValueError(f"{type(owner).__name__}.{name} must be a finite number, not {value}")


def _in_degrees(name: str, value: float) -> str:
    """What is wrong with an angle that was probably meant in degrees."""
    turns = f"{value:g} rad are {abs(value) / math.tau:.1f} turns"
    return f"{name} is in rad, and {turns}: {value:g} degrees are math.radians({value:g})"


def _text(owner: object, empty: bool = True, **values: str) -> None:
    for name, value in values.items():
        check_text(f"{type(owner).__name__}.{name}", value, empty=empty)


@dataclass(frozen=True, slots=True)
class Move:
    """Drive straight along the robot's x axis."""

    type: ClassVar[str] = "move"
    linear_velocity: float
    """m/s, negative is backward."""
    distance: float
    """m, never negative; the direction is in the velocity's sign."""
    duration: float
    """s, ``distance / abs(linear_velocity)``."""

    def __post_init__(self) -> None:
        _finite(self, linear_velocity=self.linear_velocity, distance=self.distance, duration=self.duration)
        if self.distance < 0 or self.duration < 0:
            raise ValueError("Move.distance and Move.duration must not be negative")


@dataclass(frozen=True, slots=True)
class Turn:
    """Turn on the spot about the robot's z axis."""

    type: ClassVar[str] = "turn"
    angle: float
    """rad, positive to the left."""
    angular_velocity: float
    """rad/s, with the sign of ``angle``, so that it can be sent as ``Twist.angular.z`` as it is."""
    duration: float
    """s, ``abs(angle / angular_velocity)``."""

    def __post_init__(self) -> None:
        _finite(self, angle=self.angle, angular_velocity=self.angular_velocity, duration=self.duration)
        if type(self.angle) is int and abs(self.angle) > WHOLE_TURN:  # that is how degrees are written
            raise ValueError(f"{_in_degrees('Turn.angle', self.angle)}, or {float(self.angle)} if you mean it")
        if self.duration < 0:
            raise ValueError("Turn.duration must not be negative")
        if self.angle * self.angular_velocity < 0:
            raise ValueError("Turn.angle and Turn.angular_velocity must have the same sign")


@dataclass(frozen=True, slots=True)
class Stop:
    """Zero velocity now, forget what is queued, cancel navigation."""

    type: ClassVar[str] = "stop"


@dataclass(frozen=True, slots=True)
class Navigate:
    """Go to a pose on the map."""

    type: ClassVar[str] = "navigate"
    location: str
    """The name in the map file (never an alias)."""
    x: float
    """m, in ``frame``."""
    y: float
    """m, in ``frame``."""
    yaw: float
    """rad, in ``frame``, positive to the left of its x axis."""
    frame: str = "map"

    def __post_init__(self) -> None:
        if type(self.location) is not str or type(self.frame) is not str:  # a quick look: every sentence makes actions
            _text(self, location=self.location, frame=self.frame)
        _finite(self, x=self.x, y=self.y, yaw=self.yaw)
        if not -WHOLE_TURN <= self.yaw <= WHOLE_TURN:
            raise ValueError(_in_degrees("Navigate.yaw", self.yaw))


@dataclass(frozen=True, slots=True)
class Pick:
    """Take hold of an object."""

    type: ClassVar[str] = "pick"
    object: str

    def __post_init__(self) -> None:
        if type(self.object) is not str or not self.object.strip():
            _text(self, empty=False, object=self.object)


@dataclass(frozen=True, slots=True)
class Place:
    """Put down what is held, or a named object, here or at a location."""

    type: ClassVar[str] = "place"
    object: str | None = None
    """None: whatever is held."""
    location: str | None = None
    """A map name or a place in words ("table"); None: here."""

    def __post_init__(self) -> None:
        if self.object is not None and type(self.object) is not str:
            _text(self, object=self.object)
        if self.location is not None and type(self.location) is not str:
            _text(self, location=self.location)


@dataclass(frozen=True, slots=True)
class ChangeSpeed:
    """Do what the robot drives or turns just now faster, or slower: just as far, within the robot's limits."""

    type: ClassVar[str] = "change_speed"
    factor: float
    """Times its present speed: over 1 is faster. Positive."""

    def __post_init__(self) -> None:
        _finite(self, factor=self.factor)
        if self.factor <= 0:
            raise ValueError(f"ChangeSpeed.factor is positive, not {self.factor}: to come to rest, Stop()")


@dataclass(frozen=True, slots=True)
class Custom:
    """An action of the user's own; the handler registered under ``name`` gets it."""

    type: ClassVar[str] = "custom"
    name: str
    slots: Mapping[str, Any] = field(default_factory=dict)
    """Slot values: strings, numbers in SI units, booleans or None."""

    def __post_init__(self) -> None:
        if type(self.name) is not str or not self.name.strip():
            _text(self, empty=False, name=self.name)
        if not isinstance(self.slots, Mapping):
            raise TypeError(f"Custom.slots are a dictionary, as {{'person': 'Ada'}}, not {self.slots!r:.80}")

    def __hash__(self) -> int:
        return hash((self.name, frozenset(self.slots)))  # of the names alone: what a slot holds may be anything


Action: TypeAlias = Move | Turn | Stop | Navigate | Pick | Place | ChangeSpeed | Custom

_TYPES: dict[str, type[Any]] = {
    kind.type: kind for kind in (Move, Turn, Stop, Navigate, Pick, Place, ChangeSpeed, Custom)
}


ACTION_TYPES = tuple(_TYPES)
"""What ``type`` of an action may be."""


def actions_of(taker: str, given: Action | Iterable[Action]) -> tuple[Action, ...]:
    """The actions that a program gave to ``taker``: one, or several in order.

    Raises:
        TypeError: something among them is no action; says what to give instead.
    """
    several = isinstance(given, Iterable) and not isinstance(given, str | bytes | Mapping)
    listed: tuple[Any, ...] = tuple(given) if several else (given,)  # type: ignore[arg-type]
    for action in listed:
        if isinstance(action, type) or not isinstance(getattr(action, "type", None), str):
            message = f"{taker} takes actions (Move, Turn, Stop, ...), not {_kind(action)}"
            raise TypeError(message + _instead(action))
    return listed


def _kind(given: object) -> str:
    return f"the class {given.__name__}" if isinstance(given, type) else type(given).__name__


def _instead(given: object) -> str:
    """What was probably meant by what is no action."""
    if isinstance(given, type):
        return ": make one of it"
    if isinstance(given, str):
        return ": engine.parse(text).actions are those of a text"
    if isinstance(given, Mapping):
        return ": from_json(...) makes one of a dictionary"
    return ": give its .actions" if hasattr(given, "actions") else ""


def to_json(action: Action) -> dict[str, Any]:
    """A plain dictionary with ``type`` first; ``json.dumps`` of it is valid under :func:`json_schema`.

    Raises:
        TypeError: it is no action, or several.
    """
    if not hasattr(action, "type") or isinstance(action, type):
        hint = ": one at a time" if isinstance(action, list | tuple) else _instead(action)
        raise TypeError(f"to_json takes an action, not {_kind(action)}{hint}")
    data: dict[str, Any] = {"type": action.type}
    for item in fields(action):
        value = getattr(action, item.name)
        data[item.name] = dict(value) if isinstance(value, Mapping) else value
    return data


def from_json(data: Mapping[str, Any] | str) -> Action:
    """The action that :func:`to_json` wrote.

    Raises:
        ValueError: the type is unknown, a field is missing, unknown or of the wrong kind.
    """
    if isinstance(data, str):
        data = json.loads(data)
    if not isinstance(data, Mapping):
        raise ValueError(f"an action is a JSON object, not {type(data).__name__}")
    values = dict(data)
    name = values.pop("type", None)
    kind = _TYPES.get(name) if isinstance(name, str) else None
    if kind is None:
        raise ValueError(f"unknown action type {data.get('type')!r}; known: {', '.join(_TYPES)}")
    known = {item.name: item for item in fields(kind)}
    for name, value in values.items():
        if name not in known:
            raise ValueError(f"{data['type']} has no field {name!r}; it has {', '.join(known) or 'none'}")
        values[name] = _field_value(f"{data['type']}.{name}", str(known[name].type), value)
    missing = [item.name for item in fields(kind) if item.name not in values and _required(item)]
    if missing:
        *first, last = missing
        raise ValueError(f"{data['type']} needs {', '.join(first)}{' and ' if first else ''}{last}")
    try:
        action: Action = kind(**values)
    except TypeError as error:
        raise ValueError(f"{data['type']}: {error}") from None
    return action


def _field_value(name: str, expected: str, value: Any) -> Any:
    """The value of a field, from JSON.

    Args:
        name: of the action's type and the field.
        expected: the type of the field, as it is annotated.
        value: from JSON.

    Raises:
        ValueError: it is of another kind.
    """
    if expected == "float":
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise ValueError(f"{name} must be a number, not {value!r}")
        try:
            return float(value)
        except OverflowError:
            raise ValueError(f"{name} must be a finite number") from None
    if "Mapping" in expected:
        if not isinstance(value, Mapping):
            raise ValueError(f"{name} must be an object, not {value!r}")
        for key, slot in value.items():
            if not (isinstance(key, str) and (slot is None or isinstance(slot, (str, int, float)))):
                raise ValueError(f"{name}[{key!r}] must be a string, number, boolean or null")
    elif not (isinstance(value, str) or (value is None and "None" in expected)):
        raise ValueError(f"{name} must be a string, not {value!r}")
    return value


def _required(item: Field[Any]) -> bool:
    return item.default is MISSING and item.default_factory is MISSING


@cache
def json_schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of one action. Its ``$id`` carries the version of the format."""
    text = (Path(__file__).parent / "actions.schema.json").read_text("utf-8")
    schema: dict[str, Any] = json.loads(text)
    return schema
