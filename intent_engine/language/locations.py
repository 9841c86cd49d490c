"""Map files: names of places, with pose, frame, aliases and tags.

Three forms are read: our own YAML (``frame:``, ``locations:``), the waypoint files around Nav2 (``waypoints:``) and CSV
(``name,x,y,yaw,frame,aliases,tags``). All go through the same checks, and every problem of every file is told at once.
"""

from __future__ import annotations

import json
import re
import reprlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path
from typing import Any

from intent_engine.errors import ConfigError, Problem
from intent_engine.language.loading.file_kind import given_for
from intent_engine.language.loading.schema_problems import schema_problems
from intent_engine.language.loading.several_names import on_several_lines
from intent_engine.language.loading.text_file import MAX_BYTES, text_of
from intent_engine.language.loading.yaml_source import YamlPath, YamlSource, parse_yaml, read_yaml
from intent_engine.language.maps.map_draft import (
    DEFAULT_FRAME,
    FIELDS,
    Draft,
    Location,
    Row,
    Teller,
    checked,
)
from intent_engine.language.maps.map_rows import read_map
from intent_engine.language.maps.other_forms import other_form
from intent_engine.language.maps.places import Places
from intent_engine.language.names import NameIndex
from intent_engine.language.normalize import words_of
from intent_engine.language.slots.name_words import compared_as_written, name_words, raw_words
from intent_engine.values import WHOLE_TURN, check_path, check_text

__all__ = ["OTHER_MEANINGS", "Location", "LocationMap", "from_text", "load"]


OTHER_MEANINGS: Mapping[str, str] = {
    "stop": "stops the robot",
    "negation": "says no",
    "cancel": "takes an order back",
    "correction": "corrects",
    "pronoun": "points to what was named before",
}
"""Operators that are no name of a place: key -> what it does when it is said."""


@dataclass(frozen=True)
class LocationMap(Mapping[str, Location]):
    """Places by name."""

    places: Mapping[str, Location] = field(default_factory=dict, hash=False)
    frame: str = DEFAULT_FRAME
    """Of the places that name none."""
    files: tuple[str, ...] = ()

    @classmethod
    def from_mapping(cls, places: Mapping[str, Any], frame: str = DEFAULT_FRAME) -> LocationMap:
        """A map from a dictionary: name -> ``(x, y)``, ``(x, y, yaw)``, ``{x, y, yaw, aliases, tags}`` or a `Location`.

        Raises:
            ConfigError: with everything that is wrong: a pose that is not finite numbers, names that are said alike.
        """
        if not isinstance(places, Mapping):
            raise TypeError(f"places are a dictionary, as {{'kitchen': (5.0, 2.0, 0.0)}}, not {places!r:.80}")
        found, problems = checked([_dictionary(places, frame)])
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
        """The words of every name and alias as they are said, with the place's name."""
        for spoken, name in self._spoken():
            words = raw_words(spoken)
            if words[0] == "the" and len(words) > 1:
                words = words[1:]
            yield words, name

    def written(self) -> Iterator[str]:
        """Every name and alias as the file has it."""
        return (spoken for spoken, _ in self._spoken())

    @property
    def index(self) -> NameIndex:
        """For names that are only nearly said, in English."""
        return self.index_in("en")

    def index_in(self, language: str) -> NameIndex:
        """For names that are only nearly said, in a language."""
        if language not in self._indexes:
            self._indexes[language] = NameIndex(self._spoken(), language)
        return self._indexes[language]

    @cached_property
    def _indexes(self) -> dict[str, NameIndex]:
        return {}

    def _spoken(self) -> Iterator[tuple[str, str]]:
        if isinstance(self.places, Places):
            yield from self.places.spoken()
            return
        for name, place in self.places.items():
            yield name, name
            for alias in place.aliases:
                yield alias, name

    def problem(self, name: str, message: str, hint: str | None = None) -> Problem:
        """What is doubtful about a place, at its line where a file has it by its name."""
        if name in self._tellers:
            return self._tellers[name]("", message, hint)
        return Problem(message, self.files[0] if len(self.files) == 1 else None, hint=hint)

    @cached_property
    def _tellers(self) -> Mapping[str, Teller]:
        """Tells of each place where it stands. The files are read for it once more: it is asked for where something is
        doubtful."""
        found: dict[str, Teller] = {}
        for row in (row for file in self.files for row in _rows(Path(file))):
            found.setdefault(row.name, row.tell)
        return found

    @cached_property
    def warnings(self) -> tuple[Problem, ...]:
        """What is allowed, but hardly meant."""
        return tuple(problem for _, problem in self._doubts)

    @property
    def doubtful(self) -> frozenset[str]:
        """The places of which these warnings are."""
        return frozenset(name for name, _ in self._doubts)

    @cached_property
    def _doubts(self) -> tuple[tuple[str, Problem], ...]:
        return tuple(_doubts(self))


def load(paths: str | Path | Sequence[str | Path]) -> LocationMap:
    """Read map files into one map.

    Raises:
        ConfigError: with every problem of every file.
    """
    listed = list(paths) if isinstance(paths, Iterable) and not isinstance(paths, str | bytes) else [paths]
    for path in listed:
        check_path("a map", path)
    files = [Path(path) for path in listed]
    names = tuple(str(path) for path in files)
    quick = _quickly(files[0]) if len(files) == 1 else None
    if quick is not None:
        return LocationMap(*quick, names)
    drafts = [_carefully(path) for path in files]
    places, problems = checked(drafts)
    if problems:
        raise ConfigError(problems)
    return LocationMap(places, drafts[0].frame if drafts else DEFAULT_FRAME, names)


def from_text(text: str, name: str = "<text>") -> LocationMap:
    """A map from YAML text, for tests and embedding.

    Raises:
        ConfigError: with everything that is wrong.
    """
    check_text("a map", text)
    draft = _draft(parse_yaml(text, YamlSource(name)))
    places, problems = checked([draft])
    if problems:
        raise ConfigError(problems)
    return LocationMap(places, draft.frame)


# -- reading --------------------------------------------------------------------------------------------------


def _quickly(path: Path) -> tuple[Places, str] | None:
    """The places and the frame of a plainly written YAML map without a fault; None for any other file."""
    try:
        # What is no file but a pipe can be read only once, and that carefully.
        if path.suffix.lower() == ".csv" or not path.is_file() or path.stat().st_size > MAX_BYTES:
            return None
        found = read_map(path.read_text("utf-8"))
    except (OSError, UnicodeDecodeError):
        return None
    if found is None:
        return None
    frame = found.frame or DEFAULT_FRAME
    particulars = {
        name: (fields.get("frame", frame), tuple(fields.get("aliases", ())), tuple(fields.get("tags", ())))
        for name, fields in found.particulars.items()
    }
    places = Places(found.names, found.poses, particulars, frame)
    turned = max(map(abs, found.poses[2::3]), default=0.0)
    return (places, frame) if turned <= WHOLE_TURN and _said_differently(places) else None


def _said_differently(places: Places) -> bool:
    """Whether every name can be said, and none is said as one of another place is."""
    said: dict[str, str] = {}
    for spoken, name in places.spoken():
        # A name that is compared as it is written stands for its own words, and costs no memory.
        words = spoken if compared_as_written(spoken) else " ".join(name_words(spoken))
        if not words or said.setdefault(words, name) != name:
            return False
    return True


def _carefully(path: Path) -> Draft:
    if path.suffix.lower() != ".csv":
        return _draft(read_yaml(path))
    from intent_engine.language.maps.map_table import read_table

    try:
        text = text_of(path)
    except (OSError, ValueError):
        return Draft(problems=read_yaml(path).problems or [Problem("cannot be read as UTF-8 text", str(path))])
    return read_table(path, text)


def _draft(source: YamlSource) -> Draft:
    if isinstance(source.data, dict) and "waypoints" in source.data and "locations" not in source.data:
        from intent_engine.language.maps.waypoints import read_waypoints

        return read_waypoints(source)
    if source.data is None:
        empty = Problem("is empty", source.file, hint="the shortest map: 'locations: {kitchen: {x: 5.0, y: 2.0}}'")
        return Draft(problems=[empty if problem.message == "is empty" else problem for problem in source.problems])
    if (kind := given_for("map", source.data, source.file)) is not None:
        return Draft(problems=[kind])
    if (other := other_form(source)) is not None:
        return Draft(problems=[*source.problems, other])
    source.problems.extend(schema_problems(source, _schema()))
    if not isinstance(source.data, dict) or not isinstance(source.data.get("locations"), dict):
        return Draft(problems=source.problems)
    frame = source.data.get("frame", DEFAULT_FRAME)
    draft = Draft(frame=frame if isinstance(frame, str) else DEFAULT_FRAME, problems=source.problems)
    wrong = {problem.line for problem in source.problems}
    rows = []
    for name, pose in source.data["locations"].items():
        path: YamlPath = ("locations", name)
        raw = source.raw.get((*path, "\0key"))
        if raw is not None:
            message = f"YAML reads the name {raw or 'of nothing'} as a value, not a word"
            source.problem(path, message, f'quote it: "{raw}"' if raw else "give it a name", key=True)
        elif isinstance(pose, dict) and on_several_lines(source, path):
            continue
        elif isinstance(pose, dict) and not wrong.intersection(_lines(source, path, pose)):
            rows.append(Row(name, pose, _teller(source, path)))
    draft.rows = rows
    return draft


def _rows(path: Path) -> Iterable[Row]:
    """The places of a file that was read without a fault."""
    source = read_yaml(path) if path.suffix.lower() != ".csv" else None
    places = source.data.get("locations") if source is not None and isinstance(source.data, dict) else None
    if source is None or not isinstance(places, dict):
        return _carefully(path).rows
    return [Row(name, pose, _teller(source, ("locations", name))) for name, pose in places.items()]


def _lines(source: YamlSource, path: YamlPath, pose: dict[str, Any]) -> Iterator[int]:
    """The lines of one place, counted from 1."""
    yield source.place(path, key=True).line
    for key in pose:
        yield source.place((*path, key)).line


def _dictionary(given: Mapping[str, Any], frame: str) -> Draft:
    """A dictionary of places as it was given."""
    draft = Draft(frame=frame)
    rows = []
    for name, pose in given.items():
        values: Any = None
        if isinstance(pose, Location):
            values = {key: getattr(pose, key) for key in FIELDS}
        elif isinstance(pose, Mapping):
            values = pose
        elif isinstance(pose, Sequence) and not isinstance(pose, str) and len(pose) in (2, 3):
            values = dict(zip(("x", "y", "yaw"), pose, strict=False))
        elif all(hasattr(pose, key) for key in ("x", "y", "yaw")):  # a Pose of a robot
            values = {key: getattr(pose, key) for key in FIELDS if hasattr(pose, key)}
        if not isinstance(name, str):
            draft.problems.append(Problem(f"the name {name!r} is not text", hint=f'quote it: "{name}"'))
        elif values is None:
            message = f"place {name!r} must be a pose, not {reprlib.repr(pose)}"
            draft.problems.append(Problem(message, hint="give (x, y) or (x, y, yaw), in m and rad"))
        else:
            rows.append(Row(name, values, lambda _, message, hint: Problem(message, hint=hint)))
    draft.rows = rows
    return draft


def _teller(source: YamlSource, path: YamlPath) -> Teller:
    def tell(key: str, message: str, hint: str | None) -> Problem:
        known = (*path, key) in source.marks
        place = source.place((*path, key) if key and known else path, key=not key)
        return Problem(message, source.file, place.line, place.column, place.source, hint)

    return tell


@cache
def _schema() -> dict[str, Any]:
    text = (Path(__file__).parent / "locations.schema.json").read_text("utf-8")
    loaded: dict[str, Any] = json.loads(text)
    return loaded


# -- doubts ---------------------------------------------------------------------------------------------------


def _doubts(places: LocationMap) -> Iterator[tuple[str, Problem]]:
    """Names that will hardly ever be understood as a place, each with the place."""
    from intent_engine.language.loading.language_words import default_operators

    operators = default_operators("en")
    meaning = {words_of(text): why for kind, why in OTHER_MEANINGS.items() for text in operators.get(kind, ())}
    for name, place in places.items():
        for spoken in (name, *place.aliases):
            why = meaning.get(raw_words(spoken))
            if why is not None:
                hint = "give the place another name; this one will be taken for the order"
                yield name, places.problem(name, f"{spoken!r}, a name of {name!r}, {why} when it is said", hint)
            elif all(word.isdigit() for word in name_words(spoken)):
                hint = 'a number alone is easily taken for a distance; say what it is, as "bay 3"'
                yield name, places.problem(name, f"{spoken!r}, a name of {name!r}, is only a number", hint)
            elif re.search(r"[^\W\d_]/[^\W\d_]", spoken) and (spoken != name or not place.aliases):
                message = f"{spoken!r}, a name of {name!r}, would have to be said as {' '.join(raw_words(spoken))!r}"
                first, _, second = spoken.partition("/")
                yield name, places.problem(name, message, f"write both as aliases: [{first}, {second}]")
