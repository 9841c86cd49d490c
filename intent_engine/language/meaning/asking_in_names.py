"""Fillers that ask for a command, where a name of any words begins: "say could you help me" says no "help me"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from intent_engine.language.free_text import FREE_KINDS
from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.command import Clause
from intent_engine.language.utterance import PhraseSet, Utterance

__all__ = ["AskingInNames"]

_ASKING: Mapping[str, frozenset[str]] = {
    "en": frozenset(("can you", "could you", "will you", "would you", "can you please", "could you please",
                     "will you please", "would you please", "would you mind"))
}  # fmt: skip
"""They stand before a command, or behind it."""


class AskingInNames:
    """Those of one grammar. Thread-safe."""

    def __init__(self, grammar: Grammar) -> None:
        asking = _ASKING.get(grammar.language, frozenset())
        self._asking = PhraseSet(words for words in grammar.fillers if " ".join(words) in asking)

    def may_stand_in(self, words: Sequence[str]) -> bool:
        """A quick look: whether any could begin in these words."""
        return self._asking.may_stand_in(words)

    def within(self, said: Utterance, parts: Sequence[Clause]) -> str:
        """One that stands, in one breath, where free words of a command begin, and so may be theirs. Empty: none does.

        Args:
            said: all words, with the fillers.
            parts: the commands that were understood.
        """
        words = said.words
        for part in parts if self.may_stand_in(words) else ():
            reading = part.reading
            for slot in reading.slots if reading is not None else ():
                if slot.slot.type not in FREE_KINDS or slot.slot.known or slot.start == 0:
                    continue
                assert reading is not None
                before, first = reading.words[slot.start - 1], reading.words[slot.start]
                for place in range(1, len(words)):
                    end = place + self._asking.at(words, place)
                    here = end > place and words[place - 1] == before and words[end : end + 1] == [first]
                    if here and not said.breaks[place] and not said.breaks[end]:
                        return " ".join(words[place:end])
        return ""
