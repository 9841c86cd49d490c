"""Places that need no preposition: "take me *home*" and "bring it *upstairs*", where a grammar goes "to {place}"."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["PlacesAlone"]

_PLACES = ("choice", "location")


class PlacesAlone:
    """Reads an utterance with the preposition before such a place.

    Args:
        grammar: whose language has such places.
    """

    def __init__(self, grammar: Grammar) -> None:
        known = thing_words(grammar.language)
        self._places, self._to = grammar.wording.places_alone, sorted(grammar.wording.ways_to)
        self._no_verb = known.articles | known.joining | known.binding
        self._on = grammar.wording.ways_on

    def ways(self, core: Utterance) -> Iterator[Rewording]:
        """With each of the prepositions before one of the places."""
        for at in range(1, len(core)):
            if core.words[at] in self._places and not core.breaks[at] and core.words[at - 1] not in self._no_verb:
                begin = at - 1 if at > 1 and core.words[at - 1] in self._on else at  # "take me *back* home"
                for to in self._to:
                    said = core.with_other(begin, at, Utterance.in_one_breath([to]))
                    yield Rewording(said, partial(_is_place, core.words[at]))


def _is_place(word: str, reading: Reading) -> bool:
    """Whether a word is the whole name of a place that is known."""
    named = (slot for slot in reading.slots if slot.slot.type in _PLACES and slot.status == "exact")
    return any(reading.words[slot.start : slot.end] == (word,) for slot in named)
