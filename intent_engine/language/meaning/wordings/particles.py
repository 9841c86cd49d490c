"""What belongs to a verb, straight behind it or behind what is done: "turn on the lamp", "turn the lamp on"."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import chain

from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Particles"]


class Particles:
    """Reads an utterance with the particles of its verbs where a grammar has them.

    Args:
        commands: of the grammar.
        phrases: of the grammar.
    """

    def __init__(self, commands: Commands, phrases: Phrases) -> None:
        grammar = commands.matcher.grammar
        self._particles = grammar.wording.particles
        self._articles = thing_words(grammar.language).articles
        self._commands = commands
        besides = grammar.wording.besides
        self._ends = (phrases.sequence, phrases.correction, phrases.contrast, phrases.negation, besides)

    def placed(self, core: Utterance, state: Collection[str]) -> Utterance | None:
        """The same utterance with each of its commands as the grammar has it; None: it has them so, or has none.

        Args:
            core: what was said, without its fillers.
            state: of the robot.
        """
        if self._particles.keys().isdisjoint(core.words):
            return None
        core = self._with_shared_verb(core, state)
        said = core
        for start, end in self._clauses(core):
            clause = said.part(start, end)
            if self._particles.get(clause.words[0], frozenset()).isdisjoint(clause.words[1:]):
                continue
            if not self._commands.accepts(clause.words, state) and (other := self._placed(clause, state)):
                said = said.with_other(start, end, other)
        return said if said is not core else None

    def _with_shared_verb(self, core: Utterance, state: Collection[str]) -> Utterance:
        """ "Turn the fan on and the pump off" with its verb said twice, where a grammar has the particles elsewhere."""
        said = core
        for start, end in reversed(list(self._clauses(core))):
            verb, begin = core.words[start], end + self._ends[0].at(core.words, end)
            own = self._particles[verb]
            listed = start + 2 < end < len(core) and core.words[start + 1] in own
            if listed and self._is_placed(core.part(start, end), state):
                said = self._of_each(core, said, start, end, state)
                continue
            if begin == end or core.words[end - 1] not in own or core.words[begin : begin + 1] == [verb]:
                continue
            stop = next((at + 1 for at in range(begin, len(core)) if core.words[at] in own), begin)
            other = core.part(begin, stop).words
            if (
                other[:1]
                and other[0] in self._articles
                and self._placed(Utterance.in_one_breath([verb, *other]), state)
            ):
                said = said.with_other(begin, stop, Utterance.in_one_breath([verb, *other]))
        return said

    def _of_each(self, core: Utterance, said: Utterance, start: int, end: int, state: Collection[str]) -> Utterance:
        """ "Switch off the fan and the pump" with the verb and its particle before each thing of the list that follows
        a command. Where they are in their place in the grammar, its verb may be shared as it is."""
        words, places = core.words, list[int]()
        begun = words[start : start + 2]
        while end < len(core):
            begin = end + self._ends[0].at(words, end)
            if begin >= len(core) or words[begin] not in self._articles:
                break
            later = range(begin + 1, len(core))
            end = next((at for at in later if core.breaks[at] or self._ends[0].at(words, at)), len(core))
            if not self._is_placed(Utterance.in_one_breath([*begun, *words[begin:end]]), state):
                return said
            places.append(begin)
        for place in reversed(places):
            said = said.with_other(place, place, Utterance.in_one_breath(begun))
        return said

    def _is_placed(self, clause: Utterance, state: Collection[str]) -> bool:
        """Whether a command with its particle straight behind its verb is one with it elsewhere."""
        return not self._commands.accepts(clause.words, state) and self._placed(clause, state) is not None

    def _clauses(self, core: Utterance) -> Iterator[tuple[int, int]]:
        """Where commands with such a verb begin, and where they end: at a pause or what joins or corrects."""
        words, verbs = core.words, self._particles.keys() & self._commands.first_words
        for start in (place for place, word in enumerate(words) if word in verbs):
            places = range(start + 1, len(words))
            ends = (at for at in places if core.breaks[at] or any(end.at(words, at) for end in self._ends))
            yield start, next(ends, len(words))

    def _placed(self, clause: Utterance, state: Collection[str]) -> Utterance | None:
        """One command with its particle elsewhere; None: it is none so, or could be two."""
        found: dict[object, Utterance] = {}
        for other, place in chain(self._brought_back(clause), self._parted(clause)):
            told = self._commands.exact(other.words, state, breaks=other.breaks)
            if told is not None and told.accepted and _means(told, place):
                found.setdefault(told.action, other)
        return next(iter(found.values())) if len(found) == 1 else None

    def _brought_back(self, clause: Utterance) -> Iterator[tuple[Utterance, int]]:
        """A command with the particle straight behind its verb, and where it stood. Before an article it is a
        preposition: "turn the lamp on the table"."""
        words = clause.words
        own = self._particles[words[0]]
        if words[1] in own:
            return
        for at in range(2, len(words)):
            if words[at] in own and (at + 1 == len(words) or words[at + 1] not in self._articles):
                yield Utterance.in_one_breath([words[0], words[at], *words[1:at], *words[at + 1 :]]), at + 1

    def _parted(self, clause: Utterance) -> Iterator[tuple[Utterance, int]]:
        """A command with the particle farther behind, and 0: no free words stand between, which may say where something
        is done ("turn down the road")."""
        words = clause.words
        if words[1] not in self._particles[words[0]]:
            return
        for at in range(3, len(words) + 1):
            yield Utterance.in_one_breath([words[0], *words[2:at], words[1], *words[at:]]), 0


def _means(told: Clause, place: int) -> bool:
    """Whether free words of a command end where its particle stood, and do not begin with it, or there are none."""
    reading: Reading | None = told.reading
    if reading is None:
        return False
    free = [slot for slot in reading.slots if slot.slot.type in FREE_KINDS]
    if not place:
        return not free
    return all(slot.start > 1 and (slot.end <= place or slot.start >= place) for slot in free)
