"""Amounts below zero beside a word that says which way: "turn left minus thirty degrees" may be right, or a slip."""

from __future__ import annotations

from intent_engine.language.reading import Reading
from intent_engine.language.words.opposites import opposed

__all__ = ["sign_and_side"]

_POINTING = frozenset(("angle", "distance"))
"""Types of slots whose sign says which way; of others ("heat to minus five degrees") it says how much."""


def sign_and_side(reading: Reading, language: str) -> str:
    """Why it is not clear which way something goes, of which both a side and a sign were said; empty: it is clear. A
    side is a word that has an opposite and stands in no slot with a sign, beside it or behind the verb."""
    for slot in reading.slots:
        below = slot.slot.type in _POINTING and isinstance(slot.value, (int, float)) and slot.value < 0
        if not below:
            continue
        others = [word for at, word in enumerate(reading.words) if not slot.start <= at < slot.end]
        side = next((word for word in others if opposed(word, language)), "")
        if side:
            said = " ".join(reading.words[slot.start : slot.end])
            return f"{said!r} points back from {side!r}; say the side that is meant, and how much without a sign"
    return ""
