"""What "it", "them" and "that one" stand for: something that was named before them.

Free words hold a pronoun as they hold any name, so it is put in when their action is known: what was named *last*, in
the same utterance or the one before. One for several is refused where more than one thing was named, and so is one for
what may be a place that was named later, in the same utterance, unless the thing is held. A slot that lists
its names, or has them from a map, holds no pronoun: there the name is put in before the utterance is understood, the
*only one* that fits of those that were said in it; where none or several fit, it is no command. So is the name of a
thing that sentences themselves have, "the lid". Such a pronoun is one for one thing, and before a noun no article
("that", "das"); a whole command stands before it.

So there are two ways to put one in. By its text alone "look at the cup, take the ball and drop it" would have two
things that fit, and the utterance before, which is known by its actions, none; by its value alone "photograph it" would
be no sentence whose value could be known.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice

from intent_engine.actions import Action, Custom, Navigate, Pick, Place
from intent_engine.language.context.answers import with_name
from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.loading.language_words import default_another
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.told import Understood
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.slots.name_words import singular
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["NameSaid", "NamesListed", "ThingsNamed", "names_something", "things_of"]

_LISTED = ("choice", "location")
_TELLING = (*_LISTED, "number", "ordinal")
"""What may be said within the name of a thing, to tell which."""
_MOST_WORDS = 3
"""Of the name of a thing that a sentence has, without its article."""


class ThingsNamed:
    """The things that free words named so far.

    Args:
        grammar: whose pronouns are put in.
        done: what the utterance before does.
    """

    def __init__(self, grammar: Grammar, done: Iterable[Action]) -> None:
        self._pronouns = {" ".join(words) for words in grammar.operators.pronoun}
        self._things = things_of(grammar)
        self._several = grammar.wording.several
        self._language, known = grammar.language, thing_words(grammar.language)
        self._qualities, self._stand_ins = known.qualities, grammar.wording.standing_for
        self._bound = known.joining | known.binding | known.within
        self._named: list[str] = []
        self._held = False
        for action in done:
            self.add(action)
        self._place = ""  # of the utterance before "it" is none: what it says is put in by its text

    def add(self, action: Action) -> None:
        """An action that is done next, after :meth:`put_in`."""
        thing = next(filter(None, _named(action, self._things).values()), None)
        if isinstance(thing, str) and thing not in self._pronouns:
            self._named.append(thing)
            self._held, self._place = isinstance(action, Pick), ""
        elif isinstance(action, Navigate):
            self._place = action.location

    def put_in(self, action: Action) -> Action | str:
        """An action with the thing that it points back to, or why it is not clear which; the same object if it points
        to none."""
        said = _named(action, self._things) if self._named else {}
        pointing = [key for key, value in said.items() if value in self._pronouns]
        if not pointing:
            full = {key: self._with_noun(value) for key, value in said.items() if isinstance(value, str)}
            return action if all(said[key] == value for key, value in full.items()) else _naming(action, full)
        if len(named := dict.fromkeys(self._named)) > 1 and not self._several.isdisjoint(said.values()):
            return f"more than one thing was named: {', '.join(named)}; say what to do with each"
        if self._place and not self._held and isinstance(action, Custom) and self._several.isdisjoint(said.values()):
            return f"it may be the {self._place} or the {self._named[-1]}; say which"
        return _naming(action, dict.fromkeys(pointing, self._named[-1]))

    def denied(self, action: Action) -> Iterator[Action]:
        """What shall not be done, with each thing that it may point back to: of "don't take it" nobody waits to hear
        which. The action itself, if it points to none."""
        said = _named(action, self._things)
        pointing = [key for key, value in said.items() if value in self._pronouns]
        if not (pointing and self._named):
            meant = self.put_in(action)
            yield action if isinstance(meant, str) else meant
        else:
            yield from (_naming(action, dict.fromkeys(pointing, name)) for name in dict.fromkeys(self._named))

    def _with_noun(self, thing: str) -> str:
        """A thing of which only was said which it is, with the noun of the one before: "the red cup and the blue one",
        and where that was told by such a word as well, "die rote Tasse und die blaue"."""
        *which, last = thing.split()
        before = self._named[-1].split()
        noun = before[-1]
        nameless = noun in self._qualities | self._stand_ins or len(noun) == 1 or is_number(noun, self._language)
        if nameless or not self._bound.isdisjoint(before):
            return thing  # "box two", "the cup of tea"
        if which and last in self._stand_ins and self._qualities.issuperset(which):
            return " ".join((*which, noun))
        alone = self._qualities.issuperset((*which, last)) and not self._qualities.isdisjoint(before)
        return f"{thing} {noun}" if alone else thing


def _naming(action: Action, things: Mapping[str, str]) -> Action:
    """An action with other things in its slots, or of its object."""
    if isinstance(action, Pick | Place):
        return replace(action, object=next(iter(things.values())))
    assert isinstance(action, Custom)
    return replace(action, slots={**action.slots, **things})


def things_of(grammar: Grammar) -> frozenset[str]:
    """The slots of free words that hold things, whatever they are called."""
    slots = (slot for slot in grammar.slots.values() if slot.type in FREE_KINDS and not slot.dictation)
    return frozenset(slot.name for slot in slots if slot.known or slot.type == "object")


def names_something(action: Action, things: Collection[str] = ()) -> bool:
    """Whether an action has to do with something that "it" can be; ``things`` as :func:`things_of` has them."""
    return any(_named(action, things).values())


def _named(action: Action, things: Collection[str]) -> dict[str, object]:
    """What an action may have to do with, as it was said: of "look at the cup" its target, of "bring it to the door"
    not."""
    if isinstance(action, Pick | Place):
        return {"object": action.object}
    if not isinstance(action, Custom):
        return {}
    keys = [key for key in action.slots if key in ("thing", "object") or key in things] or ["target"]
    return {key: action.slots.get(key) for key in keys}


def _with_what_tells_which(reading: Reading, start: int, end: int) -> list[Sequence[str]]:
    """A name with the values that stand straight before it, the most of them first: of "the big green cube" the "big
    green cube" and the "green cube"."""
    before = {slot.end: slot.start for slot in reading.slots if slot.slot.type in _TELLING and slot.start < slot.end}
    found: list[Sequence[str]] = []
    while start in before:
        start = before[start]
        found.insert(0, reading.words[start:end])
    return found


def _is_not_free(last: frozenset[str], free_words: Callable[[str], Collection[str]], text: str) -> bool:
    """Whether a name, by the words that it may end with, stands in no free words of a text."""
    return last.isdisjoint(free_words(text))


@dataclass(frozen=True, slots=True)
class NameSaid:
    """What was named, for which a pronoun may stand."""

    ways: Sequence[Sequence[str]]
    """Its words, as they may be put in the place of the pronoun; the first that fit count."""
    is_meant: bool
    """Whether it may be meant; else it is not clear that it is not, if it fits: "them" of one name."""
    fits: Callable[[str], bool] = lambda text: True
    """Whether it stands in a text where a name of its kind may stand."""


class NamesListed:
    """The names of lists and the map that the commands of one utterance say.

    Args:
        grammar: whose pronouns are put in.
        sequence: its words between commands.
    """

    def __init__(self, grammar: Grammar, sequence: PhraseSet) -> None:
        known, several = thing_words(grammar.language), grammar.wording.several
        # Where one that is an article is written with its verb, it is read with that.
        none = known.articles if grammar.wording.for_whom_before else frozenset[str]()
        self._pronouns = PhraseSet(words for words in grammar.operators.pronoun if none.isdisjoint(words))
        self._no_pronouns = known.articles
        self._no_noun_begins = known.joining | known.binding
        self._several = several
        self._plurals = known.plurals
        self._of_several = known.of_several
        self._definite = known.definite
        self._leading = known.definite | (known.owning - default_another(grammar.language).keys())
        self._no_noun = known.joining | known.binding | known.within | known.articles | known.alone | known.scales
        self._articles = [(), *((word,) for word in sorted(known.definite) if len(known.definite) == 1)]
        self._sequence = sequence

    def put_in(self, core: Utterance, as_said: Callable[[Utterance], Understood | None]) -> Understood | None:
        """The meaning of an utterance with the name that it points back to: "fly to tank 2 and photograph it"; None: it
        points to none, or it is not clear to which.

        Args:
            core: what was said.
            as_said: what an utterance means that takes its place; None: it is no command.
        """
        found = self._find(core)
        ends = range(found[0] - 1, 0, -1) if found is not None else ()
        wholes = (core.part(0, end) for end in ends if core.breaks[end] or self._sequence.at(core.words, end))
        _, before = next(filter(None, map(as_said, wholes)), (None, ()))
        fits: dict[object, Understood] = {}
        for name in self._names(core, before):
            ways = (as_said(self._with_name(core, words)) for words in name.ways)
            for way in islice(filter(None, ways), 1):
                if not name.is_meant:
                    return None
                fits.setdefault(way[0].actions, way)
        return next(iter(fits.values())) if len(fits) == 1 else None

    def before(
        self,
        text: str,
        core: Utterance,
        before: Callable[[], Sequence[Clause]],
        free_words: Callable[[str], Collection[str]],
    ) -> list[NameSaid]:
        """What the commands of an earlier utterance named that a pronoun may stand for: "close it", after "open the
        lid"; its ways are texts. Empty if there is none, or more than one pronoun.

        No name is put into free words, which hold a pronoun as they hold any name, and are refused for more than that:
        "take it slow".

        Args:
            text: what was said.
            core: its words, without those that say nothing.
            before: gives the earlier commands.
            free_words: gives the words that are free in a text.
        """
        found = self._find(core)
        if found is None or self._find(core, sum(found)) is not None:
            return []
        pronoun = core.words[found[0] : sum(found)]
        said: list[NameSaid] = []
        for name in self._names(core, before()):
            ways = [with_name(text, pronoun, " ".join(way)).split() for way in name.ways]
            last = frozenset(way[-1] for way in name.ways)
            said.append(replace(name, ways=ways, fits=partial(_is_not_free, last, free_words)))
        return said

    def _names(self, core: Utterance, before: Sequence[Clause]) -> list[NameSaid]:
        """What commands name that a pronoun may stand for."""
        names: dict[object, Sequence[str]] = {}
        meant: set[object] = set()
        led: dict[object, list[Sequence[str]]] = {}
        fuller: dict[object, list[Sequence[str]]] = {}
        one = self._several.isdisjoint(core.words)
        own: list[NameSaid] = []
        for reading in (part.reading for part in before if part.reading is not None):
            for slot in reading.slots:
                if slot.slot.type in _LISTED:
                    if one or self._are_several(reading, slot.start, slot.end):
                        meant.add(slot.value)
                    names.setdefault(slot.value, reading.words[slot.start : slot.end])
                    before_it = reading.words[slot.start - 1 : slot.start]
                    led.setdefault(slot.value, [before_it] if not self._definite.isdisjoint(before_it) else [])
                    fuller.setdefault(slot.value, _with_what_tells_which(reading, slot.start, slot.end))
            own += self._own_things(reading, one=one)
            own += self._numbered(reading) if one else ()
        listed = [
            NameSaid(
                [
                    (*article, *way)
                    for way in (*fuller.get(value, ()), name)
                    for article in self._articles_of(way, led.get(value, []))
                ],
                value in meant,
            )
            for value, name in names.items()
        ]
        return [*listed, *own]

    def _articles_of(self, name: Sequence[str], led: Sequence[Sequence[str]]) -> Sequence[Sequence[str]]:
        """What may stand before a name, in the order tried: nothing, "the", and what stood before it."""
        return [*self._articles, *led] if self._definite.isdisjoint(name) else self._articles[:1]

    def _are_several(self, reading: Reading, start: int, end: int) -> bool:
        """Whether a name is one for more than one thing, as its own end or the article before it tell: "the blood
        samples", "die Rückgaben". That article may be for one that "sie" is as well."""
        if self._of_several:
            return not self._of_several.isdisjoint(reading.words[max(start - 1, 0) : start + 1])
        return bool(self._plurals) and any(singular(tuple(reading.words[end - 1 : end]), self._plurals))

    def _own_things(self, reading: Reading, *, one: bool) -> Iterator[NameSaid]:
        """What may be the names of things in the words of a sentence, each with its article and with what tells which:
        "the lid", "the left valve", "your right arm". More than one of it is no "it", and one is no "them"."""
        words = reading.words
        inner = {at for slot in reading.slots for at in range(slot.start + 1, slot.end)}
        free = {at for slot in reading.slots if slot.slot.type not in _TELLING for at in range(slot.start, slot.end)}
        named = {(slot.start, slot.end) for slot in reading.slots}
        for start in (at for at, word in enumerate(words) if word in self._leading and at not in free | inner):
            last = min(start + 2 + _MOST_WORDS, len(words) + 1)
            last = next((at + 1 for at in range(start + 1, last - 1) if at in free), last)
            ends = [end for end in range(start + 2, last) if end not in inner and (start + 1, end) not in named]
            if not one:
                ends = [end for end in ends if self._are_several(reading, start + 1, end)]
            ways = [words[start:end] for end in reversed(ends)]
            if ways:
                yield NameSaid(ways, is_meant=True)

    def _numbered(self, reading: Reading) -> Iterator[NameSaid]:
        """Things that are called by the number behind their noun: "vent 3"."""
        words, held = reading.words, {at for slot in reading.slots for at in range(slot.start, slot.end)}
        for slot in (one for one in reading.slots if one.slot.type == "number" and not one.slot.units):
            noun = slot.start - 1
            if noun < 1 or noun in held or words[noun] in self._no_noun:
                continue
            name = words[noun : slot.end]
            yield NameSaid([(*article, *name) for article in self._articles_of(name, [])], is_meant=True)

    def _find(self, said: Utterance, at: int = 0) -> tuple[int, int] | None:
        """Where the next pronoun stands, and how many words it has. One that is an article too ("that", "das") is one
        before no noun: "put that in the bin". Behind a pause its noun is still to come: "nein, das"."""
        words = said.words
        while (found := self._pronouns.find(words, at)) is not None:
            begin, count = found
            end = begin + count
            bare = self._no_noun_begins.issuperset(words[end : end + 1]) and not said.breaks[begin]
            if bare or self._no_pronouns.isdisjoint(words[begin:end]):
                return found
            at = end
        return None

    def _with_name(self, core: Utterance, name: Sequence[str]) -> Utterance:
        said, place = core, 0
        while (found := self._find(said, place)) is not None:
            at, length = found
            said = said.with_other(at, at + length, Utterance.in_one_breath(name))
            place = at + len(name)
        return said
