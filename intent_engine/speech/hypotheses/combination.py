"""What two models heard in the same sound, as one.

Two models that hear the same are seldom both wrong: what both think of a sentence, in the mean, becomes one confidence.
In the words of speech recognition this is a combination of systems, here over the sentences of a grammar.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from intent_engine.interpretation import Interpretation
from intent_engine.language.networks.approximate import FreeWord
from intent_engine.speech.hypotheses.clearness import RIVAL_MARGIN
from intent_engine.speech.hypotheses.dictating import DICTATED, as_heard, dictated_to_both, hardly_begun
from intent_engine.speech.hypotheses.evidence import letters_apart
from intent_engine.speech.hypotheses.forbidding import said_otherwise
from intent_engine.speech.hypotheses.opinion import Opinion, Reading, as_read
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.hypotheses.weighing import Each, begun_otherwise, beside_heard, crossed, doubted, opposed_too
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import SURE_ENOUGH

__all__ = ["AGREED", "Combination"]

AGREED = 0.95
"""Confidence in what both heard word by word, where a slot takes any words."""


class Combination:
    """Weighs what two models think.

    Args:
        grammar: of what may be said.
        each: asks two models the same, and gives both answers in their order.
    """

    def __init__(self, grammar: SpokenGrammar, each: Each) -> None:
        self._grammar = grammar
        self._each = each

    def weighed(self, first: Opinion, second: Opinion, *, far: bool = False) -> tuple[Transcript, float]:
        """What two models heard in the same sound, as one; and the letters by which it differs from the words that the
        nearer of them heard.

        Where one heard that something shall not be done, nothing shall; if that was for the robot.
        """
        heard = first.transcript
        for one in (first, second):
            if self._addressed(one) and self._meaning(one.transcript).refuses and self._heard_to_be_refused(one):
                return one.transcript, 0.0
        if (dictated := dictated_to_both(first, second, AGREED)) is not None:
            words = (*first.dictated, DICTATED)
            clear = self._each(lambda one: one.clearness(words), (first, second))
            return replace(dictated, unclear=_unclear(*clear)), 0.0
        if (agreed := self._agreed(first, second)) is not None:
            return agreed, 0.0
        readings = self.joint(first, second, far=far)
        if not readings:
            return heard, math.inf
        best = readings[0]
        unclear: tuple[str, ...] = ()
        left_out: tuple[str, ...] = ()
        if self._grammar.acted_on(best.evidence.confidence, heard.language):
            otherwise = said_otherwise(self._grammar, [one.words for one in readings], heard.language)
            clear = self._each(lambda one: one.clearness(best.words, otherwise), (first, second))
            unclear = (*_unclear(*clear), *self._unheard(best, first, second))
            unclear += hardly_begun(best.words, (first, second))
            said = beside_heard(self._grammar, best.words, (first, second))
            unclear += said.begins_unheard() + said.unheard_inside() + said.either_heard()
            left_out = said.left_out() or said.left_open() or said.opposite() or said.passed_over()
            left_out = left_out or said.letter_otherwise() or said.begun_otherwise()
            left_out = left_out or said.heard_otherwise(best.evidence.confidence)
        both = as_read((first, second), readings, unclear=unclear, left_out=left_out)
        if best.evidence.confidence < SURE_ENOUGH and self._meaning(both).stops:
            # From less the first alone is believed, but not two: "wow" is "whoa" to both.
            return heard, math.inf
        return both, min(letters_apart(as_heard(best.words, one.heard), one.heard) for one in (first, second))

    def _addressed(self, one: Opinion) -> bool:
        """Whether what a model heard is for the robot."""
        language = one.transcript.language
        return self._grammar.wake(language).addressed(self._grammar.words(one.transcript.text, language))

    def _heard_to_be_refused(self, one: Opinion) -> bool:
        """Whether a model heard a word with which nothing is done, or all that it heard is refused; and did not only
        take "a hundred percent" for "never", which is for both to weigh."""
        language = one.transcript.language
        return (
            self._grammar.negated(one.heard, language)
            or self._grammar.parse(one.transcript.free_text, language).refuses
        )

    def _agreed(self, first: Opinion, second: Opinion) -> Transcript | None:
        """What both heard word by word, where a slot without a list takes just that: nothing in the grammar can be for
        or against "call Jessica". Numbers and a "don't" must have been clear in it, as ever."""
        words, heard = tuple(first.heard), first.transcript
        if words != tuple(second.heard) or not self._grammar.takes_as_heard(words, heard.language):
            return None
        clear = self._each(lambda one: one.clearness(words), (first, second))
        said = " ".join(words)
        return replace(
            heard, text=said, gap=0.0, alternatives=(), behind=(), unclear=_unclear(*clear), confidence=AGREED
        )

    def _unheard(self, best: Reading, *opinions: Opinion) -> list[str]:
        """Words in free slots that no list has and that not all heard: nothing else tells that they were said. None of
        a stop, which waits for nothing."""
        meaning = self._grammar.parse(" ".join(best.words), opinions[0].transcript.language)
        heard = [one.heard for one in opinions]
        unlisted = [] if meaning.stops else self._grammar.unlisted(meaning, opinions[0].transcript.language)
        return [word for word in unlisted if not all(word in one for one in heard)]

    def joint(self, first: Opinion, second: Opinion, *, far: bool = False) -> list[Reading]:
        """The sentences that one of two models thought of, or that are beside the likeliest of these, with what both
        think of them, likeliest first; ``far`` as for :func:`~intent_engine.speech.hypotheses.weighing.doubted`."""
        opinions = (first, second)
        readings = doubted(self._grammar, opinions, self._each, far=far)
        if not far:
            return readings
        readings = begun_otherwise(self._grammar, readings, opinions, self._each)
        readings = crossed(self._grammar, readings, opinions, self._each)
        return opposed_too(self._grammar, readings, opinions, self._each)

    def _meaning(self, heard: Transcript) -> Interpretation:
        return self._grammar.parse(heard.text, heard.language)


def _unclear(one: Mapping[str, float], other: Mapping[str, float]) -> tuple[str, ...]:
    """Words that two models together did not hear clearly.

    A word that no list has must be clear in the mean. Of a number that sounds like another, and of a beginning that may
    have been a "don't", what both have heard adds up, if neither would rather have heard the other.
    """

    def clear(word: str) -> bool:
        both = (one[word], other.get(word, one[word]))
        if isinstance(word, FreeWord):
            return sum(both) >= 0
        return min(both) >= -RIVAL_MARGIN and sum(both) >= -RIVAL_MARGIN

    return tuple(word for word in one if not clear(word))
