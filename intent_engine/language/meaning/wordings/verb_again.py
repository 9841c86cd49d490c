"""A verb that is said once of things with which different things are done: "mach die Jalousie auf und das Licht aus"
and "heat the nozzle to 210 degrees and the bed to 60 degrees" of a grammar that has a command for each. What one
command does with several things is another matter: see
:mod:`~intent_engine.language.meaning.several.shared_verb`."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.reading import Reading
from intent_engine.language.templates.template_tree import references
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["VerbAgain"]

_LEAST = 3
"""Words of what is told without its verb: "das Licht aus","""
_LEAST_WITH_ITS_ARTICLE = 2
"""and where nouns have no cases, of which a verb behind them would be said: "the lid"."""

_Means = Callable[[Sequence[Reading]], bool]


class VerbAgain:
    """Reads such an order with its verb said anew.

    Args:
        grammar: whose it is.
        phrases: of the grammar.
    """

    def __init__(self, grammar: Grammar, phrases: Phrases) -> None:
        known = thing_words(grammar.language)
        # Where nouns have cases, what something is done to is no one who does it.
        self._has_cases = bool(known.done_to)
        self._articles = known.done_to or known.definite
        self._least = _LEAST if self._has_cases else _LEAST_WITH_ITS_ARTICLE
        self._sequence = phrases.sequence
        self._besides, self._parted = grammar.wording.besides, frozenset(grammar.wording.parted)

    def ways(self, core: Utterance, verbs: Collection[str]) -> Iterator[tuple[Utterance, _Means]]:
        """The order with its verb said anew, and what tells whether readings of that are meant.

        Args:
            core: what was said, without its fillers.
            verbs: with which commands begin.
        """
        if core.words[0] not in verbs or not self._sequence.may_stand_in(core.words):
            return
        rules = ((self._said_anew, self._mean), (self._done_too, self._are_alike))
        for rule, means in rules:
            if (way := rule(core, verbs)) is not None:
                yield way, means

    def _done_too(self, core: Utterance, verbs: Collection[str]) -> Utterance | None:
        """The order with its verb, and what was parted from that, said anew of the other thing that it is done to "as
        well": "schalte die Pumpe ein und die Heizung auch". None: there is no such thing."""
        length = self._besides.ends(core.words) if self._parted else 0
        end = len(core) - length
        found = self._sequence.find(core.words, _LEAST) if length else None
        if found is None or any(core.breaks[at] for at in range(1, len(core)) if at != found[0]):
            return None
        at, thing = found[0], sum(found)
        if core.words[at - 1] not in self._parted or not thing < end or self._sequence.find(core.words, thing):
            return None
        told = [core.words[0], *core.words[thing:end], core.words[at - 1]]
        return core.with_other(thing, len(core), Utterance.in_one_breath(told))

    def _are_alike(self, readings: Sequence[Reading]) -> bool:
        """Whether these do the same with two things that are listed or numbered, and nothing more is said of one."""
        if len(readings) != 2 or any(reading.free_words for reading in readings):
            return False
        (one, said), (other, anew) = ((reading.sentence, reading.values()) for reading in readings)
        return one is other and said.keys() == anew.keys() and sum(said[key] != anew[key] for key in said) == 1

    def _said_anew(self, core: Utterance, verbs: Collection[str]) -> Utterance | None:
        """The order with its verb before each thing behind an "and" that has none; None: there is no such thing."""
        if not self._articles:
            return None
        joins = {at: self._sequence.at(core.words, at) for at in range(_LEAST, len(core) - self._least)}
        if any(pause and not joins.get(at) for at, pause in enumerate(core.breaks[1:], 1)):
            return None
        places = {at + length for at, length in joins.items() if length}  # "und dann" is one joint
        said = core
        for at in sorted(places, reverse=True):
            if len(core) - at >= self._least and core.words[at] in self._articles:
                said = said.with_other(at, at, Utterance.in_one_breath([core.words[0]]))
        return said if said.words != core.words else None

    def _mean(self, readings: Sequence[Reading]) -> bool:
        """Whether these are different commands about things that are listed: "hol die Tasse und den Teller rein". What
        the first says besides may be of the other as well, where that may have it and does not say it: "close the door
        in the hall and the window"."""
        if len(readings) < 2 or any(reading.free_words for reading in readings):
            return False
        return all(map(self._differ, readings, readings[1:]))

    def _differ(self, one: Reading, other: Reading) -> bool:
        differ = one.intent.name != other.intent.name
        if self._has_cases:
            return differ
        said, anew = one.values(), other.values()
        if other.intent.then or (anew and anew.items() <= said.items()):
            return False  # a file says itself what goes on from it; "turn the fan on and the fan off"
        may_say = {reference.label for reference in references(other.sentence.template)}
        return (differ or said.keys() != anew.keys()) and may_say.isdisjoint(said.keys() - anew.keys())
