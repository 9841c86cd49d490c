"""Slots to words: the ways to say values of them, each with its value, for sampling."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from intent_engine.language.grammar import QUANTITY_KINDS, Grammar, Slot
from intent_engine.language.sampling.spoken_quantities import Spoken, spoken_forms
from intent_engine.language.slots.free_text import FreeText
from intent_engine.language.slots.own_units import units_called
from intent_engine.language.templates.spellings import own_words
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["SpokenSlots", "size"]

STAND_INS = ("blick", "dax", "wug", "zorp")
"""For a grammar that uses all of these words itself."""


class SpokenSlots:
    """Knows what may be said for the slots of one grammar and map that are no choices.

    Args:
        grammar: as loaded.
        locations: the map whose names are said.
        texts: slot name to what is said for it, for text slots; of others words that the grammar has no use for.
    """

    def __init__(
        self, grammar: Grammar, locations: LocationMap | None, texts: Mapping[str, Sequence[str]] | None = None
    ) -> None:
        self._grammar = grammar
        self._locations = locations
        self._texts = dict(texts or {})
        self._said: dict[str, Sequence[Sequence[Spoken]]] = {}

    def ways(self, slot: Slot) -> Sequence[Sequence[Spoken]]:
        """The ways to say values of a slot that is no choice, in forms; the shortest first. Empty if there is none."""
        ways = self._said.get(slot.name)
        if ways is None:
            if slot.type in QUANTITY_KINDS:
                smallest = [limit for limit in (slot.smallest, slot.least) if limit is not None]
                limits = max(smallest, default=None), slot.maximum
                phrases, language = self._grammar.phrases, self._grammar.language
                own = tuple((worth, tuple(map(" ".join, names))) for worth, names in units_called(slot, phrases))
                ways = spoken_forms(
                    slot.type,
                    language,
                    slot.unit,
                    *limits,
                    whole=slot.whole,
                    own=own,
                    bare=slot.bare,
                    digits=slot.digits,
                )
            else:
                said = sorted(
                    self._places(slot) if slot.type == "location" else self._things(slot),
                    key=lambda spoken: (size(spoken.text), spoken.text),
                )
                ways = (said,) if said else ()
            self._said[slot.name] = ways
        return ways

    def _places(self, slot: Slot) -> Iterator[Spoken]:
        """The places that a slot takes, by each of their names."""
        for words, name in self._locations.names() if self._locations is not None else ():
            assert self._locations is not None
            if not slot.tags or slot.tags & set(self._locations[name].tags):
                yield Spoken(" ".join(words), name)

    def _things(self, slot: Slot) -> Iterator[Spoken]:
        """What is said for free text: what was given for it, or else words of which the grammar has no other use."""
        given = self._texts.get(slot.name)
        if given is not None:
            yield from (
                Spoken(text, text if slot.dictation else self._free.thing(slot, self._heard(text))) for text in given
            )
            return
        taken = self._own_words | slot.without
        known = [text for text in thing_words(self._grammar.language).examples if taken.isdisjoint(text.split())]
        for text in known or STAND_INS:
            if len(text.split()) <= slot.max_words:
                yield Spoken(text, text)
            room = slot.max_words - slot.dictation  # what is dictated is taken with its article
            if self._grammar.language == "en" and len(text.split()) <= room:
                yield Spoken(f"the {text}", f"the {text}" if slot.dictation else text)

    def _heard(self, text: str) -> list[str]:
        return Utterance.of(text, self._grammar.language).words

    @cached_property
    def _free(self) -> FreeText:
        return FreeText(self._grammar)

    @cached_property
    def _own_words(self) -> frozenset[str]:
        """Every word that the grammar itself has a use for."""
        grammar, operators = self._grammar, self._grammar.operators
        found = {*operators.closed, *grammar.sound_alikes, *grammar.homophones}
        for phrases in (
            grammar.fillers, grammar.wake, operators.negation, operators.correction, operators.cancel,
            operators.sequence, operators.contrast, operators.stop,
        ):  # fmt: skip
            found.update(word for phrase in phrases for word in phrase)
        found.update(own_words(grammar))
        return frozenset(found)


def size(text: str) -> float:
    """Words, and of as many words the fewest letters."""
    return len(text.split()) + len(text) / 10_000
