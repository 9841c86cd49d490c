""" "There" for the place of the command before: "go to the archive and fetch the boxes *from there*", "go to the
bin and drop the tip *there*"."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from intent_engine.actions import Custom, Navigate
from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.told import Understood, readings_of, told_before
from intent_engine.language.reading import SlotReading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["PlacesThere"]

_PLACES = ("location", "choice")
_LEAST = 2
"""Commands of which the last is done where the one before it went."""


class PlacesThere:
    """Puts the one place that the command before has in its stead.

    Args:
        grammar: whose language has such words behind a preposition.
        sequence: its words between commands.
    """

    def __init__(self, grammar: Grammar, sequence: PhraseSet) -> None:
        self._there = grammar.wording.there
        known = thing_words(grammar.language)
        articles, self._joining = known.definite, known.joining
        self._articles: Sequence[tuple[str, ...]] = [(), *((article,) for article in sorted(articles))]
        self._sequence = sequence
        self._at_last, self._to = grammar.wording.there_at_last, grammar.wording.ways_to

    def put_in(self, core: Utterance, as_said: Callable[[Utterance], Understood | None]) -> Understood | None:
        """The meaning of an utterance with that place; None: there is none, or more than one.

        Args:
            core: what was said.
            as_said: what an utterance means that takes its place; None: it is no command.
        """
        found = self._there.find(core.words)
        if found is None and (length := self._at_last.ends(core.words)):
            return self._done_there(core, len(core) - length, as_said)
        if found is None or self._there.find(core.words, sum(found)) is not None:
            return None
        at, end = sum(found) - 1, sum(found)
        if end < len(core) and not (core.breaks[end] or self._sequence.at(core.words, end)):
            return None  # "from there on"
        before = told_before(core, found[0], self._sequence, as_said)
        named = _places_of(before)
        if not named or len(named[-1]) != 1:
            return None
        (place,), words = named[-1], readings_of(before)[-1].words
        name = words[place.start : place.end]
        for article in self._articles:
            meant = as_said(core.with_other(at, end, Utterance.in_one_breath([*article, *name])))
            if meant is not None:
                later = (one for places in _places_of(meant)[len(named) :] for one in places)
                return meant if any(one.value == place.value for one in later) else None
        return None

    def _done_there(
        self, core: Utterance, end: int, as_said: Callable[[Utterance], Understood | None]
    ) -> Understood | None:
        """The meaning of an utterance without a "there" at its end, behind a command that names none, if the one before
        it goes to a place."""
        if end < _LEAST or core.breaks[end]:
            return None
        if (meant := as_said(core.part(0, end))) is None:
            return None
        readings, actions = readings_of(meant), meant[0].actions
        if not _LEAST <= len(readings) == len(actions) or readings[-1].free_words:
            return None
        went, done = readings[-2:]
        if any(not self._joining.isdisjoint(done.words[: slot.start][-2:]) for slot in done.slots):
            return None
        to = (place for place in _places_of(meant)[-2] if not self._to.isdisjoint(went.words[: place.start][-2:]))
        return meant if isinstance(actions[-2], Navigate | Custom) and any(to) else None


def _places_of(understood: Understood | None) -> list[list[SlotReading]]:
    """The places that each command names."""
    return [[slot for slot in one.slots if slot.slot.type in _PLACES] for one in readings_of(understood)]
