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
        self._own: dict[str, tuple[str, ...]] = {}
        for names in table.symbols if table is not None else ():
            for place, name in enumerate(names):
                # One that is a word of the grammar only stands for those behind it, or two would stand for each other.
                others = tuple(filter(own.__contains__, names[place + 1 :] if name in own else names))
                if others:
                    self._own[name] = others

    def in_full(self, said: Utterance) -> Iterator[Utterance]:
        """Ways to write an utterance with such units as the grammar calls them: each straight behind a number, or
        behind the "per" of another unit that is."""
        words = said.words
        if self._own.keys().isdisjoint(words):
            return
        places = [place for place, word in enumerate(words) if word in self._own and self._counts(said, place)]
        if not places:
            return
        for ways in islice(product(*(self._own[words[place]] for place in places)), _MOST_WAYS):
            other = list(words)
            for place, name in zip(places, ways, strict=True):
                other[place] = name
            yield Utterance(other, list(said.breaks))

    def _counts(self, said: Utterance, place: int) -> bool:
        before = said.words[place - 1] if place else ""
        per = before in self._per and place > 2 and is_number(said.words[place - 3], self._language)
        return not said.breaks[place] and (per or is_number(before, self._language))


def _patterns(grammar: Grammar) -> Iterator[str]:
    for intent in grammar.intents.values():
        yield from intent.regex
        if intent.lark is not None:
            yield intent.lark
