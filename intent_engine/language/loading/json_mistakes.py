"""What is wrong in a file that is called JSON, in words of JSON: YAML, of which it is a part, sees other mistakes."""

from __future__ import annotations

import json
import re

from intent_engine.errors import Problem

__all__ = ["json_problem"]

_TOLD = {
    "Expecting ',' delimiter": ("a comma or a closing bracket is missing here", "write it before this"),
    "Expecting ':' delimiter": ("a colon is missing here", 'write "name": value'),
    "Expecting property name enclosed in double quotes": ("a name in double quotes is missing here", None),
    "Expecting value": ("a value is missing here", None),
    "Extra data": ("something follows the end", "remove it, or close what it belongs to further down"),
    "Unterminated string starting at": ("a quote that is opened here is never closed", "close it on its own line"),
    "Invalid control character at": ("a text goes on over the end of its line", "close its quote, or write \\n"),
    "Invalid \\escape": ("\\ begins a sign here that there is not", "write \\\\ for one \\"),
}


def json_problem(text: str, file: str) -> Problem | None:
    """The first mistake, with its line and column; None: it is JSON."""
    try:
        json.loads(text)
    except json.JSONDecodeError as error:
        message, hint = _TOLD.get(error.msg, (error.msg[:1].lower() + error.msg[1:], None))
        before = text[: error.pos].rstrip()
        if text.startswith(("//", "/*", "#"), error.pos):
            message, hint = "JSON has no comments", "remove it; YAML has them, behind a #"
        elif text.startswith("'", error.pos):
            hint = "write it in double quotes"
        elif hint is None and before.endswith(","):
            message, hint = "nothing follows the comma before this", "remove the comma"
        lines = text.splitlines()
        line, column = error.lineno, error.colno
        if line > len(lines) or not lines[line - 1].strip():  # the end of the file: nobody can be shown an empty line
            line = before.count("\n") + 1
            column = len(re.split("\n", before)[-1]) + 1
        shown = lines[line - 1] if line <= len(lines) else ""
        return Problem(f"is not valid JSON: {message}", file, line, column, shown, hint)
    return None
