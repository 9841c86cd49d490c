"""The hand of a simulated robot: what lies where, and what it holds."""

from __future__ import annotations

import math
from collections.abc import Mapping

from intent_engine.errors import RobotError
from intent_engine.execution.robots.robot import Pose

__all__ = ["SimulatedHand"]


class SimulatedHand:
    """Picks and places what is within reach. It has no lock: the robot whose hand it is has one.

    Args:
        locations: name -> pose.
        objects: object -> name of a location, a pose, or None for "at hand"; None: everything is everywhere.
        reach: m within which it can pick and place.

    Raises:
        RobotError: an object is said to be at a place that is not on the map.
    """

    def __init__(
        self, locations: Mapping[str, Pose], objects: Mapping[str, str | Pose | None] | None, reach: float
    ) -> None:
        self._locations = locations
        self.reach = reach
        self.holding: str | None = None
        self.objects: dict[str, Pose | None] | None = None
        if objects is not None:
            self.objects = {name: self._where(name, where) for name, where in objects.items()}

    def take(self, name: str, here: Pose) -> str:
        """Pick, standing at ``here``; returns why it failed, or nothing."""
        if self.holding is not None:
            return "" if self.holding == name else f"it holds the {self.holding} already"
        if self.objects is not None:
            if name not in self.objects:
                known = ", ".join(sorted(self.objects)) or "nothing"
                return f"there is no {name} here; there is: {known}"
            where = self.objects[name]
            if where is not None and (far := _distance(here, where)) > self.reach:
                return f"the {name} is {far:.1f} m away, and it reaches {self.reach:g} m"
        self.holding = name
        return ""

    def put(self, name: str | None, location: str | None, here: Pose) -> str:
        """Place, standing at ``here``; returns why it failed, or nothing."""
        if self.holding is None:
            return "it holds nothing"
        if name is not None and name != self.holding:
            return f"it holds the {self.holding}, not the {name}"
        place = here
        if location is not None and location in self._locations:
            place = self._locations[location]
            if (far := _distance(here, place)) > self.reach:
                return f"{location} is {far:.1f} m away, and it reaches {self.reach:g} m"
        if self.objects is not None:
            self.objects[self.holding] = place
        self.holding = None
        return ""

    def _where(self, name: str, where: str | Pose | None) -> Pose | None:
        if where is None or isinstance(where, Pose):
            return where
        if not isinstance(where, str):
            kinds = "the name of a location, a Pose, or None for at hand"
            raise TypeError(f"where {name!r} is, is {kinds}, not {where!r:.80}")
        if where not in self._locations:
            raise RobotError(f"{name!r} is said to be at {where!r}, which is not on the simulated robot's map")
        return self._locations[where]


def _distance(here: Pose, there: Pose) -> float:
    return math.hypot(there.x - here.x, there.y - here.y)
