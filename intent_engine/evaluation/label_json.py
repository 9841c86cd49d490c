"""The lines of a labels file as JSON objects, and what is said of a file that was written in another form."""

from __future__ import annotations

import csv
import json
from typing import Any

__all__ = ["LabelLineError", "file_in_other_form", "read_object"]

EXAMPLE = '{"audio": "one.wav", "text": "go forward two meters"}'
LONGEST_NUMBER = 300
"""Digits of a number that a ``float`` surely holds."""


class LabelLineError(ValueError):
    """A line is no label.

    Args:
        message: what is wrong with it.
        column: where in the line, from 1; None: nowhere in it.
        hint: what to write.
    """

    def __init__(self, message: str, column: int | None = None, hint: str | None = None) -> None:
        super().__init__(message)
        self.column = column
        self.hint = hint


def read_object(line: str) -> dict[str, Any]:
    """The object of a line.

    Raises:
        LabelLineError: it is none, or holds a key twice, a number beyond all bounds or half a character.
    """
    try:
        data = json.loads(line, object_pairs_hook=_each_once, parse_int=_bounded)
    except json.JSONDecodeError as error:
        raise LabelLineError(f"is no JSON: {error.msg}", error.colno, _rewrite(line, error)) from None
    except RecursionError:
        raise LabelLineError("is nested too deep") from None
    if not isinstance(data, dict):
        hint = f"one object a line: {EXAMPLE}" if isinstance(data, list) else EXAMPLE
        raise LabelLineError("is no JSON object", hint=hint)
    try:
        "".join(_texts(data)).encode()
    except UnicodeEncodeError as error:
        half = error.object[error.start]
        raise LabelLineError(f"holds half a character, {half!r}", hint="write the character itself, in UTF-8") from None
    return data


def file_in_other_form(text: str) -> tuple[int, LabelLineError] | None:
    """What is said once of a whole file that is no JSON lines: one array or object over many lines, or a table.

    Returns:
        The line, from 1, and what is wrong with it; None: its lines are to be looked at one by one.
    """
    lines = text.split("\n")
    number = next((index for index, line in enumerate(lines, 1) if line.strip()), 0)
    if not number:
        return None
    first = lines[number - 1].strip()
    rest = text.strip()
    if first[0] == "[" and len(rest) > len(first) and not _whole(first):
        hint = f"take out the brackets around all and the commas between, and write one object a line: {EXAMPLE}"
        return number, LabelLineError("is no JSON object, but begins an array", hint=hint)
    if first[0] == "{" and not _whole(first) and _whole(rest):
        return number, LabelLineError("is an object over several lines", hint=f"write each on one line: {EXAMPLE}")
    if first[0] not in "{[" and len(heads := _heads(first)) > 1 and "audio" in heads:
        hint = f"write one JSON object a line: {EXAMPLE}"
        return number, LabelLineError("is the head of a table, not JSON", hint=hint)
    begins = [line.strip()[0] for line in lines if line.strip()]
    if len(begins) > 1 and not {"{", "["} & set(begins):
        hint = f"write one JSON object a line: {EXAMPLE}"
        return number, LabelLineError("is no JSON, nor is any line of the file", hint=hint)
    return None


def _whole(text: str) -> bool:
    """Whether JSON begins a text and is complete in it."""
    try:
        json.JSONDecoder().raw_decode(text)
    except (ValueError, RecursionError):
        return False
    return True


def _heads(line: str) -> list[str]:
    for sign in ",;\t":
        if sign in line:
            return [cell.strip().lower() for cell in next(csv.reader([line], delimiter=sign))]
    return []


def _each_once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for key, value in pairs:
        if key in found:
            raise LabelLineError(f"has {key!r} twice", hint="leave one of the two")
        found[key] = value
    return found


def _bounded(digits: str) -> int:
    if len(digits) > LONGEST_NUMBER:
        raise LabelLineError(f"holds a number of {len(digits)} digits", hint="give seconds, meters and radians")
    return int(digits)


def _texts(value: Any) -> list[str]:
    if isinstance(value, str):
        return [value]
    if isinstance(value, dict):
        return [text for pair in value.items() for item in pair for text in _texts(item)]
    return [text for item in value for text in _texts(item)] if isinstance(value, list) else []


def _rewrite(line: str, error: json.JSONDecodeError) -> str:
    """What to write in the place of a common slip."""
    at = line[error.pos : error.pos + 1]
    if error.msg == "Extra data" and at == ",":
        return "each line is an object of its own, with no comma behind it"
    if at in ("}", "]") or "trailing comma" in error.msg:
        return "no comma before the closing bracket"
    if at in ("“", "”", "„", "‟"):
        return "write straight double quotes, as a text editor does, not a word processor's"
    if "escape" in error.msg:
        return "write paths with /, or each \\ twice"
    if line.lstrip()[:1] == "#" or line.lstrip()[:2] == "//":
        return 'JSON has no comments; a key of your own may hold one: "note": "..."'
    return "each line is one object in braces, with names and texts in double quotes"
