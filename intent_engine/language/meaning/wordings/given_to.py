"""Whom or what something is given to, before what is given: "give hive 8 two liters", where a grammar has "give two
liters to hive 8"."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from intent_engine.language.meaning.command import Commands
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.quantities import evaluate
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import vocabulary
from intent_engine.language.words.thing_words import thing_words

__all__ = ["GivenTo"]

_Rule = tuple[Callable[[Utterance, str], Utterance | None], Callable[[Utterance, Sequence[Reading], str], bool]]
_MOST = 4
"""Words of whom it is given to,"""
_MOST_GIVEN = 8
"""and of what is given."""


class GivenTo:
    """Reads it with whom it is given to behind what is given.

    Args:
        commands: of the grammar, whose language has verbs of giving.
    """

    def __init__(self, commands: Commands) -> None:
        grammar = commands.matcher.grammar
        self._gives = grammar.wording.gives
        self._to = next(iter(sorted(grammar.wording.ways_to)), "")
        known = thing_words(grammar.language)
        self._articles, self._no_names = known.articles, known.alone | known.joining
        places = (words for words, _ in commands.matcher.locations.names()) if commands.matcher.locations else ()
        own = vocabulary(grammar).union(*places)
        self._own = own if self._to in own else frozenset[str]()
        self.rules: tuple[_Rule, ...] = tuple(
            (partial(self._told, length), partial(self._is_meant, length)) for length in range(1, _MOST + 1)
        )
        """It as some of those in which words are written otherwise, one for each length of whom it is given to."""

    def _told(self, length: int, said: Utterance, language: str) -> Utterance | None:
        """The utterance with so many words behind its verb moved to its end; None: they are nobody, or it is not clear
        where they end: "give hive twenty four liters"."""
        verb, whom, given = said.words[:1], said.words[1 : 1 + length], said.words[1 + length :]
        if (
            not 2 <= len(given) <= _MOST_GIVEN
            or verb[0] not in self._gives
            or any(said.breaks[1:])
            or self._to in said.words
        ):
            return None
        if not (given[0] in self._articles or is_number(given[0], language)) or not self._names(whom, language):
            return None
        numbers = said.words[length : length + 2]
        counted = all(is_number(word, language) for word in numbers)
        if counted and evaluate(in_words(numbers), "number", language) is not None:
            return None
        return Utterance.in_one_breath([*verb, *given, self._to, *whom])

    def _is_meant(self, length: int, said: Utterance, readings: Sequence[Reading], language: str) -> bool:
        """Whether the words that were moved name one thing and no more, and what is given is no free words."""
        for reading in readings:
            begin = len(reading.words) - length
            behind = [slot for slot in reading.slots if slot.end > begin]
            if len(behind) != 1 or behind[0].start < begin or reading.free_words or behind[0].status != "exact":
                return False
        return len(readings) == 1

    def _names(self, whom: Sequence[str], language: str) -> bool:
        bare = [word for word in whom if word not in self._articles]
        if not self._no_names.isdisjoint(bare):
            return False  # "pick up the cup"
        return bool(bare) and all(word in self._own or is_number(word, language) for word in bare)
