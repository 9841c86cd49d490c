"""What was said, in other words that mean the same whatever it is about."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from functools import partial
from itertools import islice
from typing import TypeVar

from intent_engine.actions import Action
from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.idle_particles import IdleParticles
from intent_engine.language.meaning.wordings.led_amounts import LedAmounts
from intent_engine.language.meaning.wordings.merely import Merely
from intent_engine.language.meaning.wordings.named_first import NamedFirst
from intent_engine.language.meaning.wordings.nouns_with_of import NounsWithOf
from intent_engine.language.meaning.wordings.particles import Particles
from intent_engine.language.meaning.wordings.parts import part_by_part
from intent_engine.language.meaning.wordings.placed_first import PlacedFirst
from intent_engine.language.meaning.wordings.places_alone import PlacesAlone
from intent_engine.language.meaning.wordings.pointing import Pointing
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.meaning.wordings.said_first import SaidFirst
from intent_engine.language.meaning.wordings.sides import Sides
from intent_engine.language.meaning.wordings.up_to import UpTo
from intent_engine.language.meaning.wordings.verb_last import VerbLast
from intent_engine.language.meaning.wordings.verbless import Verbless
from intent_engine.language.meaning.wordings.wished_done import WishedDone
from intent_engine.language.meaning.wordings.wished_things import WishedThings
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import vocabulary
from intent_engine.language.words.opposites import opposed

__all__ = ["OtherWords"]

_One = TypeVar("_One")
_MOST_WORDS = 20
"""Words of an utterance that is put otherwise,"""
_MOST_WAYS = 32
"""ways that are tried, since a long sentence of somebody else has no end of them,"""
_MOST_PLACED = 48
"""of these with something in another place,"""
_MOST_PARTED = 4
"""and with a particle there."""


class OtherWords:
    """Reads an utterance as a grammar has it, each command by itself.

    Args:
        commands: of the grammar.
        phrases: of the grammar.
    """

    def __init__(self, commands: Commands, phrases: Phrases) -> None:
        grammar = commands.matcher.grammar
        own = vocabulary(grammar)
        self._commands = commands
        self._phrases = phrases
        self._language = grammar.language
        self._kinds: tuple[Callable[[Utterance], Iterator[Rewording]], ...] = (
            Merely(grammar, phrases).ways,
            NounsWithOf(grammar, own).ways,
            Pointing(grammar, own).ways,
            IdleParticles(grammar).ways,
            Sides(grammar, own).ways,
            UpTo(grammar).ways,
            LedAmounts(grammar, own).ways,
            PlacesAlone(grammar).ways,
        )
        self._particles = Particles(commands, phrases)
        self._placed_first = PlacedFirst(grammar, phrases)
        self._verbs_last = bool(grammar.wording.parted)
        self._verb_last = VerbLast(commands.matcher)
        self._verbless = Verbless(grammar, own)
        self._said_first = SaidFirst(grammar, phrases)
        self._named_first = NamedFirst(grammar)
        self._wished = WishedThings(grammar)
        self._wished_done = WishedDone(grammar, self._verbless)

    def told(self, said: Utterance, state: Collection[str], *, asks: bool) -> Utterance | None:
        """The utterance with its commands as the grammar has them. None: it has none of them in other words, or one
        could be two.

        Args:
            said: the words, without those that say nothing.
            state: of the robot.
            asks: whether it is written as a question, which asks whether, unless it begins with a verb or asks for a
                thing: "could I get a tea?".
        """
        if not 0 < len(said) <= _MOST_WORDS:
            return None
        verbs = self._commands.verbs
        if not asks:
            switched = self._one_of(self._verbless.ways(said, verbs), said, state)
            named_first = list(self._named_first.ways(said, verbs))
            found = switched or self._one_of(self._ways(named_first), said, state) or self._named_at_first(said, state)
            if found is None and self._said_first.leads(said):  # "for the next hour, stay there"
                found = self._one_of(self._ways([Rewording(said)]), said, state)
            if found is not None:
                return found
        return part_by_part(said, self._phrases, self._language, partial(self._otherwise, said, state, asks=asks))

    def _named_at_first(self, said: Utterance, state: Collection[str]) -> Utterance | None:
        """Several commands, of which the first has what it is about before it: "the fan, switch it on *and come here*".
        What follows is left as it is; without a verb of its own it may be of what was named first as well."""
        verbs = self._commands.verbs
        pause = next((at for at in range(1, len(said)) if said.breaks[at]), len(said))
        for end in range(pause + 2, len(said) - 1):
            joint = self._phrases.sequence.at(said.words, end)
            if (joint or said.breaks[end]) and not verbs.isdisjoint(said.words[end + joint : end + joint + 1]):
                ways = list(self._named_first.ways(first := said.part(0, end), verbs))
                found = self._one_of(self._ways(ways), first, state) if ways else None
                if found is not None:
                    return said.with_other(0, end, found)
        return None

    def _otherwise(self, said: Utterance, state: Collection[str], part: Utterance, *, asks: bool) -> Utterance | None:
        """One of the commands of what was said otherwise."""
        verbs = self._commands.verbs
        if self._commands.exact(part.words, state, breaks=part.breaks):
            return None  # what is refused in its own words is refused in others
        switched = self._one_of(self._verbless.without_verb(part), part, state)
        if switched is not None:
            return switched
        done = list(self._wished_done.ways(part, verbs, asks=asks))
        wished = [done, list(self._wished.ways(part, verbs))]
        if part.words[0] in verbs:  # "can you slew to the left?" asks for it
            # As a whole it was tried with something in another place already.
            ways = self._ways([Rewording(part)], placed=len(part) < len(said))[1:]
            found = self._one_of(ways, part, state)
            if found is not None or not any(wished):  # "get the pump switched off", of a grammar that gets things, too
                return found
        if asks:
            return self._one_of([*wished[0], *wished[1]], part, state)
        last = list(self._verb_last.ways(part, verbs))
        for ordered in [last] if last else wished:
            found = self._one_of(ordered, part, state) or self._one_of(self._ways(ordered, placed=True), part, state)
            if found is not None:
                return found
        if said.words[0] in verbs or (not self._verbs_last and len(part) == len(said)):
            return None  # "turn the fan on and the fan off", or tried already
        return self._one_of(self._verbless.ways(part, verbs), part, state)  # "lamp on and pump off"

    def _one_of(self, ways: Iterable[Rewording], part: Utterance, state: Collection[str]) -> Utterance | None:
        """The way in which it is a command, and could be no other."""
        found: dict[Action, Utterance] = {}
        ways = [*ways]
        for way in ways:
            clause = self._commands.exact(way.said.words, state, breaks=way.said.breaks)
            if clause is not None and clause.action is not None and self._is_meant(way, clause, part):
                found.setdefault(clause.action, way.said)
        if not found:
            for way in ways[:_MOST_PARTED]:  # "turn that lamp on" of a grammar that has "turn on the lamp"
                placed = self._particles.placed(way.said, state)
                clause = self._commands.exact(placed.words, state, breaks=placed.breaks) if placed is not None else None
                if clause is not None and self._is_meant(way, clause, part):
                    return placed
        return next(iter(found.values())) if len(found) == 1 else None

    def _ways(self, found: list[Rewording], *, placed: bool = False) -> list[Rewording]:
        """Ways to put one command, and these in other words of one kind, or of several at once; the former also with
        something in another place, if that is to be ``placed`` as well."""
        ways = [*found]
        for kind in self._kinds:
            for before in tuple(ways):
                ways += [before.then(way) for way in islice(kind(before.said), max(0, _MOST_WAYS - len(ways)))]
        plainest = sorted(ways[0 if placed else len(found) :], key=lambda way: len(way.said))
        moved = _in_turns([map(before.then, self._placed(before.said)) for before in plainest])
        return [*ways, *islice(moved, _MOST_PLACED)]

    def _is_meant(self, way: Rewording, clause: Clause, said: Utterance) -> bool:
        """Whether a command that was found in other words is what was said."""
        reading = clause.reading
        if reading is None or not clause.accepted or not way.is_meant(reading):
            return False
        return _keeps_free_words(said, reading) and not self._leaves_out_an_opposite(said, reading)

    def _leaves_out_an_opposite(self, said: Utterance, reading: Reading) -> bool:
        """Whether one of two opposite words was left out: "lift the tray up down" says neither."""
        left_out = {*said.words} - {*reading.words}
        return any(not left_out.isdisjoint(opposed(word, self._language)) for word in reading.words)

    def _placed(self, part: Utterance) -> Iterator[Rewording]:
        verbs = self._commands.verbs
        for way, start, end in self._placed_first.ways(part, verbs):
            yield Rewording(way, partial(self._placed_first.means, start=start, end=end))
        for way, moved in self._said_first.verb_first(part, verbs):
            yield Rewording(way, partial(self._said_first.means, moved=moved))


def _keeps_free_words(said: Utterance, reading: Reading) -> bool:
    """Whether what any words may be was said as it is read."""
    words = f" {' '.join(said.words)} "
    free = (reading.words[slot.start : slot.end] for slot in reading.slots if slot.slot.type in FREE_KINDS)
    return all(f" {' '.join(one)} " in words for one in free)


def _in_turns(several: Sequence[Iterator[_One]]) -> Iterator[_One]:
    """The first of each, then the second of each, and so on."""
    while several:
        going = []
        for one in several:
            for item in one:
                yield item
                going.append(one)
                break
        several = going
