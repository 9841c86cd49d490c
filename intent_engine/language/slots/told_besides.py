"""Words behind a pause that tell of something, and are no part of the name of a thing before them: "the cup, *you're
nice*", "la tasse, *ça brûle*"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.words.contractions import begins_to_tell
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["ToldBesides"]


class ToldBesides:
    """Tells such words by those with which they begin.

    Args:
        grammar: whose language has them.
    """

    def __init__(self, grammar: Grammar) -> None:
        wording = grammar.wording
        self._english = grammar.language == "en"
        self._tells = PhraseSet((*wording.tells_alone, *wording.tells_of, *wording.tells_of_it))
        self._why = wording.why_apart
        self._who, self._fully = wording.tells_who, wording.tells_fully

    def begins(self, words: Sequence[str]) -> bool:
        """Whether some words, of which there is one at least, are such."""
        if self._english:
            return begins_to_tell(words[0])
        begin = self._why.at(words, 0)
        verb = begin + (words[begin : begin + 1] != [] and words[begin] in self._who)
        return self._tells.at(words, begin) > 0 or (verb > 0 and not self._fully.isdisjoint(words[verb : verb + 1]))
