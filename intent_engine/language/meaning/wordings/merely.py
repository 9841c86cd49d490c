"""What says no more beside so much: "go *just* two meters", "by, *say*, two meters", "for a minute *or so*"."""

from __future__ import annotations

from collections.abc import Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.amounts_read import AMOUNTS, Begins, Ends
from intent_engine.language.meaning.wordings.counted import amounts
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance

__all__ = ["Merely"]


class Merely:
    """Reads an utterance without it, in whatever pauses it was said.

    Args:
        grammar: whose language has such words.
        phrases: of the grammar.
    """

    def __init__(self, grammar: Grammar, phrases: Phrases) -> None:
        self._before = phrases.merely
        self._behind = phrases.roughly
        self._language = grammar.language

    def ways(self, core: Utterance) -> Iterator[Rewording]:
        """Without what stands before an amount, and without what stands behind one."""
        words, breaks = core.words, core.breaks
        if not (self._before.may_stand_in(words) or self._behind.may_stand_in(words)):
            return
        for amount in amounts(words, self._language):
            at, end = amount.start, amount.stop
            behind = self._behind.at(words, end)
            if any(breaks[end + 1 : end + behind]):
                behind = 0
            less = core.cut(end, end + behind)
            if behind:
                yield Rewording(less, Ends(words[at:end]))
            before = self._before.ends(words[:at])
            if 0 < before < at and not is_number(words[at - before - 1], self._language):  # "two, maybe three"
                told = Utterance(
                    [*words[: at - before], *less.words[at:]], [*breaks[: at - before], False, *less.breaks[at + 1 :]]
                )
                yield Rewording(told, Begins([words[at]], AMOUNTS, free=False))
