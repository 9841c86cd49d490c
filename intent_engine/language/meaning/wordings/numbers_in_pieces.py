"""Numbers that were not said in one breath: of "nine, uh, forty five" nobody knows which one was meant."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.numbers import foreign
from intent_engine.language.numbers.english_words import ZERO
from intent_engine.language.numbers.units import units
from intent_engine.language.quantities import evaluate
from intent_engine.language.utterance import Utterance

__all__ = ["NumbersInPieces"]

LARGE = 100
"""From here on numbers have pauses within: "two thousand, five hundred"."""
MOST_WORDS = 4
"""Of a smaller one: "quatre vingt dix neuf"."""


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
        return self._paused(core) or any(
            is_number(words[place - 1]) and is_number(words[place]) and not self._are_two(core, place, said)
            for place in core.joined
        )

    def _are_two(self, core: Utterance, place: int, said: Utterance) -> bool:
        """Whether the numbers around a place are no number together, and no thinking divides them. What joins the parts
        of a number begins none: "und, äh, zwei Meter"."""
        start, end = place, place + 1
        while start > 0 and self._is_number(core.words[start - 1]):
            start -= 1
        if all(evaluate([word], "number", self._language) is None for word in core.words[start:place]):
            return True
        if self._digits or self._hesitation.find(said.words) is not None:
            return False
        while end < len(core) and self._is_number(core.words[end]):
            end += 1
        return evaluate(core.words[start:end], "number", self._language) is None

    def in_pieces(self, said: Utterance) -> bool:
        """ "Two, oh, four meters": not 204."""
        if self._paused(said):
            return True
        return not ZERO.isdisjoint(said.words) and any(
            said.zero_between(place) and said.paused_beside(place) and self._fillers.at(said.words, place) == 1
            for place in range(1, len(said))
        )

    def _paused(self, said: Utterance) -> bool:
        """Whether a pause stands where a number would go on: "twenty, five", "quarante, cinq", "treinta, y cinco"."""
        if self._language == "en":
            return said.paused_in_number()
        pauses = (place for place in range(1, len(said)) if said.breaks[place])
        return any(_one_of_two(said.words, place, self._language) for place in pauses)


def _one_of_two(words: Sequence[str], place: int, language: str) -> bool:
    """Whether the words around a place are a number each, and one together: "quatre vingt, dix"."""
    table = units(language)
    second = place + (table is not None and words[place] in table.words.get("and", ()))
    if second == len(words) or not (foreign.number(words[second : second + 1], language) or 0.5).is_integer():
        return False
    for begin in range(place - 1, max(place - MOST_WORDS, 0) - 1, -1):
        first = foreign.number(words[begin:place], language)
        if first is None or not 0 < first < LARGE:
            break
        if foreign.number(words[begin : second + 1], language) is not None:
            return True
    return False
