"""Map files: names of places, with pose, frame, aliases and tags.

Three forms are read: our own YAML (``frame:``, ``locations:``), a Nav2 waypoint YAML (``waypoints:``) and a plain CSV
(``name,x,y,yaw,frame,aliases,tags``).
"""

from __future__ import annotations

import csv
import io
import json
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property
from importlib import resources
from pathlib import Path
from typing import Any

from intent_engine.errors import ConfigError, Problem
from intent_engine.language.name_words import name_words
from intent_engine.language.names import NameIndex
from intent_engine.language.normalize import plain_words, tokenize
from intent_engine.language.schema_problems import schema_problems
from intent_engine.language.yaml_source import YamlPath, YamlSource, parse_yaml, read_yaml

__all__ = ["Location", "LocationMap", "load"]

DEFAULT_FRAME = "map"


@dataclass(frozen=True, slots=True)
class Location:
    """A named pose."""

    name: str
    x: float
    """m, in ``frame``"""
    y: float
    """m, in ``frame``"""
    yaw: float = 0.0
    """rad, in ``frame``"""
    frame: str = DEFAULT_FRAME
    aliases: tuple[str, ...] = ()
    tags: tuple[str, ...] = ()


@dataclass(frozen=True)
class LocationMap(Mapping[str, Location]):
    """Places by name."""

    places: Mapping[str, Location] = field(default_factory=dict)
    frame: str = DEFAULT_FRAME
    files: tuple[str, ...] = ()

    @classmethod
    def from_mapping(cls, places: Mapping[str, Any], frame: str = DEFAULT_FRAME) -> LocationMap:
        """A map from a dictionary: name -> ``(x, y)``, ``(x, y, yaw)`` or ``{x, y, yaw, aliases, tags}``.

        Raises:
            ConfigError: a pose is not finite numbers, or two names sound the same.
        """
        found: dict[str, Location] = {}
        problems: list[Problem] = []
        for name, pose in places.items():
            try:
                if isinstance(pose, Location):
                    found[name] = pose
                elif isinstance(pose, Mapping):
                    found[name] = _location(name, pose, frame)
                else:
                    x, y, *rest = pose
                    found[name] = _location(name, {"x": x, "y": y, "yaw": rest[0] if rest else 0.0}, frame)
            except (TypeError, ValueError, KeyError) as error:
                problems.append(Problem(f"place {name!r}: {error}", hint="give (x, y, yaw) in m and rad"))
        for _, message in _twice(found):
            problems.append(Problem(message))
        if problems:
            raise ConfigError(problems)
        return cls(found, frame)

    def __getitem__(self, name: str) -> Location:
        return self.places[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.places)

    def __len__(self) -> int:
        return len(self.places)

    def names(self) -> Iterator[tuple[tuple[str, ...], str]]:
        """Normalised words of every name and alias, with the place's name."""
        for name, place in self.places.items():
            for spoken in (name, *place.aliases):
                words = _spoken_words(spoken)
                if words:
                    yield words, name

    @cached_property
    def index(self) -> NameIndex:
        """For names that are only nearly said."""
        return NameIndex([(spoken, name) for name, place in self.places.items() for spoken in (name, *place.aliases)])


def _spoken_words(text: str) -> tuple[str, ...]:
    words = plain_words(text)
    if words is None:
        words = [token.word for token in tokenize(text.replace("_", " "))]
    if len(words) > 1 and words[0] in ("the", "a", "an"):
        words = words[1:]
    return tuple(words)


def _location(name: str, pose: Mapping[str, Any], frame: str) -> Location:
    values = []
    for key in ("x", "y", "yaw"):
        value = pose.get(key, 0.0) if key == "yaw" else pose[key]
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
            raise ValueError(f"{key} must be a finite number, not {value!r}")
        values.append(float(value))
    aliases = pose.get("aliases", ())
    x, y, yaw = values
    return Location(name, x, y, yaw, str(pose.get("frame", frame)), tuple(aliases), tuple(pose.get("tags", ())))


def _twice(places: Mapping[str, Location]) -> Iterator[tuple[str, str]]:
    """Names or aliases that are said with the same words but are different places."""
    said: dict[tuple[str, ...], str] = {}
    for name, place in places.items():
        for spoken in (name, *place.aliases):
            words = _spoken_words(spoken)
            if not words:
                yield name, f"{spoken!r} has no word that can be said"
                continue
            if any(word.isdigit() for word in words) or len(words) > 1:
                words = name_words(words)
            other = said.setdefault(words, name)
            if other != name:
                yield name, f"{spoken!r} is said like a name of {other!r}; nobody could tell them apart"


def load(paths: str | Path | Sequence[str | Path]) -> LocationMap:
    """Read map files into one map.

    Raises:
        ConfigError: with every problem of every file.
    """
    names = [paths] if isinstance(paths, (str, Path)) else list(paths)
    places: dict[str, Location] = {}
    problems: list[Problem] = []
    frame: str | None = None
    for name in names:
        found, its_frame, wrong = _load_file(Path(name))
        problems.extend(wrong)
        frame = frame or its_frame
        for place in found.values():
            if place.name in places:
                problems.append(Problem(f"place {place.name!r} is also in another map file", str(name)))
            places[place.name] = place
    if problems:
        raise ConfigError(problems)
    return LocationMap(places, frame or DEFAULT_FRAME, tuple(str(name) for name in names))


def _load_file(path: Path) -> tuple[dict[str, Location], str, list[Problem]]:
    if path.suffix.lower() == ".csv":
        return _load_csv(path)
    quick = _quickly(path)
    if quick is not None:
        places, frame = quick
        if not any(True for _ in _twice(places)):
            return places, frame, []
    source = read_yaml(path)
    if source.data is None:
        return {}, DEFAULT_FRAME, source.problems
    if isinstance(source.data, dict) and "waypoints" in source.data:
        return _waypoints(source)
    source.problems.extend(schema_problems(source, _schema()))
    places, frame = {}, DEFAULT_FRAME
    if not source.problems:
        frame = source.data.get("frame", DEFAULT_FRAME)
        for name, pose in source.data["locations"].items():
            _add(source, ("locations", name), name, pose, frame, places)
        for name, message in _twice(places):
            source.problem(("locations", name), message, "rename one or remove the alias", key=True)
    return places, frame, source.problems


def _add(
    source: YamlSource, path: YamlPath, name: str, pose: Mapping[str, Any], frame: str, places: dict[str, Location]
) -> None:
    raw = source.raw.get((*path, "\0key"))
    if raw is not None and raw.lower() in ("yes", "no", "on", "off", "true", "false", "null"):
        source.problem(path, f"YAML reads the name {raw} as a value, not a word", f'quote it: "{raw}"', key=True)
    try:
        places[name] = _location(name, pose, frame)
    except (ValueError, KeyError, TypeError) as error:
        source.problem(path, f"place {name!r}: {error}", "poses are finite numbers in m and rad")


@cache
def _schema() -> dict[str, Any]:
    text = resources.files("intent_engine.language").joinpath("locations.schema.json").read_text("utf-8")
    loaded: dict[str, Any] = json.loads(text)
    return loaded


_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_ROW = re.compile(
    rf"  ([A-Za-z][A-Za-z0-9 _-]*): \{{x: ({_NUMBER}), y: ({_NUMBER})(?:, yaw: ({_NUMBER}))?"
    r"(?:, aliases: \[([A-Za-z0-9 _,-]*)\])?(?:, tags: \[([A-Za-z0-9 _,-]*)\])?\}"
)
_WORDS_OF_YAML = frozenset(("yes", "no", "on", "off", "true", "false", "null", "y", "n"))


def _quickly(path: Path) -> tuple[dict[str, Location], str] | None:
    """A large map whose every place is one plain line, read without a YAML parser; None for any other file.

    A YAML parser takes 40 us a place, so 10,000 places would take longer than all the rest of a start.
    """
    try:
        text = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError):
        return None
    frame = DEFAULT_FRAME
    places: dict[str, Location] = {}
    below = False
    for line in text.splitlines():
        if below:
            match = _ROW.fullmatch(line)
            if match is None:
                if not line.strip() or line.lstrip().startswith("#"):
                    continue
                return None
            name, x, y, yaw, aliases, tags = match.groups()
            spoken = [name, *_items(aliases)]
            if name in places or not _WORDS_OF_YAML.isdisjoint(word.lower() for word in spoken):
                return None
            if any(not word[:1].isalpha() for word in spoken):
                return None
            places[name] = Location(
                name, float(x), float(y), float(yaw or 0.0), frame, tuple(spoken[1:]), tuple(_items(tags))
            )
        elif line == "locations:":
            below = True
        elif line.startswith("frame: ") and re.fullmatch(r"frame: [A-Za-z][A-Za-z0-9_/]*", line):
            frame = line[7:]
        elif line.strip() and not line.startswith("#"):
            return None
    return (places, frame) if places else None


def _items(text: str | None) -> list[str]:
    return [item.strip() for item in text.split(",")] if text else []


def _waypoints(source: YamlSource) -> tuple[dict[str, Location], str, list[Problem]]:
    """Nav2 waypoint files: a list or mapping of poses, with yaw or a quaternion."""
    rows = source.data["waypoints"]
    frame = str(source.data.get("frame_id", source.data.get("frame", DEFAULT_FRAME)))
    places: dict[str, Location] = {}
    items: list[tuple[Any, Any]]
    if isinstance(rows, dict):
        items = list(rows.items())
    elif isinstance(rows, list):
        items = [
            (row.get("name", f"waypoint {i + 1}") if isinstance(row, dict) else i, row) for i, row in enumerate(rows)
        ]
    else:
        source.problem(("waypoints",), "waypoints must be a list or a mapping of poses")
        return {}, frame, source.problems
    for place, (name, row) in enumerate(items):
        path: YamlPath = ("waypoints", name if isinstance(rows, dict) else place)
        try:
            x, y, yaw, its_frame = _pose(row, frame)
            _add(source, path, str(name), {"x": x, "y": y, "yaw": yaw, "frame": its_frame}, frame, places)
        except (KeyError, TypeError, ValueError, IndexError):
            source.problem(
                path, f"waypoint {name!r} has no pose that can be read", "position: {x, y}, orientation: {z, w}"
            )
    for _, message in _twice(places):
        source.problem(("waypoints",), message)
    return places, frame, source.problems


def _pose(row: Any, frame: str) -> tuple[float, float, float, str]:
    if isinstance(row, (list, tuple)):
        return float(row[0]), float(row[1]), float(row[2]) if len(row) > 2 else 0.0, frame
    frame = str(row.get("frame_id", row.get("header", {}).get("frame_id", frame)))
    pose = row.get("pose", row)
    if isinstance(pose, (list, tuple)):
        return float(pose[0]), float(pose[1]), float(pose[2]) if len(pose) > 2 else 0.0, frame
    pose = pose.get("pose", pose)
    position = pose.get("position", pose)
    if isinstance(position, (list, tuple)):
        position = {"x": position[0], "y": position[1]}
    orientation = pose.get("orientation")
    yaw = float(pose.get("yaw", row.get("yaw", 0.0)))
    if isinstance(orientation, (list, tuple)):
        orientation = dict(zip(("x", "y", "z", "w"), orientation, strict=False))
    if isinstance(orientation, dict):
        ox, oy = float(orientation.get("x", 0.0)), float(orientation.get("y", 0.0))
        oz, ow = float(orientation.get("z", 0.0)), float(orientation.get("w", 1.0))
        yaw = math.atan2(2 * (ow * oz + ox * oy), 1 - 2 * (oy * oy + oz * oz))
    elif orientation is not None:
        yaw = float(orientation)
    return float(position["x"]), float(position["y"]), yaw, frame


def _load_csv(path: Path) -> tuple[dict[str, Location], str, list[Problem]]:
    source = YamlSource(str(path))
    try:
        text = path.read_text("utf-8-sig")
    except (OSError, UnicodeDecodeError):
        return {}, DEFAULT_FRAME, read_yaml(path).problems or [Problem("cannot be read as UTF-8 text", str(path))]
    source.lines = text.splitlines()
    places: dict[str, Location] = {}
    problems: list[Problem] = []
    reader = csv.DictReader(io.StringIO(text))
    missing = {"name", "x", "y"} - set(reader.fieldnames or ())
    if missing:
        hint = "the first line must be: name,x,y,yaw,frame,aliases,tags (yaw and what follows may be left out)"
        return (
            {},
            DEFAULT_FRAME,
            [Problem(f"has no column {' or '.join(sorted(missing))}", str(path), 1, 1, None, hint)],
        )
    for row in reader:
        line = reader.line_num
        shown = source.lines[line - 1] if line <= len(source.lines) else None
        try:
            name = (row["name"] or "").strip()
            pose = {
                "x": float(row["x"]),
                "y": float(row["y"]),
                "yaw": float(row.get("yaw") or 0.0),
                "frame": (row.get("frame") or DEFAULT_FRAME).strip(),
                "aliases": [item.strip() for item in (row.get("aliases") or "").split(";") if item.strip()],
                "tags": [item.strip() for item in (row.get("tags") or "").split(";") if item.strip()],
            }
            if not name:
                raise ValueError("the name is empty")
            if name in places:
                raise ValueError(f"place {name!r} stands twice")
            places[name] = _location(name, pose, DEFAULT_FRAME)
        except (ValueError, TypeError) as error:
            problems.append(Problem(str(error), str(path), line, 1, shown, "numbers are in m and rad"))
    problems.extend(Problem(message, str(path)) for _, message in _twice(places))
    return places, DEFAULT_FRAME, problems


def from_text(text: str, name: str = "<text>") -> LocationMap:
    """A map from YAML text, for tests and embedding."""
    source = parse_yaml(text, YamlSource(name))
    problems = source.problems or schema_problems(source, _schema())
    if problems:
        raise ConfigError(problems)
    return LocationMap.from_mapping(source.data["locations"], source.data.get("frame", DEFAULT_FRAME))
