"""Dashes that stand apart before a number and may be its sign: "keep it at - 20 degrees"."""

from __future__ import annotations

import re
from collections.abc import Sequence

from intent_engine.language.free_text import FREE_KINDS
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers.quantity_parser import parser_of
from intent_engine.language.numbers.units import Units, units

__all__ = ["sign_or_dash"]

_DASH = re.compile("\\s*[-−‐‑‒–—]+\\s*")


def sign_or_dash(text: str, language: str, parts: Sequence[Clause]) -> str:
    """A number behind a dash that may be below zero; empty: there is none, or it stands among free words.

    No pause is made behind "to" or "at", which a value follows: "turn left - 20 degrees" has one.

    Args:
        text: what was said or typed.
        language: of it.
        parts: the commands that were understood.
    """
    level = (units(language) or Units({}, {})).words.get("level", frozenset())
    tokens = tokenize(text, language) if level and _DASH.search(text) else ()
    words = [token.word for token in tokens]
    for at in range(1, len(tokens)):
        between = text[tokens[at - 1].end : tokens[at].start]
        if words[at - 1] not in level or not _DASH.fullmatch(between):
            continue
        if next(parser_of(language).numbers_at(words, at), None) is not None and not _among_free(words[at], parts):
            return text[tokens[at - 1].end : tokens[at].end].strip()
    return ""


def _among_free(word: str, parts: Sequence[Clause]) -> bool:
    return any(
        slot.slot.type in FREE_KINDS and word in part.reading.words[slot.start : slot.end]
        for part in parts
        if part.reading is not None
        for slot in part.reading.slots
    )
