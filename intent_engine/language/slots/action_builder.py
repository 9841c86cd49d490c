"""Slot values to a typed action, as the grammar file declares it."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping
from typing import TYPE_CHECKING, Any

from intent_engine.actions import Action, ChangeSpeed, Custom, Move, Navigate, Pick, Place, Stop, Turn
from intent_engine.interpretation import Cause
from intent_engine.language.grammar import ACTION_PARAMETERS, Condition, Intent, Slot
from intent_engine.language.loading.grammar_intents import slot_of_parameter, with_defaults
from intent_engine.language.quantities import Relative

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["CannotActError", "build_action", "check_speeds", "defaults_of", "holds", "names_taken"]

MOVE_SPEED = 0.5
"""m/s, where a grammar gives no default."""
MOVE_DURATION = 2.0
"""s"""
TURN_SPEED = 0.5
"""rad/s"""
TURN_DURATION = 1.5
"""s. These four are the tutorials' own: forward 0.5 m/s for 2 s, turn 0.5 rad/s for 1.5 s."""

_BACKWARD = frozenset(("backward", "backwards", "back"))
_RIGHT = frozenset(("right", "clockwise"))


class CannotActError(ValueError):
    """The slots do not make an action; the message is the reason for the person who spoke, with what kind it is of."""

    def __init__(self, reason: str, *causes: Cause) -> None:
        super().__init__(reason)
        self.causes = frozenset(causes)


def build_action(intent: Intent, said: Mapping[str, Any], locations: LocationMap | None) -> Action:
    """The action of an intent.

    Args:
        intent: with its action, defaults and conditions.
        said: slot label to value; quantities in SI units.
        locations: the map, for navigation.

    Raises:
        CannotActError: something is missing, zero or not on the map.
    """
    spec = intent.action
    if spec.type == "stop":
        return Stop()
    defaults = defaults_of(intent, said)
    if spec.type == "custom":
        return _custom(intent, said, defaults)
    parameters = _Parameters(spec.parameters, said, defaults)
    if spec.type == "move":
        return _move(parameters)
    if spec.type == "turn":
        return _turn(parameters)
    if spec.type == "navigate":
        return _navigate(parameters, locations)
    if spec.type == "pick":
        return Pick(str(parameters.need("object")))
    if spec.type == "change_speed":
        return ChangeSpeed(_positive("factor", float(parameters.need("factor"))))
    thing, location = parameters.get("object"), parameters.get("location")
    return Place(None if thing is None else str(thing), None if location is None else str(location))


def defaults_of(intent: Intent, said: Mapping[str, Any]) -> dict[str, Any]:
    """The defaults that hold for what was said; a later condition wins over an earlier one."""
    defaults = dict(intent.defaults)
    for condition in intent.when:
        if holds(condition, said):
            defaults = with_defaults(intent.action, defaults, condition.defaults)
    return defaults


def names_taken(intent: Intent, said: Mapping[str, Any]) -> frozenset[str]:
    """The labels of the things, places and choices that were said and that the action of an intent takes."""
    spec = intent.action
    names = frozenset(label for label, value in said.items() if isinstance(value, str | bool))
    if spec.type == "custom" and not spec.parameters:
        return names
    parameters = spec.parameters if spec.type == "custom" else ACTION_PARAMETERS[spec.type]
    return names & {slot_of_parameter(spec, parameter) for parameter in parameters}


def holds(condition: Condition, said: Mapping[str, Any]) -> bool:
    """Whether a condition's slots have its values."""
    return all(_same(said.get(label), value) for label, value in condition.slots.items())


def _same(value: Any, wanted: Any) -> bool:
    return bool(value == wanted) or (isinstance(value, str) and value == str(wanted))


class _Parameters:
    """What an action asks for, from what was said, else from a default."""

    def __init__(self, mapping: Mapping[str, Any], said: Mapping[str, Any], defaults: Mapping[str, Any]) -> None:
        self._mapping = mapping
        self._said = said
        self._defaults = defaults

    def said(self, name: str) -> Any:
        """The value that was spoken or fixed by the grammar; None if only a default could give it."""
        source = self._mapping.get(name)
        if source is None:
            return self._said.get(name)
        if isinstance(source, str) and source.startswith("{"):
            return self._said.get(source.strip("{}"))
        return source

    def default(self, name: str) -> Any:
        source = self._mapping.get(name)
        if isinstance(source, str) and source.startswith("{"):
            return self._defaults.get(source.strip("{}"), self._defaults.get(name))
        return self._defaults.get(name)

    def get(self, name: str) -> Any:
        value = self.said(name)
        return self.default(name) if value is None else value

    def need(self, name: str) -> Any:
        value = self.get(name)
        if value is None:
            raise CannotActError(f"no {name} was said")
        return value

    def speed(self, default: float) -> tuple[float, bool]:
        """The speed, and whether it was said."""
        usual = self.default("speed")
        usual = default if usual is None else float(usual)
        value = self.said("speed")
        if isinstance(value, Relative):
            return usual * value.factor, True
        if value is None:
            return usual, False
        return float(value), True


def _positive(name: str, value: float) -> float:
    if not math.isfinite(value) or value <= 0:
        article = "an" if name.startswith("a") else "a"
        raise CannotActError(f"{article} {name} of {value:g} cannot be driven")
    return value


def _move(parameters: _Parameters) -> Move:
    distance, speed, duration, backward = _driven(parameters, "distance", MOVE_SPEED, MOVE_DURATION, _BACKWARD)
    return Move(-speed if backward else speed, distance, duration)


def _turn(parameters: _Parameters) -> Turn:
    angle, speed, duration, right = _driven(parameters, "angle", TURN_SPEED, TURN_DURATION, _RIGHT)
    sign = -1.0 if right else 1.0
    return Turn(sign * angle, sign * speed, duration)


def _driven(
    parameters: _Parameters, way: str, usual_speed: float, usual_duration: float, negative: Collection[str]
) -> tuple[float, float, float, bool]:
    """How far, how fast and how long something is driven, each above zero, and whether in the negative direction. Of
    the three, what was not said follows from the others.

    Args:
        parameters: what was said of it.
        way: how far is called: "distance" or "angle".
        usual_speed: in m/s or rad/s, where no other is known.
        usual_duration: in s, where neither how far nor how long is known.
        negative: words for the negative direction.
    """
    speed, speed_said = parameters.speed(usual_speed)
    direction = parameters.get("direction")
    backward = isinstance(direction, str) and direction in negative
    far, duration = parameters.said(way), parameters.said("duration")
    if far is None and duration is None:
        far, duration = parameters.default(way), parameters.default("duration")
        if far is None and duration is None:
            duration = usual_duration
    if far is None:
        duration = _positive("duration", duration)
        far = _positive("speed", speed) * duration
    else:
        if far < 0:
            backward = not backward
        far = _positive(way, abs(far))
        if duration is not None and not speed_said:
            speed = far / _positive("duration", duration)
        duration = far / _positive("speed", speed)
    # What was divided may have become too small or too large for a number.
    for name, value in ((way, far), ("duration", duration), ("speed", speed)):
        _positive(name, value)
    return far, speed, duration, backward


def _navigate(parameters: _Parameters, locations: LocationMap | None) -> Navigate:
    name = str(parameters.need("location"))
    place = locations.get(name) if locations is not None else None
    if place is None:
        raise CannotActError(f"{name!r} is not on the map")
    return Navigate(place.name, place.x, place.y, place.yaw, place.frame)


def _custom(intent: Intent, said: Mapping[str, Any], defaults: Mapping[str, Any]) -> Custom:
    heard = {label: _in_full(label, value, defaults) for label, value in said.items() if value is not None}
    values = {**defaults, **heard}
    if intent.action.parameters:
        mapped = {}
        for name, source in intent.action.parameters.items():
            if isinstance(source, str) and source.startswith("{"):
                mapped[name] = values.get(source.strip("{}"))
            else:
                mapped[name] = source
        values = mapped
    plain = {
        name: value for name, value in values.items() if value is None or isinstance(value, (str, int, float, bool))
    }
    return Custom(intent.action.name or intent.name, plain)


def check_speeds(intent: Intent, said: Mapping[str, Any], slots: Iterable[tuple[str, Slot]]) -> None:
    """Hold the speeds that a program gets, said in terms of the usual one, to the limits of their slots. What a robot
    moves by itself has the robot's own limits.

    Raises:
        CannotActError: one is beyond them, or nothing says what is usual.
    """
    if intent.action.type != "custom" or not any(isinstance(value, Relative) for value in said.values()):
        return
    defaults = defaults_of(intent, said)
    for label, slot in slots:
        if isinstance(said.get(label), Relative):
            value = _in_full(label, said[label], defaults)
            if (beyond := slot.beyond(value)) is not None:
                raise CannotActError(f"{label} of {slot.written(value)} is {beyond[1]}", Cause.BEYOND_LIMITS)


def _in_full(label: str, value: Any, defaults: Mapping[str, Any]) -> Any:
    """A value as a program can use it: "half speed" is half of the default, in SI units. A bare factor would be taken
    for meters per second.

    Raises:
        CannotActError: there is no default.
    """
    if not isinstance(value, Relative):
        return value
    usual = defaults.get(label)
    if not isinstance(usual, (int, float)):
        share = f"{value.factor:g} times of"
        raise CannotActError(f"no usual {label} is known that this could be {share}: the intent has no default for it")
    return usual * value.factor
