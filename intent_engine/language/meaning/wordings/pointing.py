"""Words that point to a thing, where a grammar has its article: "weigh *that* vial", "honk *your* horn"."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.meaning.wordings.rewording import Rewording
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
        known = thing_words(grammar.language)
        self._all = known.articles
        articles = known.definite or known.articles - self._pointing
        self._articles = [Utterance.in_one_breath([word]) for word in sorted(articles.intersection(own))]

    def ways(self, core: Utterance) -> Iterator[Rewording]:
        """With one article in the place of each."""
        places = [at for at, word in enumerate(core.words[:-1]) if word in self._pointing and not core.breaks[at + 1]]
        for article in (*self._articles, Utterance([], [])) if places else ():
            said = core
            for at in reversed(places):
                said = said.with_other(at, at + 1, article)
            yield Rewording(said, self._points_to_nothing_free)

    def _points_to_nothing_free(self, reading: Reading) -> bool:
        """Whether none of it stands before any words that are free: "pick your battles" is about no thing."""
        free = (slot.start for slot in reading.slots if slot.slot.type in FREE_KINDS)
        return not any({*reading.words[max(start - 1, 0) : start + 1]} & self._all for start in free)
