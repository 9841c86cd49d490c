"""Files of places in a form that is none of ours: what is told about them, and what to write."""

from __future__ import annotations

import re
from typing import Any

from intent_engine.errors import Problem
from intent_engine.hints import did_you_mean
from intent_engine.language.loading.yaml_source import YamlSource

__all__ = ["other_form"]

_FIELDS_OF_A_POSE = ({"x", "y"}, {"pose"}, {"position"})
_TUPLE = re.compile(r"\(\s*[-+.\de]+(?:\s*,\s*[-+.\de]+){1,2}\s*,?\s*\)")
_HEADER = re.compile(r"\W*name\W*[,;\t]|.*[,;\t]\W*x\W*[,;\t]\W*y\b", re.IGNORECASE)
"""The first line of a table of places."""


def other_form(source: YamlSource) -> Problem | None:
    """What to do about a file without ``locations`` that is plainly something else; None: nobody can say."""
    if isinstance(source.data, dict):
        return _of_mapping(source, source.data)
    if isinstance(source.data, list):
        return _of_list(source, source.data)
    if isinstance(source.data, str) and _HEADER.match(source.data):
        return Problem("is a table, as CSV files are", source.file, hint="give it a name that ends with .csv")
    return None


def _of_mapping(source: YamlSource, data: dict[Any, Any]) -> Problem | None:
    keys = list(data)
    if isinstance(places := data.get("locations"), list) and places and all(map(_has_name_and_pose, places)):
        hint = "write waypoints in the place of locations: below that a list may stand"
        return _at(source, "the places stand in a list", hint, keys.index("locations"))
    if "locations" in keys or not keys:
        return None
    if {"image", "resolution"} <= set(keys):
        hint = "write a file of places: 'locations: {kitchen: {x: 5.0, y: 2.0}}', poses in this map's frame"
        return Problem("is the picture of a floor, as map_server reads it, and names no places", source.file, hint=hint)
    if all(map(_like_a_pose, data.values())):
        hint = f"as in  locations: {{{keys[0]}: {{x: 5.0, y: 2.0, yaw: 0.0}}}}"
        return _at(source, "the places stand at the top, and belong below 'locations'", hint)
    if len(keys) == 1 and isinstance(data[keys[0]], dict) and did_you_mean(keys[0], ["locations"]) is None:
        message = f"unknown key {keys[0]!r}: places are listed below 'locations'"
        return _at(source, message, "write locations: in its place")
    return None


def _of_list(source: YamlSource, rows: list[Any]) -> Problem | None:
    if not rows or not all(map(_has_name_and_pose, rows)):
        return None
    json_file = source.file.lower().endswith(".json")
    hint = 'write {"waypoints": before it, and } behind' if json_file else "write  waypoints:  on a line above it"
    return _at(source, "the places stand in a list that has no name", hint)


def _at(source: YamlSource, message: str, hint: str, number: int = 0) -> Problem:
    """The problem at one of the file's first keys, or where it begins."""
    path = (list(source.data)[number],) if isinstance(source.data, dict) else ()
    place = source.place(path, key=True)
    return Problem(message, source.file, place.line, place.column, place.source, hint)


def _has_name_and_pose(row: Any) -> bool:
    return isinstance(row, dict) and "name" in row and any(fields <= row.keys() for fields in _FIELDS_OF_A_POSE)


def _like_a_pose(value: Any) -> bool:
    if isinstance(value, list):
        return len(value) in (2, 3) and all(isinstance(number, int | float) for number in value)
    if isinstance(value, str):
        return _TUPLE.fullmatch(value.strip()) is not None
    return isinstance(value, dict) and any(fields <= value.keys() for fields in _FIELDS_OF_A_POSE)
