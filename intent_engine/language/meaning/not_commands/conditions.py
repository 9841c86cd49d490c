"""Fillers that are a condition where a clause goes on from them: "if you can, turn left" is polite, "if you can turn
left, go forward" asks for nothing yet.
"""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["Conditions"]


class Conditions:
    """Those of one grammar: its fillers that begin like a clause ("if") and end where a verb follows. Thread-safe."""

    def __init__(self, phrases: Phrases, grammar: Grammar) -> None:
        closed, verb_follows = grammar.operators.closed, grammar.wording.verb_follows
        self._phrases = phrases
        self._clauses = PhraseSet(
            words for words in grammar.fillers if len(words) > 1 and words[0] in closed and words[-1] in verb_follows
        )
        self._apart_only = PhraseSet(grammar.wording.fillers_apart)
        self._adds = grammar.wording.adds

    def may_stand_in(self, words: Sequence[str]) -> bool:
        """A quick look: whether any could begin in these words."""
        return self._clauses.may_stand_in(words) or self._apart_only.may_stand_in(words)

    def within(self, said: Utterance, parts: Sequence[Clause]) -> str:
        """The words with which a condition begins; empty: there is none.

        One stands where no pause nor joint follows such a filler, but "not", or a clause beside another one: "if you
        could go to the kitchen and turn left" is a single clause, and so asks for both. Of a filler that no file lists,
        anything that goes on from it in one breath may be what is asked of: "if you can ring".

        Args:
            said: all words, with the fillers.
            parts: the commands that were understood.
        """
        words = said.words
        for place in range(len(words)):
            apart = self._apart_only.at(words, place)
            if apart and self._goes_on(said, place + apart):
                return " ".join(words[place : place + apart])
            length = self._clauses.at(words, place)
            if length and self._goes_on(said, place + length):
                negated = self._phrases.negation.at(words, place + length) > 0
                if negated or self._apart(self._phrases.without_fillers(said).words, parts):
                    return " ".join(words[place : place + length])
        return ""

    def _goes_on(self, said: Utterance, after: int) -> bool:
        """Whether a clause goes on at a place, or behind the fillers there."""
        while after < len(said) and not said.breaks[after]:
            if not (length := self._phrases.fillers.at(said.words, after)):
                return self._phrases.sequence.at(said.words, after) == 0
            after += length
        return False

    def _apart(self, words: Sequence[str], parts: Sequence[Clause]) -> bool:
        """Whether some of several commands are clauses of their own, and not joined to the one before by "and". So
        is one that is not found as it was understood."""
        end = len(words)
        for part in reversed(parts[1:]):
            own = list(part.reading.words) if part.reading is not None else []
            at = next((at for at in range(end - len(own), 0, -1) if words[at : at + len(own)] == own), 0)
            joint = self._phrases.sequence.ends(words[:at]) if own else 0
            if not joint or words[at - joint] not in self._adds:
                return True
            end = at - joint
        return False
