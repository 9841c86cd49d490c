"""Units that are words of a sentence, as recognisers write them: "5 kg" of "{weight} kilograms", "3 l/min"."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice, product

from intent_engine.language.grammar import Grammar
from intent_engine.language.numbers.units import units
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.templates.spellings import own_words
from intent_engine.language.utterance import Utterance

__all__ = ["UnitSymbols"]

_MOST_WAYS = 16


class UnitSymbols:
    """Says which words of a grammar units behind numbers may stand for that it has under another name.

    Args:
        grammar: whose sentences have such units.
    """

    def __init__(self, grammar: Grammar) -> None:
        table = units(grammar.language)
        own = own_words(grammar).union(*(set(re.findall(r"[^\W\d_]+", text)) for text in _patterns(grammar)))
        self._language = grammar.language
        self._per = table.words["per"] - table.words["one"] if table is not None else frozenset()
        self._own: dict[tuple[str, ...], tuple[tuple[str, ...], ...]] = {}
        for names in table.symbols if table is not None else ():
            apart = [tuple(name.split()) for name in names]
            for place, name in enumerate(apart):
                # One that is a word of the grammar only stands for those behind it, or two would stand for each other.
                others = tuple(filter(own.issuperset, apart[place + 1 :] if own.issuperset(name) else apart))
                if others:
                    self._own[name] = others
        self._begin = frozenset(name[0] for name in self._own)
        self._longest = max(map(len, self._own), default=0)

    def in_full(self, said: Utterance) -> Iterator[Utterance]:
        """Ways to write an utterance with such units as the grammar calls them: each straight behind a number, or
        behind the "per" of another unit that is."""
        if self._begin.isdisjoint(said.words):
            return
        places = list(self._places(said))
        if not places:
            return
        for ways in islice(product(*(self._own[tuple(said.words[at:end])] for at, end in places)), _MOST_WAYS):
            words, breaks = list(said.words), list(said.breaks)
            for (at, end), name in reversed(list(zip(places, ways, strict=True))):
                words[at:end] = name
                breaks[at:end] = [False] * len(name)
            yield Utterance(words, breaks)

    def _places(self, said: Utterance) -> Iterator[tuple[int, int]]:
        """Where such units begin and end, each as long as it can be."""
        at = 0
        while at < len(said.words):
            ends = range(min(at + self._longest, len(said.words)), at, -1)
            end = next((end for end in ends if tuple(said.words[at:end]) in self._own), at)
            if end > at and self._counts(said, at) and not any(said.breaks[at:end]):
                yield at, end
            at = max(end, at + 1)

    def _counts(self, said: Utterance, place: int) -> bool:
        before = said.words[place - 1] if place else ""
        per = before in self._per and place > 2 and is_number(said.words[place - 3], self._language)
        return per or is_number(before, self._language)


def _patterns(grammar: Grammar) -> Iterator[str]:
    for intent in grammar.intents.values():
        yield from intent.regex
        if intent.lark is not None:
            yield intent.lark
