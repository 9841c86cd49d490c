"""Quantities in running text: where they stand, and what they are."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from intent_engine.language.normalize import Token, tokenize
from intent_engine.language.numbers.quantity_parser import parser_of
from intent_engine.language.numbers.units import Units, units
from intent_engine.language.slots.no_quantity import clause_ends, exponents_joined, no_amount, of_another_unit

__all__ = ["Found", "find"]

MAX_WORDS = 32
"""Words of the longest that is looked for: of a number nothing may be cut off."""
KINDS = ("speed", "angular_speed", "distance", "duration", "angle", "percent")
"""In the order in which they are tried: of two that are as long, the first is taken."""


@dataclass(frozen=True, slots=True)
class Found:
    """A quantity in running text."""

    kind: str
    value: float
    """SI; of a percentage a fraction of 1."""
    start: int
    """First character."""
    end: int
    """Character after the last."""
    text: str


def find(text: str, language: str = "en") -> list[Found]:
    """All quantities in a text, left to right, the longest at each place; plain numbers where there is no unit.

    What only looks like one is left out: amounts of no number ("a few hundred"), ordinals, times of the day, powers.
    """
    tokens = exponents_joined(tokenize(text, language), text)
    words = [token.word for token in tokens]
    ends = clause_ends(tokens, text, language)
    found: list[Found] = []
    at = 0
    while at < len(words):
        clause = words[: min(ends[at], at + MAX_WORDS)]
        after = no_amount(clause, at, tokens, text, language)
        if after > at:
            at = after
            continue
        longest = _longest(clause, at, language)
        if longest is not None and longest[1] != "number":
            after = of_another_unit(words, longest[0], longest[1], tokens, text, language)
            if after:  # the number was said, but of what we do not know
                number = _number(clause, at, language)
                if number is not None:
                    found.append(_found("number", number[1], tokens[at : number[0]], text))
                at = after
                continue
        if longest is None:
            at += 1
            continue
        after, kind, value = longest
        found.append(_found(kind, value, tokens[at:after], text))
        at = after
    return found


def _found(kind: str, value: float, tokens: Sequence[Token], text: str) -> Found:
    start, end = tokens[0].start, tokens[-1].end
    return Found(kind, value, start, end, text[start:end])


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
    if best is None and (number := _number(words, at, language)) is not None:
        best = (number[0], "number", number[1])
    return best if best is not None and math.isfinite(best[2]) else None


def _number(words: Sequence[str], at: int, language: str) -> tuple[int, float] | None:
    """The longest number that begins at a place: (after, value)."""
    best: tuple[int, float] | None = None
    for value, after in parser_of(language).numbers_at(words, at):
        if after > at and (best is None or after > best[0]):
            best = (after, value)
    return best if best is not None and math.isfinite(best[1]) else None
