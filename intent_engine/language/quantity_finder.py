"""Quantities in running text: where they stand, and what they are."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers.quantity_parser import MAX_WORDS, parser_of
from intent_engine.language.numbers.units import Units, units

__all__ = ["Found", "find"]

KINDS = ("speed", "angular_speed", "distance", "duration", "angle")
"""In the order in which they are tried: of two that are as long, the first is taken."""


@dataclass(frozen=True, slots=True)
class Found:
    """A quantity in running text."""

    kind: str
    value: float
    """SI."""
    start: int
    """First character."""
    end: int
    """Character after the last."""
    text: str


def find(text: str, language: str = "en") -> list[Found]:
    """All quantities in a text, left to right, the longest at each place; plain numbers where there is no unit."""
    tokens = tokenize(text, language)
    words = [token.word for token in tokens]
    found: list[Found] = []
    at = 0
    while at < len(words):
        longest = _longest(words[: at + MAX_WORDS], at, language)
        if longest is None:
            at += 1
            continue
        after, kind, value = longest
        start, end = tokens[at].start, tokens[after - 1].end
        found.append(Found(kind, value, start, end, text[start:end]))
        at = after
    return found


def _longest(words: Sequence[str], at: int, language: str) -> tuple[int, str, float] | None:
    """The longest quantity that begins at a place, or else the longest number: (after, kind, value)."""
    parser = parser_of(language)
    one = (units(language) or Units({}, {})).words.get("one", frozenset())
    best: tuple[int, str, float] | None = None
    for kind in KINDS:
        first = next(parser.quantities_at(words, at, kind), None)
        if first is None:
            continue
        value, after = first
        bare_article = after == at + 2 and words[at] in one and kind == "angle"  # "a turn"
        if (best is None or after > best[0]) and not bare_article:
            best = (after, kind, value)
    if best is None:
        for value, after in parser.numbers_at(words, at):
            if after > at and (best is None or after > best[0]):
                best = (after, "number", value)
    return best if best is not None and math.isfinite(best[2]) else None
