"""Percentages of a turn that may be its speed or how far it goes: "turn left ninety percent"."""

from __future__ import annotations

from intent_engine.language.grammar import Grammar
from intent_engine.language.quantities import evaluate
from intent_engine.language.reading import Reading

__all__ = ["share_of_a_turn"]


def share_of_a_turn(reading: Reading, grammar: Grammar) -> str:
    """Why a turn is not clear, as nobody says of what its percentage is; empty: it is. "At ninety percent" and "ninety
    percent speed" are its speed, and so is every percentage where the angle or the time is said."""
    if reading.intent.action.type != "turn":
        return ""
    percent = ""
    for slot in reading.slots:
        if slot.slot.type in ("angle", "duration"):
            return ""
        if slot.slot.type == "angular_speed":
            before, said = reading.words[max(slot.start - 1, 0) : slot.start], reading.words[slot.start : slot.end]
            led = not grammar.wording.of_speed.isdisjoint(before)
            percent = " ".join(said) if not led and evaluate(said, "percent", grammar.language) is not None else ""
    return percent and f"{percent!r} may be how fast or how far to turn; say a speed ('at {percent}') or degrees"
