"""Words before the preposition of a way that say no more of it: "bring the tray *over* to the lab"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance

__all__ = ["WaysOn"]

_PLACES = ("location", "choice")
_NUMBERED = ("number", "ordinal")
_MOST_ARTICLES = 1
_MOST_IN_A_NAME = 3
"""Words before the number of a place: "to the second gate", "to gate number seven"."""


class WaysOn:
    """Reads an utterance without such words."""

    def __init__(self, grammar: Grammar) -> None:
        wording = grammar.wording
        self._words = wording.ways_on
        self._to = wording.ways_to
        self._back = {words[0] for words in wording.ways_back if len(words) == 1}
        self._back_into = wording.back_into

    def without(self, core: Utterance) -> Utterance | None:
        """The same without those words; None: there are none."""
        said = core
        for place in reversed(self._places(core)):
            said = said.cut(place, place + 1)
        return said if said.words != core.words else None

    def means(self, core: Utterance, readings: Sequence[Reading]) -> bool:
        """Whether a place stands behind each of them: "turn it *down* to ten percent" says more than how far."""
        ways = [core.words[place + 1] for place in self._places(core)]
        for reading in readings:
            for slot in reading.slots:
                numbered = slot.slot.type in _NUMBERED
                most = _MOST_IN_A_NAME if numbered else _MOST_ARTICLES
                before = reading.words[max(slot.start - 1 - most, 0) : slot.start]
                led = next((way for way in ways if way in before), None)
                if led is not None and (numbered or slot.slot.type in _PLACES):
                    ways.remove(led)
        return not ways

    def _places(self, core: Utterance) -> list[int]:
        words, breaks = core.words, core.breaks
        return [
            place
            for place in range(1, len(words) - 1)
            if self._says_no_more(words[place], words[place + 1]) and not any(breaks[place : place + 2])
        ]

    def _says_no_more(self, word: str, preposition: str) -> bool:
        if word in self._back and preposition in self._back_into:
            return True  # "put the tray back on the shelf"
        return word in self._words and preposition in self._to
