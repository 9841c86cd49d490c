"""A list of a language file, written short: ``"(can|could) you [please]"`` stands for the four ways to say it.

Brackets mean what they mean in a sentence of a grammar. A list within a list stands for what it holds.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

__all__ = ["in_full"]

_PIECE = re.compile(r"[()\[\]|]|[^()\[\]|]+")
"""A sign, or what stands between two."""


def in_full(written: Iterable[object]) -> tuple[str, ...]:
    """Everything that a list stands for, each once."""
    return tuple(dict.fromkeys(_phrases(written)))


def _phrases(written: Iterable[object]) -> Iterator[str]:
    for item in written:
        if isinstance(item, list):
            yield from _phrases(item)
        elif "(" in (text := str(item)) or "[" in text:
            yield from (" ".join(way.split()) for way in _ways(iter(_PIECE.findall(text))))
        else:
            yield text


def _ways(pieces: Iterator[str]) -> list[str]:
    """Every way to say what stands before the next bracket that closes, or the end."""
    complete, begun = [], [""]
    for piece in pieces:
        if piece in (")", "]"):
            break
        if piece == "|":
            complete += begun
            begun = [""]
            continue
        choices = _ways(pieces) if piece in ("(", "[") else [piece]
        if piece == "[":
            choices.insert(0, "")
        begun = [way + choice for way in begun for choice in choices]
    return complete + begun
