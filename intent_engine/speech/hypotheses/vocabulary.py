"""The words of a grammar, for telling what a free slot took from what the grammar has."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from intent_engine.language.matcher import Matcher
from intent_engine.language.networks.sentence_networks import spoken_trees
from intent_engine.language.numbers.spelled import number_words
from intent_engine.language.numbers.units import SIGNS, units
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import vocabulary, words_in
from intent_engine.language.words.as_written import as_written
from intent_engine.language.words.thing_words import thing_words

__all__ = ["known_in_slots", "known_words", "said_in_slots", "said_of_signs", "words_as_written"]


def known_words(matcher: Matcher) -> frozenset[str]:
    """Every word that a list of the grammar has: those of sentences, values, quantities, places and free slots."""
    grammar = matcher.grammar
    found = {*number_words(grammar.language), *vocabulary(grammar), *thing_words(grammar.language).articles}
    for node in spoken_trees(grammar.language).values():
        found.update(words_in(node))
    for slot in grammar.slots.values():
        found |= slot.known
    found |= matcher.patterns.words
    spoken = (*grammar.fillers, *grammar.around, *grammar.wake, *grammar.operators.sequence)
    found.update(word for words in spoken for word in words)
    for name in matcher.locations.written() if matcher.locations is not None else ():
        found.update(Utterance.of(name, grammar.language).words)
    return frozenset(found)


def known_in_slots(matcher: Matcher) -> frozenset[str]:
    """Words that the value of a slot may have, where they are what a list says: "meter" is a word, but no thing."""
    grammar = matcher.grammar
    found = set(thing_words(grammar.language).articles) | matcher.patterns.values
    for slot in grammar.slots.values():
        found |= slot.known
        found.update(word for value, _ in slot.values for word in str(value).split())
    for intent in grammar.intents.values():
        for sentence in intent.all_sentences:
            found.update(said_in_slots(sentence.fixed))  # nobody says it: "down" of "lower the arm"
    for name in matcher.locations or ():
        found.update(Utterance.of(name, grammar.language).words)
        found.update(name.split())  # a slot has the place as the map writes it: "Bay B12", "X-ray"
    return frozenset(found)


def said_of_signs(words: Sequence[str], language: str | None) -> list[str]:
    """Words with the units of a language for those that signs are read as: "grad"."""
    table = units(language or "en")
    if table is None or language in (None, "en"):
        return list(words)
    return [table.first_name(word) if word in SIGNS else word for word in words]


def words_as_written(matcher: Matcher) -> dict[str, str]:
    """Words that the grammar or the map writes with a capital or an apostrophe, by the same small and plain."""
    places = matcher.locations
    return as_written(places.written() if places is not None else ()) | dict(matcher.grammar.as_written)


def said_in_slots(slots: Mapping[str, Any]) -> Iterator[str]:
    """The words of all slots that hold words, those of several commands too."""
    for value in slots.values():
        if isinstance(value, str):
            yield from value.split()
        elif isinstance(value, Mapping):
            yield from said_in_slots(value)
        elif isinstance(value, list):
            for step in value:  # of a compound: the name of its intent was not said
                yield from said_in_slots(step.get("slots", step)) if isinstance(step, Mapping) else ()
