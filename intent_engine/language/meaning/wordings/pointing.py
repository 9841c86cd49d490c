"""Words that point to a thing, where a grammar has its article: "weigh *that* vial", "honk *your* horn"."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.meaning.wordings.counted import counts_one
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.numbers.units import units
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Pointing"]


class Pointing:
    """Reads an utterance with the articles of a grammar in their places, or with none where it has none.

    Args:
        grammar: whose it is.
        own: the words that it is written in.
    """

    def __init__(self, grammar: Grammar, own: Collection[str]) -> None:
        self._pointing = grammar.wording.points
        self._units = units(grammar.language)
        self._language = grammar.language
        self._wholes = grammar.wording.wholes
        known = thing_words(grammar.language)
        self._all = known.articles | self._pointing
        self._definite = known.definite_of_things
        articles = self._definite or known.articles - self._pointing
        self._articles = [Utterance.in_one_breath([word]) for word in sorted(articles.intersection(own))]

    def ways(self, core: Utterance) -> Iterator[Rewording]:
        """With one article in the place of each."""
        for at in range(1, len(core) - 1):  # "pause the printer eight" of a grammar that has "pause printer {n}"
            if core.words[at] in self._definite and not any(core.breaks[at : at + 2]):
                yield Rewording(core.cut(at, at + 1), self._points_to_nothing_free)
        found = list(self._found(core))
        any_one = {"a"} if self._units is None else self._units.words["one"]
        counted = any(any_one.intersection(core.words[start:end]) for start, end in found)
        none = [] if counted else [Utterance([], [])]  # "a full" is no "full"
        for article in (*self._articles, *none) if found else ():
            said = core
            for start, end in reversed(found):
                said = said.with_other(start, end, article)
            yield Rewording(said, self._points_to_nothing_free)

    def _found(self, core: Utterance) -> Iterator[tuple[int, int]]:
        """Where such words stand before others in the same breath; "all the" is such as well."""
        words, start = core.words, 0
        while start < len(words) - 1:
            whole = self._wholes.at(words, start)
            end = start + whole + 1
            article = words[start + whole] if end < len(words) else ""
            points = article in (self._all if whole else self._pointing) and not counts_one(
                words[end - 1], words[end], self._language
            )
            if not points or any(core.breaks[start + 1 : end + 1]):
                start += 1
                continue
            yield start, end
            start = end

    def _points_to_nothing_free(self, reading: Reading) -> bool:
        """Whether none of it stands before any words that are free: "pick your battles" is about no thing."""
        free = (slot.start for slot in reading.slots if slot.slot.type in FREE_KINDS)
        return not any({*reading.words[max(start - 1, 0) : start + 1]} & self._all for start in free)
