"""Maps as CSV: ``name,x,y,yaw,frame,aliases,tags``, lists separated by ``;``."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

from intent_engine.errors import Problem
from intent_engine.language.loading.other_words import FIELDS_OF_A_PLACE, meant
from intent_engine.language.maps.map_draft import FIELDS, Draft, Row

__all__ = ["read_table"]

COLUMNS = ("name", *FIELDS)
_PARTING = re.compile(r"\s*[,|]\s*")
"""What lists are often parted by elsewhere; here it would make one name of them, which nobody says."""
_HINT = "the first line must be: name,x,y,yaw,frame,aliases,tags (yaw and what follows may be left out)"


def read_table(path: Path, text: str) -> Draft:
    """The places of a CSV file."""
    lines = text.splitlines()
    draft = Draft()

    def problem(message: str, line: int, column: int = 1, hint: str | None = None) -> Problem:
        shown = lines[line - 1] if 0 < line <= len(lines) else None
        return Problem(message, str(path), line, column if shown else None, shown, hint)

    reader = csv.reader(io.StringIO(text), strict=True)
    try:
        rows = list(_numbered(reader))
    except csv.Error as error:
        draft.problems.append(problem(f"is not valid CSV: {error}", reader.line_num, 1, "is every quote closed?"))
        return draft
    if not rows:
        draft.problems.append(Problem("is empty", str(path), hint=_HINT))
        return draft
    top, header = rows[0]
    columns = _without_empty([cell.strip().lower() for cell in header], 0)
    missing = [column for column in ("name", "x", "y") if column not in columns]
    other = next((sign for sign in ";\t|" if len(columns) == 1 and sign in columns[0]), None)
    if missing and other is not None:
        parted = "by tabs" if other == "\t" else f"by {other!r}"
        draft.problems.append(
            problem(f"has its columns parted {parted}", top, 1, "part them by ',', and write 5.5 for 5,5")
        )
        return draft
    if missing:
        draft.problems.append(problem(f"has no column {' or '.join(missing)}", top, 1, _HINT))
        return draft
    for column in columns:
        if column not in COLUMNS or columns.count(column) > 1:
            what = "stands twice" if column in COLUMNS else "is not known"
            hint = meant(column, FIELDS_OF_A_PLACE, COLUMNS) or _HINT
            draft.problems.append(problem(f"column {column!r} {what}", top, 1, hint))
            return draft
    if len(rows) == 1:
        draft.problems.append(
            problem("has no place below its header", top, 1, "add a line for each: kitchen,5.0,2.0,0.0")
        )
    found: list[Row] = []
    for line, row in rows[1:]:
        cells = _without_empty(row, len(columns))
        if len(cells) > len(columns):
            hint = "put quotes around a name that holds a comma; separate aliases by ';'"
            draft.problems.append(
                problem(f"has {len(cells)} fields, but there are {len(columns)} columns", line, 1, hint)
            )
            continue
        given = {column: cell.strip() for column, cell in zip(columns, cells, strict=False)}
        for key in ("aliases", "tags"):
            if (together := given.get(key, "")) and ";" not in together and (sign := _PARTING.search(together)):
                hint = f"separate them by ';': {_PARTING.sub('; ', together)}"
                draft.problems.append(problem(f"{key} are not separated by {sign[0].strip()!r}", line, 1, hint))
        found.append(_row(given, line, problem, lines))
    draft.rows = found
    return draft


def _without_empty(cells: list[str], least: int) -> list[str]:
    """Cells of a line without the empty ones at its end, which spreadsheets write."""
    end = len(cells)
    while end > least and not cells[end - 1].strip():
        end -= 1
    return cells[:end]


def _numbered(reader: Any) -> Any:
    """(line, cells) of every row that is not empty."""
    last = 0
    for cells in reader:
        if any(cell.strip() for cell in cells) and not cells[0].lstrip().startswith("#"):
            yield last + 1, cells
        last = reader.line_num


def _row(given: dict[str, str], line: int, problem: Callable[..., Problem], lines: list[str]) -> Row:
    values: dict[str, Any] = {}
    for key in ("x", "y", "yaw"):
        if given.get(key):
            try:
                values[key] = float(given[key])
            except ValueError:
                values[key] = given[key]
    if given.get("frame"):
        values["frame"] = given["frame"]
    for key in ("aliases", "tags"):
        items = [item.strip() for item in given.get(key, "").split(";")]
        if any(items):
            values[key] = [item for item in items if item]

    def tell(key: str, message: str, hint: str | None) -> Problem:
        shown = lines[line - 1] if line <= len(lines) else ""
        return problem(message, line, _column(shown, given, key), hint)

    return Row(given.get("name", ""), values, tell)


def _column(shown: str, given: dict[str, str], key: str) -> int:
    """The column, from 1, at which a cell begins in its line; 1 where it has none. The cells before it are passed one
    by one, since it may be in their words: the "a" of "bar,a,2"."""
    at = 0
    for column, cell in given.items():
        first = cell.split(";")[0]
        found = shown.find(first, at)
        if column == key:
            return max(found, 0) + 1 if first else 1
        at = max(found, at) + len(cell)
    return 1
