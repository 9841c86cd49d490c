"""``\\w`` for RE2, in which it stands for the letters of English alone: "küche" is a word as well, as to Python."""

from __future__ import annotations

import re

__all__ = ["with_every_letter"]

_WORD = r"\p{L}\p{M}\p{N}_"
_PIECE = re.compile(r"\\Q.*?(?:\\E|$)|\\.|\[:\^?\w+:\]|\[\^?\]?|.", re.DOTALL)


def with_every_letter(pattern: str) -> str:
    """A regular expression whose ``\\w`` and ``\\W`` are of every language. A ``\\W`` within a class stays."""
    if r"\w" not in pattern and r"\W" not in pattern:
        return pattern
    found: list[str] = []
    within = False
    for piece in _PIECE.findall(pattern):
        if piece == r"\w":
            piece = _WORD if within else f"[{_WORD}]"
        elif piece == r"\W" and not within:
            piece = f"[^{_WORD}]"
        elif within:
            within = piece != "]"
        elif piece[0] == "[":
            within = True
        found.append(piece)
    return "".join(found)
