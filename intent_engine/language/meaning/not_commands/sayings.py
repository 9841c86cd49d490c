"""Sayings about an "it" that is no thing: "take it from the top", "put it in perspective"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Sayings"]


class Sayings:
    """Those of one language, where a grammar would take their "it" for a thing. Thread-safe."""

    def __init__(self, phrases: Phrases, grammar: Grammar) -> None:
        self._phrases = phrases
        self._sayings = PhraseSet(tuple(one.split()) for one in thing_words(grammar.language).sayings)
        self._pronouns = PhraseSet(grammar.operators.pronoun)

    def within(self, said: Utterance, parts: Sequence[Clause]) -> str:
        """The saying for which a command was taken that has free words for "it"; empty: none was.

        It ends what is said, but for fillers and other commands: "take it from the top of the shelf" takes a thing. A
        grammar with a sentence "play it from the top" means that.
        """
        words = said.words
        free = (name for part in parts for name in part.free_names)
        if not self._sayings.may_stand_in(words) or not any(map(self._pronouns.cover, free)):
            return ""
        for place in range(len(words)):
            if (length := self._sayings.at(words, place)) and self._ends(said, place + length):
                return " ".join(words[place : place + length])
        return ""

    def _ends(self, said: Utterance, end: int) -> bool:
        """Whether a command may end at a place."""
        words, phrases = said.words, self._phrases
        if end == len(words) or said.breaks[end]:
            return True
        return phrases.fillers.at(words, end) > 0 or phrases.sequence.at(words, end) > 0
