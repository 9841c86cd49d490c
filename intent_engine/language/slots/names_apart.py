"""Two names of lists one after the other that may be two others: of "living room light" the room may be the living
room, or the living, which has a room light."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from intent_engine.language.reading import SlotReading

__all__ = ["named_otherwise"]

_NAMED = frozenset(("boolean", "choice", "location"))


def named_otherwise(
    slots: Sequence[SlotReading], words: Sequence[str], read: Callable[[SlotReading, int, int], SlotReading]
) -> tuple[SlotReading, ...] | None:
    """The slots of one sentence with another two names in the same words; None: there is no other way.

    Args:
        slots: as they were read, in order.
        words: of the sentence.
        read: a slot again, with the words from one place to another.
    """
    for place, (slot, after) in enumerate(pairwise(slots)):
        if not {slot.slot.type, after.slot.type} <= _NAMED or not slot.status == after.status == "exact":
            continue
        between = words[slot.end : after.start]
        for cut in range(slot.start + 1, after.end - len(between)):
            if cut == slot.end or words[cut : cut + len(between)] != between:
                continue
            one, other = read(slot, slot.start, cut), read(after, cut + len(between), after.end)
            if one.status == other.status == "exact" and (one.value, other.value) != (slot.value, after.value):
                return (*slots[:place], one, other, *slots[place + 2 :])
    return None
