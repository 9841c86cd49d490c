"""How often something is done in one word, where that corrects or is corrected: "knock three times, no, *twice*"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance

__all__ = ["HowOften"]


class HowOften:
    """Reads such words as a number of times, where something is corrected: the correction has to fit a number.

    Args:
        grammar: whose language has them.
        phrases: of the grammar.
    """

    def __init__(self, grammar: Grammar, phrases: Phrases) -> None:
        self._often = {word: ways[-1].split() for word, ways in grammar.wording.how_often.items()}
        self._correction = phrases.correction
        self.rule = (self.told, self.is_meant)
        """It as one of those in which numbers are written otherwise."""

    def told(self, said: Utterance, language: str) -> Utterance | None:
        """An utterance with a number in the place of each; None: there is none, or nothing is corrected."""
        if self._often.keys().isdisjoint(said.words) or self._correction.find(said.words, 1) is None:
            return None
        other = said
        for at in range(len(said) - 1, -1, -1):
            if said.words[at] in self._often:
                other = other.with_other(at, at + 1, Utterance.in_one_breath(self._often[said.words[at]]))
        return other

    def is_meant(self, said: Utterance, readings: Sequence[Reading], language: str) -> bool:
        """Whether no command has free words, of which they may be some."""
        return not any(reading.free_words for reading in readings)
