"""Text that is not quoted, and of which YAML leaves words out, or makes several texts, without a word about it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

__all__ = ["lost_words"]

_QUOTES = "\u201c\u201d\u201e\u201f\u2018\u201a\u00ab\u00bb\u2039\u203a"
"""Quotes that a word processor writes; YAML knows none of them."""
_CLOSING = _QUOTES + "\u2019"
_TEMPLATE = frozenset("[](){}|;")


def lost_words(node: Any, lines: Sequence[str]) -> tuple[str, str] | None:
    """What is lost of the words of a text, and what to do; None: nothing.

    Args:
        node: of a text on one line, as the YAML parser made it.
        lines: of the file.
    """
    start, end = node.start_mark, node.end_mark
    if node.style or start.line >= len(lines):
        return None
    line = lines[start.line]
    written = line[start.column : end.column].strip()
    quoted = f'quote it: "{written}"'
    if node.tag.startswith("!"):
        return f"YAML takes {node.tag} for a tag, and leaves it out", quoted
    if written.startswith("&") and not _has_alias(written.split()[0][1:], lines):
        return f"YAML takes {written.split()[0]} for the name of an anchor, and leaves it out", quoted
    if node.tag.endswith(":str") and (number := re.match(r"\s+(#(?:\d+|\{\w+\}))\s*$", line[end.column :])) is not None:
        hint = f'quote it: "{written} {number[1]}"; or put a blank behind the # of a comment'
        return f"YAML takes {number[1]} for a comment, and leaves it out", hint
    if written[:1] in tuple(_QUOTES) and (written[-1] not in _CLOSING or _TEMPLATE.intersection(written)):
        return f"{written[0]} is no quote for YAML", "write straight quotes, \" or '"
    return None


def _has_alias(name: str, lines: Sequence[str]) -> bool:
    return any(re.search(rf"\*{re.escape(name)}(?![\w-])", line) for line in lines)
