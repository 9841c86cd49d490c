"""A thing that somebody wants, where a grammar tells to get or make it: "could I get a mojito?", "I'll have a beer"."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.rewording import Rewording, of_things_listed
from intent_engine.language.utterance import Utterance

__all__ = ["WishedThings"]


class WishedThings:
    """Reads it with a verb of giving, as a grammar has it."""

    def __init__(self, grammar: Grammar) -> None:
        self._wishes = grammar.wording.wishes_for
        self._takes_along = grammar.wording.takes_along
        self._gives = grammar.wording.gives
        self._for_whom = sorted(grammar.wording.for_whom)

    def ways(self, core: Utterance, verbs: Collection[str]) -> Iterator[Rewording]:
        """With each of the verbs that commands begin with, and for whom or for nobody."""
        length = self._wishes.at(core.words, 0)
        if not 0 < length < len(core) or any(core.breaks[1 : length + 1]):
            return
        along = self._takes_along.get(" ".join(core.words[:length]), frozenset())
        if not along.isdisjoint(core.words[length:]):
            return
        for verb in sorted(self._gives.intersection(verbs)):
            for told in ([verb], *([verb, whom] for whom in self._for_whom)):
                yield Rewording(core.with_other(0, length, Utterance.in_one_breath(told)), of_things_listed)
