"""What a map file says, before it is believed; and the checks that every form of map goes through."""

from __future__ import annotations

import math
import reprlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from numbers import Real
from typing import Any

from intent_engine.errors import Problem
from intent_engine.language.loading.other_words import FIELDS_OF_A_PLACE, meant
from intent_engine.language.loading.several_names import as_list, looks_like_several
from intent_engine.language.slots.name_words import name_words
from intent_engine.values import WHOLE_TURN

__all__ = ["DEFAULT_FRAME", "Draft", "Location", "Row", "checked"]

DEFAULT_FRAME = "map"
"""The fixed frame of a map (REP 105)."""
FIELDS = ("x", "y", "yaw", "frame", "aliases", "tags")

Teller = Callable[[str, str, str | None], Problem]
"""(field or "" for the name, message, hint) -> a problem that shows the place in the file."""


@dataclass(frozen=True, slots=True)
class Location:
    """A named pose."""

    name: str
    """What actions carry; one of the ways to say it."""
    x: float
    """m, in ``frame``"""
    y: float
    """m, in ``frame``"""
    yaw: float = 0.0
    """rad, in ``frame``, positive to the left of its x axis"""
    frame: str = DEFAULT_FRAME
    aliases: tuple[str, ...] = ()
    """Other ways to say it."""
    tags: tuple[str, ...] = ()
    """Kinds that a grammar's slot may ask for."""


@dataclass(frozen=True, slots=True)
class Row:
    """One place as it was written."""

    name: str
    values: Mapping[str, Any]
    tell: Teller


@dataclass(slots=True)
class Draft:
    """One map as it was written."""

    rows: Iterable[Row] = ()
    frame: str = DEFAULT_FRAME
    problems: list[Problem] = field(default_factory=list)
    """What is wrong with the file as a file."""


def checked(drafts: Sequence[Draft]) -> tuple[dict[str, Location], list[Problem]]:
    """The places of all drafts, and everything that is wrong with them."""
    places: dict[str, Location] = {}
    said: dict[tuple[str, ...], str] = {}
    problems: list[Problem] = []
    for draft in drafts:
        problems.extend(draft.problems)
        for row in draft.rows:
            if row.name in places:
                problems.append(row.tell("", f"place {row.name!r} stands twice", "rename one, or merge them"))
                continue
            place = _place(row, draft.frame, problems)
            if place is not None:
                places[row.name] = place
                problems.extend(clashes(place, said, row.tell))
    order = {file: place for place, file in enumerate(dict.fromkeys(problem.file for problem in problems))}
    problems.sort(key=lambda problem: (order[problem.file], problem.line or 0, problem.column or 0))
    return places, problems


def clashes(place: Location, said: dict[tuple[str, ...], str], tell: Teller) -> Iterator[Problem]:
    """Names that cannot be said, or are said like those of another place; ``said`` learns the others."""
    for spoken in (place.name, *place.aliases):
        words = name_words(spoken)
        part = "" if spoken is place.name else "aliases"
        if not words:
            yield tell(part, f"the name {spoken!r} has no word that can be said", "give it a name in words")
            continue
        other = said.setdefault(words, place.name)
        if other != place.name:
            message = f"{spoken!r} is said like a name of {other!r}; nobody could tell them apart"
            yield tell(part, message, "rename one or remove the alias")


def _place(row: Row, frame: str, problems: list[Problem]) -> Location | None:
    values = row.values
    before = len(problems)
    for key in values:
        if key not in FIELDS:
            hint = meant(str(key), FIELDS_OF_A_PLACE, FIELDS) or f"known here: {', '.join(FIELDS)}"
            problems.append(row.tell(str(key), f"place {row.name!r} has an unknown key {str(key)!r}", hint))
    pose = []
    for key in ("x", "y", "yaw"):
        value = values.get(key, 0.0 if key == "yaw" else None)
        if value is None and key not in values:
            problems.append(row.tell("", f"place {row.name!r} needs {key!r}", "poses are x, y in m and yaw in rad"))
            continue
        number = _finite(value)
        if number is None:
            message = f"{key} of {row.name!r} must be a finite number, not {reprlib.repr(value)}"
            problems.append(row.tell(key, message, "poses are finite numbers, x, y in m and yaw in rad"))
            continue
        if key == "yaw" and abs(number) > WHOLE_TURN:
            message = f"yaw of {row.name!r} is more than a whole turn: {number:g} rad"
            hint = f"yaw is in rad; {number:g} degrees are {math.radians(number):.4f}"
            problems.append(row.tell(key, message, hint))
            continue
        pose.append(number)
    its_frame = values.get("frame", frame)
    if not isinstance(its_frame, str) or not its_frame.strip():
        problems.append(row.tell("frame", f"frame of {row.name!r} must be a name, as {DEFAULT_FRAME}", None))
    aliases = _names(row, "aliases", problems)
    tags = _names(row, "tags", problems)
    if len(problems) > before:
        return None
    x, y, yaw = pose
    return Location(row.name, x, y, yaw, its_frame, aliases, tags)


def _finite(value: object) -> float | None:
    if isinstance(value, bool) or not isinstance(value, Real):
        return None
    try:
        number = float(value)
    except OverflowError:
        return None
    return number if math.isfinite(number) else None


def _names(row: Row, key: str, problems: list[Problem]) -> tuple[str, ...]:
    items = row.values.get(key, ())
    if isinstance(items, str) and not looks_like_several(items):
        return (items,)
    if isinstance(items, str) or not isinstance(items, (list, tuple)):
        hint = f"{key}: {as_list(items) if isinstance(items, str) and items.strip() else '[one, another]'}"
        problems.append(row.tell(key, f"{key} of {row.name!r} must be a list of names", hint))
        return ()
    for item in items:
        if not isinstance(item, str):
            message = f"{key} of {row.name!r}: YAML reads {item!r} as a value, not a word"
            problems.append(row.tell(key, message, "quote it"))
            return ()
        if not item.strip():
            problems.append(row.tell(key, f"{key} of {row.name!r} holds an empty name", "remove it"))
            return ()
    return tuple(items)
