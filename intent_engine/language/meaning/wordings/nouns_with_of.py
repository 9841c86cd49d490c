"""What belongs to a thing, behind it with an "of": "the speed of the belt" of a grammar that has "the belt speed"."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.opposites import opposed
from intent_engine.language.words.thing_words import thing_words

__all__ = ["NounsWithOf"]

_MOST_OWNED = 2
"""Words for what belongs to a thing,"""
_MOST_OWNING = 3
"""and for that."""


class NounsWithOf:
    """Reads an utterance with two nouns side by side, as a grammar has them.

    Args:
        grammar: whose they are.
        own: the words that it is written in.
    """

    def __init__(self, grammar: Grammar, own: Collection[str]) -> None:
        known = thing_words(grammar.language)
        self._within = known.within
        self._definite = known.definite
        self._telling = known.definite | (known.telling_which & grammar.wording.points)
        self._language = grammar.language
        self._own = frozenset(own) - known.articles - known.within

    def ways(self, core: Utterance) -> Iterator[Rewording]:
        """With each such noun before the one that it belongs to. Both have their "the", or what points to it: "a cup
        of tea" is no "tea cup"."""
        words = core.words
        for place in range(3, len(words) - 2):
            if words[place] not in self._within or words[place + 1] not in self._telling:
                continue
            for begin in range(place - 1, max(place - _MOST_OWNED, 1) - 1, -1):
                owned = words[begin:place]
                if words[begin - 1] not in self._definite or not self._are_own(owned):
                    continue
                for end in range(place + 3, min(place + 2 + _MOST_OWNING, len(words)) + 1):
                    owning = words[place + 2 : end]
                    if self._are_own(owning) and not any(core.breaks[begin:end]):
                        said = core.with_other(begin, end, Utterance.in_one_breath([*owning, *owned]))
                        yield Rewording(said, _SideBySide(owning, owned, self._language))

    def _are_own(self, words: Sequence[str]) -> bool:
        return all(word in self._own for word in words)


class _SideBySide:
    """Whether two nouns stand side by side in a sentence: as its own words, or as a value of a list and such a word, or
    as one value."""

    def __init__(self, owning: Sequence[str], owned: Sequence[str], language: str) -> None:
        self._no_noun = any(opposed(word, language) for word in owned)
        self._owning, self._owned = tuple(owning), tuple(owned)

    def __call__(self, reading: Reading) -> bool:
        both = self._owning + self._owned
        starts = range(len(reading.words) - len(both) + 1)
        return not reading.free_words and any(
            reading.words[start : start + len(both)] == both and self._are_nouns(reading, start) for start in starts
        )

    def _are_nouns(self, reading: Reading, start: int) -> bool:
        middle, end = start + len(self._owning), start + len(self._owning) + len(self._owned)
        within = [slot for slot in reading.slots if slot.start < end and slot.end > start]
        if any(slot.slot.type != "choice" for slot in within):
            return False
        return not within or [(slot.start, slot.end) for slot in within] in (
            [(start, middle)],
            [(start, end)],
            *([] if self._no_noun else [[(middle, end)]]),  # "the left of the arm" is no "arm left"
        )
