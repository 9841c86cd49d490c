"""Numbers that were not said in one breath: of "nine, uh, forty five" nobody knows which one was meant."""

from __future__ import annotations

from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.numbers.english_words import ZERO
from intent_engine.language.quantities import evaluate
from intent_engine.language.utterance import Utterance

__all__ = ["NumbersInPieces"]


class NumbersInPieces:
    """Whether a number of an utterance was said in pieces, which together are another."""

    def __init__(self, phrases: Phrases, matcher: Matcher) -> None:
        self._fillers = phrases.fillers
        self._is_number = matcher.is_number
        self._hesitation = phrases.hesitation
        self._digits = any(slot.digits for slot in matcher.grammar.slots.values())
        self._language = matcher.grammar.language

    @step(Kind.NUMBERS)
    def restarted(self, core: Utterance, said: Utterance) -> bool:
        """ "nine, uh, forty five degrees": two numbers, not 945. Which one was meant nobody can know. But of "Tisch
        sieben bitte zwei Meter" it is known: nobody thinks what to say there, and the two are no number together.

        Args:
            core: what was said without its fillers.
            said: with them.
        """
        words, is_number = core.words, self._is_number
        return core.paused_in_number() or any(
            is_number(words[place - 1]) and is_number(words[place]) and not self._are_two(core, place, said)
            for place in core.joined
        )

    def _are_two(self, core: Utterance, place: int, said: Utterance) -> bool:
        """Whether the numbers around a place are no number together, and no thinking divides them."""
        if self._digits or self._hesitation.find(said.words) is not None:
            return False
        start, end = place, place + 1
        while start > 0 and self._is_number(core.words[start - 1]):
            start -= 1
        while end < len(core) and self._is_number(core.words[end]):
            end += 1
        return evaluate(core.words[start:end], "number", self._language) is None

    def in_pieces(self, said: Utterance) -> bool:
        """ "Two, oh, four meters": not 204."""
        if said.paused_in_number():
            return True
        return not ZERO.isdisjoint(said.words) and any(
            said.zero_between(place) and said.paused_beside(place) and self._fillers.at(said.words, place) == 1
            for place in range(1, len(said))
        )
