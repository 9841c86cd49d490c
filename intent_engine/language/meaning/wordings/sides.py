"""Which way something goes, in other words for the same way: "turn *to the left*" of a grammar that has "turn left"."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["Sides"]


class Sides:
    """Reads an utterance with such words as a grammar has them.

    Args:
        grammar: whose they are.
        own: the words that it is written in.
    """

    def __init__(self, grammar: Grammar, own: Collection[str]) -> None:
        groups = [[tuple(phrase.split()) for phrase in group.split("/")] for group in grammar.wording.sides]
        self._same = {
            phrase: [Utterance.in_one_breath(other) for other in group if other != phrase and {*other} <= {*own}]
            for group in groups
            for phrase in group
        }
        self._phrases = PhraseSet(self._same)

    def ways(self, core: Utterance) -> Iterator[Rewording]:
        """With each of the other words for one of the ways that were said."""
        at = 0
        while (found := self._phrases.find(core.words, at)) is not None:
            start, length = found
            end = start + length
            if start and not any(core.breaks[start + 1 : end]):
                for other in self._same[tuple(core.words[start:end])]:
                    yield Rewording(core.with_other(start, end, other))
            at = end
