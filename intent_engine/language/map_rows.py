"""Map files written plainly, read line by line.

A YAML parser takes 40 to 90 us a place, so a map of 10,000 places would take longer than all the rest of a start. This
reader knows the two shapes that people and programs write::

    kitchen: {x: 5.0, y: 2.0, yaw: 0.0, aliases: [cooking area]}

    kitchen:
      x: 5.0
      y: 2.0

and answers None for anything else, wrong or only unusual: then the YAML parser reads the file, with the place of every
value. Where it does answer, the YAML parser reads the same (a property in the tests).
"""

from __future__ import annotations

import re
from typing import Any

__all__ = ["read_rows"]

_NUMBER = r"[-+]?(?:(?:0|[1-9][0-9]*)(?:\.[0-9]*)?|\.[0-9]+)"
_WORD = r"[^\W\d_](?:[\w'/-]| (?=[\w'/-]))*"
"""Text that YAML reads as text without quotes; its booleans are looked for besides."""
_LIST = rf"\[(?:{_WORD}(?:, ?{_WORD})*)?\]"
_NAME = rf"""(?:({_WORD})|"([^"\\\n]+)"|'([^'\n]+)')"""
_ROW = re.compile(rf"{_NAME}:(?: \{{(.*)\}})?")
_FIELDS = re.compile(rf"(x|y|yaw|frame|aliases|tags): ?({_NUMBER}(?![\w.'/-])|{_LIST}|{_WORD})(?:, ?|$)")
_BLOCK_FIELD = re.compile(rf"(x|y|yaw|frame|aliases|tags):(?: ({_NUMBER}|{_LIST}|{_WORD}))?")
_ITEM = re.compile(rf"- ({_WORD})")
_FRAME = re.compile(rf"frame: ({_WORD})")
_VALUES = frozenset(("yes", "no", "on", "off", "true", "false", "null", "y", "n"))
"""Words that YAML 1.1 reads as something else."""

Fields = dict[str, Any]


def read_rows(text: str) -> tuple[list[tuple[str, Fields]], str | None] | None:
    """The places (name, fields) and the frame of a plainly written map; None for any other text."""
    frame: str | None = None
    rows: list[tuple[str, Fields]] = []
    seen: set[str] = set()
    below = False
    indent = 0
    fields: Fields | None = None
    """Of the place whose fields stand on lines of their own."""
    inner = 0
    items: list[str] | None = None
    for line in text.split("\n"):
        if "#" in line:
            line = line.split(" #")[0] if not line.lstrip().startswith("#") else ""
        line = line.rstrip(" ")
        if not line:
            continue
        if not below:
            if line == "locations:":
                below = True
            elif frame is None and (match := _FRAME.fullmatch(line)) and _is_text(match[1]):
                frame = match[1]
            else:
                return None
            continue
        content = line.lstrip(" ")
        depth = len(line) - len(content)
        if not indent:
            indent = depth
        if depth == 0:
            return None
        if depth == indent and not content.startswith("-"):
            match = _ROW.fullmatch(content)
            if match is None:
                return None
            name = match[1] or match[2] or match[3]
            if name in seen or (match[1] and not _is_text(name)) or name != name.strip():
                return None
            seen.add(name)
            fields, items, inner = {}, None, 0
            if match[4] is not None:
                if not _flow(match[4], fields):
                    return None
                rows.append((name, fields))
                fields = None
            else:
                rows.append((name, fields))
            continue
        if fields is None:
            return None
        inner = inner or depth
        if content.startswith("- "):
            match = _ITEM.fullmatch(content)
            if match is None or items is None or depth < inner or not _is_text(match[1]):
                return None
            items.append(match[1])
            continue
        match = _BLOCK_FIELD.fullmatch(content)
        if match is None or depth != inner or depth <= indent or match[1] in fields:
            return None
        if match[2] is None:
            if match[1] not in ("aliases", "tags"):
                return None
            items = fields[match[1]] = []
        else:
            items = None
            if not _put(fields, match[1], match[2]):
                return None
    complete = all("x" in fields and "y" in fields and [] not in fields.values() for _, fields in rows)
    return (rows, frame) if rows and complete else None


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
