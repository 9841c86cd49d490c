"""Waypoint files of Nav2: what its RViz panel saves, and what programs around it keep.

The panel (``nav2_rviz_plugins``) writes ``pose: [x, y, z]`` and ``orientation: [w, x, y, z]`` under ``waypoint0``,
``waypoint1`` and so on; others write the fields of ``geometry_msgs/PoseStamped``, or x, y and yaw. Three numbers alone
are refused unless the last is 0: nobody can say whether that was z or yaw.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from intent_engine.hints import did_you_mean
from intent_engine.language.loading.several_names import on_several_lines
from intent_engine.language.loading.yaml_source import YamlPath, YamlSource
from intent_engine.language.maps.map_draft import DEFAULT_FRAME, Draft, Row

__all__ = ["read_waypoints"]

_KNOWN = (
    "name", "x", "y", "z", "yaw", "pose", "position", "orientation", "header", "frame_id", "frame", "aliases", "tags",
)  # fmt: skip
_GEODETIC = ("latitude", "longitude", "lat", "lon")


class _WrongError(Exception):
    """A row that cannot be read, told in one sentence, with a hint."""


def read_waypoints(source: YamlSource) -> Draft:
    """The places of a file that has ``waypoints:``."""
    data = source.data
    frame = data.get("frame_id", data.get("frame", DEFAULT_FRAME))
    draft = Draft(frame=frame, problems=source.problems)
    if not isinstance(frame, str):
        source.problem(("frame_id",), "the frame must be a name, as map")
        return draft
    rows = data["waypoints"]
    if not isinstance(rows, (dict, list)) or not rows:
        source.problem(
            ("waypoints",), "waypoints must be a list or a mapping of poses", "- {name: kitchen, x: 5, y: 2}"
        )
        return draft
    draft.rows = list(_rows(source, rows))
    return draft


def _rows(source: YamlSource, rows: dict[str, Any] | list[Any]) -> Iterator[Row]:
    keys: list[Any] = list(rows) if isinstance(rows, dict) else list(range(len(rows)))
    for number, key in enumerate(keys, 1):
        path: YamlPath = ("waypoints", key)
        row = rows[key]
        name = key if isinstance(rows, dict) else f"waypoint {number}"
        if isinstance(row, Mapping) and "name" in row:
            name = row["name"]
        if not isinstance(name, str):
            raw = source.raw.get((*path, "name"), name)
            source.problem((*path, "name"), f"YAML reads the name {raw} as a value, not a word", f'quote it: "{raw}"')
            continue
        if on_several_lines(source, path):
            continue
        try:
            values = _values(row)
        except _WrongError as error:
            message, hint = error.args
            source.problem(path, f"waypoint {name!r} {message}", hint)
            continue
        yield Row(name, values, _teller(source, path))


def _teller(source: YamlSource, path: YamlPath) -> Any:
    def tell(key: str, message: str, hint: str | None) -> Any:
        place = source.place((*path, key) if key else path)
        from intent_engine.errors import Problem

        return Problem(message, source.file, place.line, place.column, place.source, hint)

    return tell


def _values(row: Any) -> dict[str, Any]:
    """A row as x, y, yaw and what else a place has."""
    if isinstance(row, list):
        x, y, yaw = _three(row, "x, y and yaw")
        return {"x": x, "y": y, "yaw": yaw}
    if not isinstance(row, Mapping):
        raise _WrongError("must be a pose", "{name: kitchen, x: 5, y: 2, yaw: 0}")
    if any(key in row for key in _GEODETIC):
        hint = "convert it to m in the map's frame, as robot_localization's fromLL service does"
        raise _WrongError("is given in latitude and longitude, not in m", hint)
    for key in row:
        if key not in _KNOWN:
            hint = did_you_mean(str(key), _KNOWN) or f"known here: {', '.join(_KNOWN)}"
            raise _WrongError(f"has an unknown key {key!r}", hint)
    found: dict[str, Any] = {key: row[key] for key in ("aliases", "tags") if key in row}
    header = row.get("header")
    frame = row.get("frame_id", row.get("frame", header.get("frame_id") if isinstance(header, Mapping) else None))
    if frame is not None:
        found["frame"] = frame
    pose = row.get("pose", row)
    if isinstance(pose, Mapping) and isinstance(pose.get("pose"), Mapping):
        header = pose.get("header")
        if "frame" not in found and isinstance(header, Mapping) and "frame_id" in header:
            found["frame"] = header["frame_id"]
        pose = pose["pose"]
    found.update(_pose(pose, row))
    return found


def _pose(pose: Any, row: Mapping[str, Any]) -> dict[str, Any]:
    heading = {**row, **pose} if isinstance(pose, Mapping) else row
    yaw = heading.get("yaw")
    orientation = heading.get("orientation")
    if yaw is not None and orientation is not None:
        raise _WrongError("has both yaw and orientation", "keep one of them")
    if orientation is not None:
        yaw = _yaw(orientation)
    position = pose.get("position", pose) if isinstance(pose, Mapping) else pose
    if isinstance(position, list):
        if yaw is None:
            x, y, yaw = _three(position, "x, y and yaw")
        else:
            x, y = _three([*position[:2], 0.0] if len(position) == 3 else position, "x, y and z")[:2]
        return {"x": x, "y": y, "yaw": yaw}
    if not isinstance(position, Mapping):
        raise _WrongError("has no pose that can be read", "position: {x: 5, y: 2}")
    found = {key: position[key] for key in ("x", "y") if key in position}
    return found if yaw is None else {**found, "yaw": yaw}


def _three(numbers: list[Any], what: str) -> tuple[Any, Any, Any]:
    if len(numbers) not in (2, 3):
        raise _WrongError(f"must have the numbers {what}", "write {x: 5, y: 2, yaw: 0}")
    if len(numbers) == 3 and numbers[2] != 0:
        hint = "write {x: ..., y: ..., yaw: ...}, or give orientation: [w, x, y, z] beside it"
        raise _WrongError(f"ends in {numbers[2]!r}, which may be z or yaw", hint)
    return numbers[0], numbers[1], 0.0


def _yaw(orientation: Any) -> Any:
    """rad, of a quaternion (a mapping, or Nav2's list w, x, y, z)."""
    if isinstance(orientation, list):
        orientation = dict(zip("wxyz", orientation, strict=True)) if len(orientation) == 4 else None
    if not isinstance(orientation, Mapping):
        raise _WrongError("has an orientation that is no quaternion", "orientation: {x: 0, y: 0, z: 0, w: 1}")
    for key in orientation:
        if key not in ("x", "y", "z", "w"):
            raise _WrongError(
                f"has an orientation with {key!r}", "orientation: {x: 0, y: 0, z: 0, w: 1}, or yaw in rad"
            )
    parts = [orientation.get(key, 0.0) for key in ("w", "x", "y", "z")]
    if any(isinstance(part, bool) or not isinstance(part, (int, float)) for part in parts):
        raise _WrongError("has an orientation that is no quaternion", "orientation: {x: 0, y: 0, z: 0, w: 1}")
    try:
        w, x, y, z = map(float, parts)
        length = math.sqrt(w * w + x * x + y * y + z * z)
    except OverflowError:
        length = math.inf
    if not 0.9 < length < 1.1:
        raise _WrongError(
            f"has an orientation of length {length:.3g}", "a quaternion has length 1; w is 1 straight ahead"
        )
    # REP 103: yaw about z, of the three fixed-axis angles.
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
