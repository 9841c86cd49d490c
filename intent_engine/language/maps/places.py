"""The places of a large map, kept as columns.

Objects for 100,000 places take several times the memory, and every run of the garbage collector looks at each of them;
so a :class:`Location` is made when it is first asked for.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Mapping, Sequence

from intent_engine.language.maps.map_draft import Location

__all__ = ["Places"]

Particulars = tuple[str, tuple[str, ...], tuple[str, ...]]
"""Frame, aliases and tags."""


class Places(Mapping[str, Location]):
    """Locations by name.

    Args:
        names: each once.
        poses: x, y and yaw of each, one after the other; m and rad.
        particulars: of the places that have any.
        frame: of the places that have none.
    """

    __slots__ = ("_at", "_frame", "_made", "_particulars", "_poses")

    def __init__(
        self, names: Sequence[str], poses: array[float], particulars: Mapping[str, Particulars], frame: str
    ) -> None:
        self._at = dict(zip(names, range(0, 3 * len(names), 3), strict=True))
        self._poses = poses
        self._particulars = dict(particulars)
        self._frame = frame
        self._made: dict[str, Location] = {}

    def __getitem__(self, name: str) -> Location:
        place = self._made.get(name)
        if place is None:
            at = self._at[name]
            x, y, yaw = self._poses[at : at + 3]
            place = Location(name, x, y, yaw, *self._particulars.get(name, (self._frame, (), ())))
            self._made[name] = place
        return place

    def __contains__(self, name: object) -> bool:
        return name in self._at

    def __iter__(self) -> Iterator[str]:
        return iter(self._at)

    def __len__(self) -> int:
        return len(self._at)

    def __repr__(self) -> str:
        return f"Places({len(self)})"

    def spoken(self) -> Iterator[tuple[str, str]]:
        """(name or alias, name), place by place."""
        for name in self._at:
            yield name, name
            for alias in self._particulars[name][1] if name in self._particulars else ():
                yield alias, name
