"""How large a grammar is, counted on its trees: nothing is listed, so a billion sentences take no longer than ten."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import TYPE_CHECKING

from intent_engine.language.grammar import QUANTITY_KINDS, Grammar
from intent_engine.language.networks.network import MOST_ARTICLES
from intent_engine.language.quantities import MAX_WORDS
from intent_engine.language.templates.template_tree import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
    WordClass,
    most_words,
)

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["Size", "grammar_size"]


@dataclass(frozen=True, slots=True)
class Size:
    """How much can be said."""

    intents: int
    sentences: int
    """Templates."""
    patterns: int
    """``regex:`` and ``lark:``; they are not counted below."""
    ways: int
    """Ways to say them, a slot counted once."""
    spoken: int
    """The same with every value of a choice and every name of the places that a slot takes; a quantity or free text is
    still one."""
    longest: int
    """Words of the longest sentence."""
    names: int
    """Names and aliases of the map, if any slot takes a place."""


def grammar_size(grammar: Grammar, locations: LocationMap | None) -> Size:
    """Count what a grammar and a map hold."""
    sentences = [sentence for intent in grammar.intents.values() for sentence in intent.all_sentences]
    names = [words for words, _ in locations.names()] if locations is not None else []
    longest_name = max((len(words) for words in names), default=0)
    once, each = _Counter(grammar, None), _Counter(grammar, _names_of_tags(locations))
    lengths = _Lengths(grammar, longest_name)
    return Size(
        intents=len(grammar.intents),
        sentences=len(sentences),
        patterns=sum(len(intent.regex) + (intent.lark is not None) for intent in grammar.intents.values()),
        ways=sum(once.ways(sentence.template) for sentence in sentences),
        spoken=sum(each.ways(sentence.template) for sentence in sentences),
        longest=max((lengths.of(sentence.template) for sentence in sentences), default=0),
        names=len(names) if any(slot.type == "location" for slot in grammar.slots.values()) else 0,
    )


def _names_of_tags(locations: LocationMap | None) -> list[frozenset[str]]:
    """Of each name, the tags of its place."""
    return [frozenset(locations[name].tags) for _, name in locations.names()] if locations is not None else []


class _Figure(ABC):
    """A number for a template; what has a name is worked out once."""

    def __init__(self, grammar: Grammar) -> None:
        self._grammar = grammar
        self._known: dict[str, int] = {}

    def _reference(self, name: str) -> int:
        if name not in self._known:
            self._known[name] = self._named(name)
        return self._known[name]

    @abstractmethod
    def _named(self, name: str) -> int: ...


class _Counter(_Figure):
    """Ways to say a template; ``names`` is None to count a slot once, else the tags of each name of the map."""

    def __init__(self, grammar: Grammar, names: list[frozenset[str]] | None) -> None:
        super().__init__(grammar)
        self._names = names

    def ways(self, node: Node) -> int:
        match node:
            case Word() | WordClass():
                return 1
            case Optional(item):
                return 1 + self.ways(item)
            case Choice(items):
                return sum(self.ways(item) for item in items)
            case Sequence(items):
                return math.prod(self.ways(item) for item in items)
            case AnyOrder(items):
                return math.factorial(len(items)) * math.prod(self.ways(item) for item in items)
            case Reference(name):
                return self._reference(name)

    def _named(self, name: str) -> int:
        if name in self._grammar.phrases:
            return self.ways(self._grammar.phrases[name])
        slot = self._grammar.slots[name]
        if self._names is None:
            return 1
        if slot.type in ("choice", "boolean"):
            return sum(self.ways(node) for _, node in slot.values)
        if slot.type == "location":
            return max(sum(not slot.tags or bool(slot.tags & tags) for tags in self._names), 1)
        return 1


class _Lengths(_Figure):
    """Words of the longest way to say a template."""

    def __init__(self, grammar: Grammar, longest_name: int) -> None:
        super().__init__(grammar)
        self._longest_name = longest_name

    def of(self, node: Node) -> int:
        return most_words(node, lambda reference: self._reference(reference.name))

    def _named(self, name: str) -> int:
        if name in self._grammar.phrases:
            return self.of(self._grammar.phrases[name])
        slot = self._grammar.slots[name]
        if slot.type in ("choice", "boolean"):
            return max((self.of(node) for _, node in slot.values), default=0)
        if slot.type == "location":
            return self._longest_name
        if slot.type in QUANTITY_KINDS:
            return MAX_WORDS
        return slot.max_words if slot.dictation else slot.max_words + MOST_ARTICLES
