"""Who "him" and "her" are, where a list has a name for somebody: "focus on the actor and follow *him*"."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.told import Understood, free_words_of, readings_of
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.slots.name_words import singular
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Persons", "PersonsNamed"]


class Persons:
    """Finds "him" and "her".

    Args:
        grammar: of their language.
    """

    def __init__(self, grammar: Grammar) -> None:
        known = thing_words(grammar.language)
        self.words = grammar.wording.of_persons
        self._language = grammar.language
        self._is_manner = known.is_manner
        self._follows = known.joining | known.within | known.alone | known.where | known.articles
        self._follows |= {words[0] for words in grammar.operators.sequence}

    def places(self, core: Utterance) -> list[int]:
        """Where one of them stands, again and again. Empty: none does, or more than one, or one is whose a noun is:
        "follow *her car*"."""
        places = [at for at, word in enumerate(core.words) if word in self.words]
        alike = len({core.words[at] for at in places}) == 1
        return places if alike and all(self._ends(core, at) for at in places) else []

    def _ends(self, core: Utterance, at: int) -> bool:
        """Whether no noun stands behind such a word, to which it would belong."""
        if at + 1 == len(core) or core.breaks[at + 1]:
            return True
        after = core.words[at + 1]
        return after in self._follows or is_number(after, self._language) or self._is_manner(after)


class PersonsNamed:
    """Puts in the one name that was said before such a word, in the same utterance.

    Args:
        grammar: whose lists have it.
        sequence: its words between commands.
    """

    def __init__(self, grammar: Grammar, sequence: PhraseSet) -> None:
        known = thing_words(grammar.language)
        self._persons = Persons(grammar)
        self._sequence = sequence
        self._definite, self._plurals = known.definite, known.plurals

    def put_in(self, core: Utterance, as_said: Callable[[Utterance], Understood | None]) -> Understood | None:
        """The meaning of an utterance with that name; None: there is none, or more than one that fits.

        Args:
            core: what was said.
            as_said: what an utterance means that takes its place; None: it is no command.
        """
        if not (places := self._persons.places(core)):
            return None
        ends = (end for end in range(places[0] - 1, 0, -1) if core.breaks[end] or self._sequence.at(core.words, end))
        before = next(filter(None, (as_said(core.part(0, end)) for end in ends)), None)
        found: dict[object, Understood] = {}
        for value, name in self._names(before) if before is not None else ():
            ways = (as_said(_with_name(core, places, (*article, *name))) for article in self._articles)
            way = next(filter(None, ways), None)
            if way is not None and free_words_of(way).isdisjoint(name):
                found.setdefault(value, way)
        return next(iter(found.values())) if len(found) == 1 else None

    @property
    def _articles(self) -> list[tuple[str, ...]]:
        return [(), *((word,) for word in sorted(self._definite))]

    def _names(self, before: Understood) -> Iterator[tuple[object, Sequence[str]]]:
        """The names of lists in commands, each with what it stands for. More than one thing is neither of both."""
        for reading in readings_of(before):
            for slot in (one for one in reading.slots if one.slot.type == "choice"):
                led = slot.start > 0 and reading.words[slot.start - 1] in self._definite
                if not (led and any(singular(tuple(reading.words[slot.end - 1 : slot.end]), self._plurals))):
                    yield slot.value, reading.words[slot.start : slot.end]


def _with_name(core: Utterance, places: Sequence[int], name: Sequence[str]) -> Utterance:
    for at in reversed(places):
        core = core.with_other(at, at + 1, Utterance.in_one_breath(name))
    return core
