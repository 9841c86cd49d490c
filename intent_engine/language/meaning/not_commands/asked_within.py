"""A question mark within a command: "go 1? meters" says that nobody knows how far."""

from __future__ import annotations

import re
from collections.abc import Sequence

from intent_engine.language.meaning.clause import Clause
from intent_engine.language.normalize import tokenize

__all__ = ["asked_within"]

_ASKED = re.compile(r"(?<=[^\s?])\?+(?!\s*$)")
"""A question mark straight behind a word, with more behind it."""


def asked_within(text: str, parts: Sequence[Clause], language: str) -> str:
    """The word behind which a question mark stands in the midst of what a slot holds, or straight behind a number that
    the command goes on from; empty: there is none. Behind a whole command or where it is asked for ("could you? turn
    left"), a mark leaves nothing open."""
    readings = [part.reading for part in parts if part.accepted and part.reading is not None]
    for mark in _ASKED.finditer(text) if "?" in text else ():
        before, behind = tokenize(text[: mark.start()], language), tokenize(text[mark.end() :], language)
        if not before or not behind:
            continue
        pair = (before[-1].word, behind[0].word)
        for reading in readings:
            for slot in reading.slots:
                places = range(slot.start, min(slot.end, len(reading.words) - 1))
                open_at = (at for at in places if reading.words[at : at + 2] == pair)
                if any(at + 1 < slot.end or pair[0][-1].isdigit() for at in open_at):
                    return pair[0]
    return ""
