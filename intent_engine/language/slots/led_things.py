"""Free words that begin with a way or a place, and are no name of a thing: "get *off the table*", "get *over it*"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import Grammar, Slot
from intent_engine.language.words.thing_words import thing_words

__all__ = ["LedThings"]


class LedThings:
    """Those of one grammar. Thread-safe."""

    def __init__(self, grammar: Grammar) -> None:
        wording, known = grammar.wording, thing_words(grammar.language)
        particles = frozenset[str]().union(*wording.particles.values())
        self._leads = particles | wording.ways_to | (known.joining & wording.leads)
        self._led = known.articles | known.pronouns | known.within | known.where | self._leads

    def tells_a_way(self, slot: Slot, said: Sequence[str]) -> bool:
        """Whether words begin so: a preposition or a particle stands before another, an article or a pronoun. An "off
        switch" is a thing, and so is what the slot allows."""
        if len(said) < 2 or said[0] not in self._leads or said[0] in slot.allow | slot.known:
            return False
        return said[1] in self._led
