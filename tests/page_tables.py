"""The tables of a page of the docs, for tests that run them row by row."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

DOCS = Path(__file__).resolve().parent.parent / "docs"


class Row(NamedTuple):
    line: int
    section: str
    """The heading right above its table."""
    head: list[str]
    cells: list[str]
    file: str | None
    """The last file that its section shows."""


def rows(page: str) -> Iterator[Row]:
    """All rows of all tables of ``docs/<page>``."""
    head: list[str] = []
    file, block, section = None, "", ""
    fenced = False
    for number, line in enumerate((DOCS / page).read_text("utf-8").splitlines(), 1):
        if line.startswith("```"):
            if fenced and re.match(r"# \w+\.yaml\n", block):
                file = block
            fenced, block = not fenced, ""
        elif fenced:
            block += line + "\n"
        elif line.startswith("#"):
            section = line.lstrip("# ")
            file = None if line.startswith("## ") else file
        elif not line.startswith("|"):
            head = []
        elif not head:
            head = _cells(line)
        elif not line.startswith("|---"):
            yield Row(number, section, head, _cells(line), file)


def _cells(line: str) -> list[str]:
    return [cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]


def quoted(cell: str) -> list[str]:
    """What is said: the texts in quotes, and in code those that hold a quote."""
    return [code or text for code, text in re.findall(r'`([^`]*"[^`]*)`|"([^"]+)"', cell)]
