"""Map files written plainly, read without a YAML parser.

A YAML parser takes 40 to 90 us a place, so a map of 10,000 places would take longer than all the rest of a start. This
reader knows the two shapes that people and programs write::

    kitchen: {x: 5.0, y: 2.0, yaw: 0.0, aliases: [cooking area]}

    kitchen:
      x: 5.0
      y: 2.0

and answers None for anything else, wrong or only unusual: then the YAML parser reads the file, with the place of every
value. Where it does answer, the YAML parser reads the same (a property in the tests).

Places whose fields stand in the usual order are found in one search over the text; from the first that is written in
another way, all are read line by line.
"""

from __future__ import annotations

import math
import re
from array import array
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

__all__ = ["PlainMap", "read_map"]

_NUMBER = r"[-+]?(?:(?:0|[1-9][0-9]*)(?:\.[0-9]*)?|\.[0-9]+)"
_WORD = r"[^\W\d_][\w'/-]*(?: [\w'/-]+)*"
"""Text that YAML reads as text without quotes; its booleans are looked for besides."""
_LIST = rf"\[(?:{_WORD}(?:, ?{_WORD})*)?\]"
_NAME = rf"""(?:({_WORD})|"([^"\\\n]+)"|'([^'\n]+)')"""
_ROW = re.compile(rf"{_NAME}:(?: \{{(.*)\}})?")
_FIELDS = re.compile(rf"(x|y|yaw|frame|aliases|tags): ?({_NUMBER}(?![\w.'/-])|{_LIST}|{_WORD})(?:, ?|$)")
_BLOCK_FIELD = re.compile(rf"(x|y|yaw|frame|aliases|tags):(?: ({_NUMBER}|{_LIST}|{_WORD}))?")
_ITEM = re.compile(rf"- ({_WORD})")
_BLANK = r"(?: *(?:#.*)?\n)*"
_COMMENT = r" *(?: #.*)?\n"
_HEAD = re.compile(rf"{_BLANK}(?:frame: ({_WORD}){_COMMENT}{_BLANK})?locations:{_COMMENT}{_BLANK}")
_WORDS = rf"\[{_WORD}(?:, ?{_WORD})*\]"
_END = r"(?:\n|\Z)(?=  \S|\Z)|((?s:.+))"
_EVEN = (
    re.compile(
        rf"  ({_WORD}): \{{x: ({_NUMBER}), y: ({_NUMBER})(?:, yaw: ({_NUMBER}))?"
        rf"(?:, aliases: ({_WORDS}))?(?:, tags: ({_WORDS}))?\}}{_END}"
    ),
    re.compile(
        rf"  ({_WORD}):\n    x: ({_NUMBER})\n    y: ({_NUMBER})(?:\n    yaw: ({_NUMBER}))?"
        rf"(?:\n    aliases: ({_WORDS}))?(?:\n    tags: ({_WORDS}))?{_END}"
    ),
)
"""A place written as most are, on one line or on several; or all that is left."""
_VALUES = frozenset(("yes", "no", "on", "off", "true", "false", "null", "y", "n"))
"""Words that YAML 1.1 reads as something else."""

Fields = dict[str, Any]


@dataclass(slots=True)
class PlainMap:
    """What a plainly written map holds."""

    frame: str | None = None
    """Of the places that name none."""
    names: list[str] = field(default_factory=list)
    poses: array[float] = field(default_factory=lambda: array("d"))
    """x, y, yaw of each name, one after the other; m and rad."""
    particulars: dict[str, Fields] = field(default_factory=dict)
    """``frame``, ``aliases`` and ``tags`` of the names that have any of them."""

    def add(self, name: str, fields: Fields) -> None:
        """A place with all its fields."""
        self.names.append(name)
        self.poses.extend((fields.pop("x"), fields.pop("y"), fields.pop("yaw", 0.0)))
        if fields:
            self.particulars[name] = fields


def read_map(text: str) -> PlainMap | None:
    """The places of a plainly written map, each name once, all numbers finite; None for any other text."""
    head = _HEAD.match(text)
    if head is None or (head[1] and not _is_text(head[1])):
        return None
    found = PlainMap(head[1])
    at = _read_even(text, head.end(), found)
    if at < len(text) and not _read_lines(text[at:].split("\n"), found):
        return None
    once = len(set(found.names)) == len(found.names) > 0
    return found if once and math.isfinite(sum(found.poses)) else None


def _read_even(text: str, at: int, found: PlainMap) -> int:
    """Read places that are all written as most are, up to the first that is not; the place where that stands."""
    shape = next((shape for shape in _EVEN if (first := shape.match(text, at)) and first[1]), None)
    if shape is None:
        return at
    rows = shape.findall(text, at)
    rest = rows.pop()[-1] if rows[-1][-1] else ""
    names, xs, ys, yaws, aliases, tags, _ = zip(*rows, strict=True)
    particulars: dict[str, Fields] = {}
    for key, column in (("aliases", aliases), ("tags", tags)):
        for name, written in zip(names, column, strict=True):
            if written and not _put(particulars.setdefault(name, {}), key, written):
                return at
    if not _VALUES.isdisjoint(map(str.lower, names)):
        return at
    found.names.extend(names)
    found.particulars = particulars
    found.poses = array("d", bytes(3 * 8 * len(names)))
    for place, numbers in enumerate((xs, ys, yaws)):
        found.poses[place::3] = array("d", [float(number) if number else 0.0 for number in numbers])
    return len(text) - len(rest)


def _read_lines(lines: Iterable[str], found: PlainMap) -> bool:
    """Read places line by line; whether that is possible."""
    rows: list[tuple[str, Fields]] = []
    indent = 2 if found.names else 0
    fields: Fields | None = None
    """Of the place whose fields stand on lines of their own."""
    inner = 0
    items: list[str] | None = None
    for line in lines:
        if "#" in line:
            line = line.split(" #")[0] if not line.lstrip().startswith("#") else ""
        line = line.rstrip(" ")
        if not line:
            continue
        content = line.lstrip(" ")
        depth = len(line) - len(content)
        if not indent:
            indent = depth
        if depth == 0:
            return False
        if depth == indent and not content.startswith("-"):
            match = _ROW.fullmatch(content)
            if match is None:
                return False
            name = match[1] or match[2] or match[3]
            if (match[1] and not _is_text(name)) or name != name.strip():
                return False
            fields, items, inner = {}, None, 0
            rows.append((name, fields))
            if match[4] is not None:
                if not _flow(match[4], fields):
                    return False
                fields = None
            continue
        if fields is None:
            return False
        inner = inner or depth
        if content.startswith("- "):
            match = _ITEM.fullmatch(content)
            if match is None or items is None or depth < inner or not _is_text(match[1]):
                return False
            items.append(match[1])
            continue
        match = _BLOCK_FIELD.fullmatch(content)
        if match is None or depth != inner or depth <= indent or match[1] in fields:
            return False
        if match[2] is None:
            if match[1] not in ("aliases", "tags"):
                return False
            items = fields[match[1]] = []
        else:
            items = None
            if not _put(fields, match[1], match[2]):
                return False
    if not all("x" in fields and "y" in fields and [] not in fields.values() for _, fields in rows):
        return False
    for name, fields in rows:
        found.add(name, fields)
    return True


def _flow(body: str, fields: Fields) -> bool:
    at = 0
    while at < len(body):
        match = _FIELDS.match(body, at)
        if match is None or match[1] in fields or not _put(fields, match[1], match[2]):
            return False
        at = match.end()
    return True


def _put(fields: Fields, key: str, value: str) -> bool:
    if value[0] == "[":
        words = [word.strip() for word in value[1:-1].split(",")] if len(value) > 2 else []
        if key not in ("aliases", "tags") or not all(map(_is_text, words)) or not words:
            return False
        fields[key] = words
    elif value[0] in "-+.0123456789":
        if key not in ("x", "y", "yaw"):
            return False
        fields[key] = float(value)
    else:
        if key != "frame" or not _is_text(value):
            return False
        fields[key] = value
    return True


def _is_text(word: str) -> bool:
    return word.lower() not in _VALUES
