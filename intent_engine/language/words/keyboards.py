"""Words as the grammar has them: typed without the letters that a keyboard lacks ("kueche", "arrete", "metros mas"),
and titles."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields, replace
from functools import cached_property
from typing import TYPE_CHECKING

from intent_engine.language.normalize import without_accents
from intent_engine.language.numbers import foreign
from intent_engine.language.numbers.units import units
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import vocabulary
from intent_engine.language.words.thing_words import ThingWords, thing_words
from intent_engine.language.words.titles import Titles

if TYPE_CHECKING:
    from intent_engine.language.matcher import Matcher

__all__ = ["Keyboards"]

_WRITTEN_AS = {"de": str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue", "ß": "ss"})}
"""Where letters are written as others, and not only bare of their marks: "drucken" is no "drücken"."""
_LIGATURES = str.maketrans({"œ": "oe", "æ": "ae"})
SHORTEST = 3
"""Letters. Shorter words are others: "ou" is no "où", "si" no "sí"."""


class Keyboards:
    """What words of a grammar and its map are typed as, where nothing else that the language has is written so."""

    def __init__(self, matcher: Matcher) -> None:
        self._matcher = matcher

    def read(self, said: Utterance) -> Utterance:
        """The utterance with such words as the grammar has them; the same one if there are none."""
        words = list(map(self._word, said.words)) if self._meant else said.words
        read = said if words == said.words else replace(said, words=words)
        return self._titles.read(read)

    @cached_property
    def _titles(self) -> Titles:
        known = self._known.union(word.rstrip(".") for word in self.words_of_places)
        return Titles(known, self._matcher.grammar.language)

    def _word(self, word: str) -> str:
        if not word.isascii() or word in self._known:
            return word
        if (meant := self._meant.get(word)) is not None:
            return meant
        for plain, meant in self._meant.items():  # "zurueckfahren", where the grammar has "zurück" and "fahren"
            if word.startswith(plain) and word[len(plain) :] in self._known:
                return meant + word[len(plain) :]
        return word

    @cached_property
    def words_of_places(self) -> frozenset[str]:
        """Those of the names on the map."""
        return frozenset(_words_of_places(self._matcher))

    @cached_property
    def _known(self) -> frozenset[str]:
        return self.words_of_places.union(_words(self._matcher))

    @cached_property
    def _meant(self) -> Mapping[str, str]:
        """The words of the grammar, by what they are typed as."""
        grammar = self._matcher.grammar
        language = grammar.language
        places = _words_of_places(self._matcher, marked=True)  # of ten thousand names few are
        marked = {word for word in (*_words(self._matcher), *places) if not word.isascii()}
        typed = [(plain, word) for word in marked if len(plain := _typed(word, language)) >= SHORTEST and plain != word]
        if not typed:
            return {}
        others = self._known | _others(thing_words(language)) | grammar.operators.closed
        found: dict[str, set[str]] = {}
        for plain, word in typed:
            number = language != "en" and foreign.is_number_word(plain, language)
            if plain not in others and not number:
                found.setdefault(plain, set()).add(word)
        return {plain: next(iter(words)) for plain, words in found.items() if len(words) == 1}  # "pâte" is no "pâté"


def _typed(word: str, language: str) -> str:
    if word.isascii():
        return word
    return without_accents(word.translate(_WRITTEN_AS.get(language, _LIGATURES)))


def _words(matcher: Matcher) -> Iterator[str]:
    """Every word that sentences, values, units and what changes them are written in."""
    grammar, operators = matcher.grammar, matcher.grammar.operators
    yield from vocabulary(grammar)
    for slot in grammar.slots.values():
        yield from slot.known
    for phrases in (grammar.fillers, grammar.around, *(getattr(operators, one.name) for one in fields(operators))):
        for phrase in phrases:
            yield from (phrase,) if isinstance(phrase, str) else phrase
    table = units(grammar.language)
    for name in table.names if table is not None else ():
        yield from name


def _words_of_places(matcher: Matcher, *, marked: bool = False) -> Iterator[str]:
    """The words of the names of places; ``marked``: of those that have more than plain letters."""
    language = matcher.grammar.language
    for place in matcher.locations.written() if matcher.locations is not None else ():
        if not place.isascii():
            yield from Utterance.of(place, language).words
        elif not marked:
            yield from place.lower().split()


def _others(things: ThingWords) -> frozenset[str]:
    """What else a language is known to have: articles and the like."""
    values = (getattr(things, one.name) for one in fields(things))
    return frozenset[str]().union(*(value for value in values if isinstance(value, frozenset)))
