"""What says no more beside so much: "go *just* two meters", "by, *say*, two meters", "for a minute *or so*"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.amounts_read import AMOUNTS, Begins, Ends
from intent_engine.language.meaning.wordings.counted import amounts
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance

__all__ = ["Merely", "said_before"]


class Merely:
    """Reads an utterance without it, in whatever pauses it was said.

    Args:
        grammar: whose language has such words.
        phrases: of the grammar.
    """

    def __init__(self, grammar: Grammar, phrases: Phrases) -> None:
        self._behind = phrases.roughly
        self._phrases = phrases
        self._language = grammar.language

    def ways(self, core: Utterance) -> Iterator[Rewording]:
        """Without what stands before an amount, and without what stands behind one."""
        words, breaks = core.words, core.breaks
        if not (self._phrases.merely.may_stand_in(words) or self._behind.may_stand_in(words)):
            return
        for amount in amounts(words, self._language):
            at, end = amount.start, amount.stop
            behind = self._behind.at(words, end)
            if any(breaks[end + 1 : end + behind]):
                behind = 0
            less = core.cut(end, end + behind)
            if behind:
                yield Rewording(less, Ends(words[at:end]))
            for start, before in said_before(words, at, self._phrases):
                left = start - before
                if is_number(words[left - 1], self._language):
                    continue  # "two, maybe three"
                pauses = [*breaks[:left], False, *less.breaks[start + 1 :]]
                told = Utterance([*words[:left], *less.words[start:]], pauses)
                yield Rewording(told, Begins([words[at]], AMOUNTS, free=False))


def said_before(words: Sequence[str], at: int, phrases: Phrases) -> Iterator[tuple[int, int]]:
    """Before which place near an amount what says no more stands, and how many words it has: before the amount, or
    before what leads it, "disons *de* deux mètres"."""
    led = at > 0 and words[at - 1] in phrases.led_by
    for start in (at, at - 1) if led else (at,):
        if 0 < (before := phrases.merely.ends(words[:start])) < start:
            yield start, before
