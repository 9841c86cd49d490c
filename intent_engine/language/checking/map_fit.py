"""What a grammar and a map make of each other: places that only the grammar has, names of places that are commands."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from intent_engine.errors import Problem
from intent_engine.hints import did_you_mean
from intent_engine.language.grammar import Grammar, Intent, Place, Slot, problem_at
from intent_engine.language.loading.grammar_intents import slot_of_parameter, slots_by_label
from intent_engine.language.locations import OTHER_MEANINGS
from intent_engine.language.slots.name_words import raw_words

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap
    from intent_engine.language.matcher import Matcher
    from intent_engine.language.reading import Reading

__all__ = ["name_or_command", "named_like_commands", "one_is_a_name", "places_missing"]


# -- places that a grammar names ------------------------------------------------------------------------------


def places_missing(grammar: Grammar, locations: LocationMap) -> Iterator[Problem]:
    """Places that an intent goes to without hearing them, and that the map has not: it can never be done."""
    for intent in grammar.intents.values():
        told: set[str] = set()
        for name, place in _named(intent, grammar):
            if name not in locations and name not in told and place is not None:
                told.add(name)
                message = f"intent {intent.name!r} names the place {name!r}, which is not on the map"
                other = next((other for words, other in locations.names() if words == raw_words(name)), None)
                near = f"the map calls it {other!r}" if other else did_you_mean(name, list(locations.written()))
                yield problem_at(place, message, near or "add it to the map, or give the map that has it")


def _named(intent: Intent, grammar: Grammar) -> Iterator[tuple[str, Place | None]]:
    """Names of places that an intent has without hearing them, or as values of a list, each with where it stands."""
    slots = slots_by_label((sentence.template for sentence in intent.all_sentences), grammar)
    goes = intent.action.type == "navigate"
    asked = slot_of_parameter(intent.action, "location")
    labels = {label for label, slot in slots.items() if slot.type == "location"}
    if goes:
        labels |= {asked, "location"}
    constant = intent.action.parameters.get("location")
    if goes and isinstance(constant, str) and not constant.startswith("{"):
        yield constant, intent.place
    yield from _values(labels, intent.defaults, intent.place)
    for condition in intent.when:
        yield from _values(labels, condition.defaults, intent.place)
    for sentence in intent.all_sentences:
        yield from _values(labels, sentence.fixed, sentence.place)
    if goes and (slot := slots.get(asked)) is not None and slot.type == "choice":
        yield from _listed(slot)


def _values(labels: Iterable[str], given: Mapping[str, Any], place: Place | None) -> Iterator[tuple[str, Place | None]]:
    for label in sorted(labels):
        if isinstance(given.get(label), str):
            yield given[label], place


def _listed(slot: Slot) -> Iterator[tuple[str, Place | None]]:
    for value, _ in slot.values:
        yield str(value), slot.place


# -- names of places that are commands ------------------------------------------------------------------------


def one_is_a_name(first: Reading, other: Reading) -> tuple[str, Reading] | None:
    """The place whose name one of two readings of the same words has where the other has something else; and that."""
    for one, rival in ((first, other), (other, first)):
        spans = {(slot.start, slot.end) for slot in rival.slots if slot.slot.type == "location"}
        for slot in one.slots:
            if slot.slot.type == "location" and (slot.start, slot.end) not in spans and isinstance(slot.value, str):
                return slot.value, rival
    return None


def name_or_command(locations: LocationMap, name: str, words: str, command: Reading) -> Problem:
    """Told of words that may be a place or a command."""
    place = command.sentence.place
    where = f" ({place.file}:{place.line})" if place is not None else ""
    message = f"{words!r} could be the place {name!r} or a command of {command.intent.name!r}{where}"
    return _of_a_name(locations, name, f"{message}: the robot would ask")


def named_like_commands(matcher: Matcher, locations: LocationMap, told: Iterable[str]) -> Iterator[Problem]:
    """Names that alone are a command of the grammar, or change what is said.

    Args:
        matcher: of the grammar, with those names of the map that could be taken for something else.
        locations: the map.
        told: places of which something was told already.
    """
    known = set(told)
    operators = matcher.grammar.operators
    changing = {words: why for kind, why in OTHER_MEANINGS.items() for words in getattr(operators, kind)}
    for words, name in matcher.locations.names() if matcher.locations is not None else ():
        if name in known:
            continue
        why = changing.get(words)
        if why is None and (command := next(filter(_is_command, matcher.read(list(words))), None)) is not None:
            why = f"is a command of {command.intent.name!r}"
        if why is not None:
            known.add(name)
            yield _of_a_name(locations, name, f"{' '.join(words)!r}, a name of {name!r}, {why} when it is said")


def _is_command(reading: Reading) -> bool:
    return not reading.problem and not any(slot.slot.type == "location" for slot in reading.slots)


def _of_a_name(locations: LocationMap, name: str, message: str) -> Problem:
    return locations.problem(name, message, f'give it another name; or say what it is, as "{name} corner"')
