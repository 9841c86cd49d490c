"""Whether the words around which something was said otherwise are those of an amount."""

from __future__ import annotations

from collections.abc import Collection

from intent_engine.language.grammar import QUANTITY_KINDS
from intent_engine.language.reading import Reading

__all__ = ["AMOUNTS", "Begins", "Ends"]

AMOUNTS = frozenset({*QUANTITY_KINDS, "number"})


class Begins:
    """Whether an amount begins with one of some words; where nothing may be ``free``, words before it could be its."""

    def __init__(self, words: Collection[str], kinds: Collection[str], *, free: bool = True) -> None:
        self._words = words
        self._kinds = kinds
        self._free = free

    def __call__(self, reading: Reading) -> bool:
        if reading.free_words and not self._free:
            return False
        return any(slot.slot.type in self._kinds and reading.words[slot.start] in self._words for slot in reading.slots)


class Ends:
    """Whether an amount ends with one of some words."""

    def __init__(self, words: Collection[str]) -> None:
        self._words = words

    def __call__(self, reading: Reading) -> bool:
        ends = (slot.end - 1 for slot in reading.slots if slot.slot.type in AMOUNTS)
        return any(reading.words[end] in self._words for end in ends)
