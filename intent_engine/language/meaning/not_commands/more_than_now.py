"""Values that are said as what is added to that of now: nobody knows what "ten percent more" of a fan comes to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.numbers.quantity_parser import parser_of
from intent_engine.language.numbers.units import Units, units
from intent_engine.language.slots.own_units import units_called
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["MoreThanNow"]


class MoreThanNow:
    """Those of one grammar: a number with its unit behind "to" or "at", and with "more". Thread-safe.

    Things that are counted are no such value: "deliver it to two more rooms".
    """

    def __init__(self, grammar: Grammar) -> None:
        self._language = grammar.language
        table = units(grammar.language) or Units({}, {})
        own = (
            words
            for slot in grammar.slots.values()
            for _, names in units_called(slot, grammar.phrases)
            for words in names
        )
        self._level = table.words.get("level", frozenset())
        self._added = PhraseSet(words.split() for words in table.words.get("added", ()))
        self._units = PhraseSet((*table.names, *own))
        self._sizes = frozenset[str]().union(*grammar.wording.sizes.values())

    def within(self, words: Sequence[str], parts: Sequence[Clause]) -> str:
        """What is said so; empty: nothing is, or it stands in free words.

        Args:
            words: all that was said.
            parts: the commands that were understood.
        """
        if not self._added.may_stand_in(words) or self._level.isdisjoint(words):
            return ""
        free = [" ".join(name) for part in parts for name in part.free_names]
        for at, word in enumerate(words[:-1]):
            size = words[at - 1] if at else ""
            end = max(self._ends(words, at + 1, size), default=0) if word in self._level else 0
            said = " ".join(words[at + 1 : end])
            if said and not any(said in text for text in free):
                return said
        return ""

    def _ends(self, words: Sequence[str], begin: int, size: str) -> Iterator[int]:
        """Where such a value ends that begins at a place: "ten percent *more*", "two more *degrees*", "another ten
        *percent*". Behind a size it has any unit: "the *pressure* to three more bar"."""
        led = self._added.at(words, begin)
        for start in {begin, begin + led}:
            for _, after in parser_of(self._language).numbers_at(words, start):
                more = self._added.at(words, after)
                unit = after + more + self._units.at(words, after + more)
                if unit == after + more and not (size in self._sizes and unit < len(words)):
                    continue
                behind = self._added.at(words, unit)
                if more or behind or start > begin:
                    yield unit + behind
