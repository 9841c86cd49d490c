"""A verb that is said once of things with which different things are done: "mach die Jalousie auf und das Licht aus" of
a grammar that has a command for each. What one command does with several things is another matter: see
:mod:`~intent_engine.language.meaning.several.shared_verb`."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import pairwise

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["VerbAgain"]

_LEAST = 3
"""Words of what is told without its verb: "das Licht aus"."""


class VerbAgain:
    """Reads such an order with its verb said anew.

    Args:
        grammar: whose it is.
        phrases: of the grammar.
    """

    def __init__(self, grammar: Grammar, phrases: Phrases) -> None:
        # Where nouns have cases, what something is done to is no one who does it.
        self._articles = thing_words(grammar.language).done_to
        self._sequence = phrases.sequence

    def said_anew(self, core: Utterance, verbs: Collection[str]) -> Utterance | None:
        """The order with its verb before each thing behind an "and" that has none; None: there is no such thing.

        Args:
            core: what was said, without its fillers.
            verbs: with which commands begin.
        """
        if not self._articles or core.words[0] not in verbs or not self._sequence.may_stand_in(core.words):
            return None
        if any(core.breaks[1:]):
            return None
        joins = {at: self._sequence.at(core.words, at) for at in range(_LEAST, len(core) - _LEAST)}
        places = {at + length for at, length in joins.items() if length}  # "und dann" is one joint
        said = core
        for at in sorted(places, reverse=True):
            if len(core) - at >= _LEAST and core.words[at] in self._articles:
                said = said.with_other(at, at, Utterance.in_one_breath([core.words[0]]))
        return said if said.words != core.words else None

    def means(self, readings: Sequence[Reading]) -> bool:
        """Whether these are different commands about things that are listed: "hol die Tasse und den Teller rein"."""
        differ = all(one.intent.name != other.intent.name for one, other in pairwise(readings))
        return len(readings) > 1 and differ and not any(reading.free_words for reading in readings)
