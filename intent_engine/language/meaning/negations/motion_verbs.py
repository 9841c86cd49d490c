"""The verbs of a grammar with which somebody forbids a robot to go on moving: "don't turn"."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from intent_engine.language.grammar import MOTIONS, Grammar
from intent_engine.language.templates.template_tree import first_words

__all__ = ["MotionVerbs"]


class MotionVerbs:
    """Those with which the motions of one grammar begin."""

    def __init__(self, grammar: Grammar) -> None:
        self._grammar = grammar

    def begin(self, words: Sequence[str]) -> bool:
        """Whether words begin like a motion and like nothing else ("turn to"), where they are more than its verb:
        "don't turn" forbids to turn, also where "turn on the lamp" is none."""
        if not words or words[0] not in self._of_motions:
            return False
        return len(words) == 1 or words[0] not in self._of_others

    @cached_property
    def _of_motions(self) -> frozenset[str]:
        return self._first_words(motions=True)

    @cached_property
    def _of_others(self) -> frozenset[str]:
        return self._first_words(motions=False)

    def _first_words(self, *, motions: bool) -> frozenset[str]:
        some = (one for one in self._grammar.intents.values() if (one.action.type in MOTIONS) == motions)
        sentences = (sentence for intent in some for sentence in intent.sentences)
        return frozenset[str]().union(
            *(first_words(sentence.template, self._grammar.phrases)[0] for sentence in sentences)
        )
