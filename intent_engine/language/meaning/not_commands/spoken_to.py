"""Whom a command is said to, by a name behind it: "put it on the table, Ben". It is not the robot's, nor a thing's."""

from __future__ import annotations

import re
from collections.abc import Sequence

from intent_engine.language.meaning.clause import Clause
from intent_engine.language.slots.slot_values import SlotValues
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["spoken_to"]

_NAME = re.compile(
    r"(?:^|\s)[^\sA-Z]\S*[,;]\s+([A-Z][a-z][\w'’-]*(?:\.?\s[A-Z][\w'’-]*)?)(?=(?:,?\s+please)?\s*(?:[,;.!?]|$))"
)
"""A name between two pauses, or behind one at the end, with its capital, and no capital before that pause."""
_LAST_WORD = re.compile(r"(\S+)[,;]\s+([^\W\d_][\w'’-]*)(?=(?:,?\s+bitte)?\s*[.!?]*\s*$)")
"""A word behind a pause at the end, however it is written, and the one before."""
_CAPITAL_NOUNS = frozenset(("de",))
"""Languages that write a capital in every noun: there only one word behind the pause may be a name, and any may."""


def spoken_to(text: str, parts: Sequence[Clause], values: SlotValues, language: str) -> str:
    """The name that a command takes for the end of a thing's name; empty: there is none.

    Args:
        text: what was said or typed.
        parts: the commands that it would be.
        values: of their slots.
        language: of the text.
    """
    if not any(mark in text for mark in ",;"):
        return ""
    readings = [part.reading for part in parts if part.reading is not None]
    things = [
        (slot.slot.known, reading.words[slot.start : slot.end])
        for reading in readings
        for slot in reading.slots
        if values.is_thing(slot.slot) and not slot.slot.dictation
    ]
    found = _last_word(text, language) if language in _CAPITAL_NOUNS else _NAME.findall(text)
    for name in found if things else ():
        words = Utterance.of(name, language).words
        for known, said in things:
            # Of "Mrs. Miller" the title may be written in full.
            if len(said) > len(words) and said[-1:] == tuple(words[-1:]) and not known.issuperset(words):
                return str(name)
    return ""


def _last_word(text: str, language: str) -> list[str]:
    """The word behind a pause at the end of a text, unless the noun is still to come before it: "die kleine, Tasse"."""
    found = _LAST_WORD.search(text)
    if found is None:
        return []
    (before, last), known = found.groups(), thing_words(language)
    describes = before.lower() in known.qualities or (before[0].islower() and last[0].isupper())
    return [] if describes and before not in known.joining else [last]
