"""Sentence templates as trees: what the parser makes, and text again."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import TypeAlias

__all__ = [
    "AnyOrder",
    "Choice",
    "Node",
    "Optional",
    "Reference",
    "Sequence",
    "Word",
    "WordClass",
    "first_words",
    "last_references",
    "most_words",
    "references",
    "says_only",
    "template_text",
]


@dataclass(frozen=True, slots=True)
class Word:
    text: str
    """One normalised word."""


@dataclass(frozen=True, slots=True)
class WordClass:
    name: str
    """``#``: a numeral; ``#word``: a number word of the grammar's language."""


@dataclass(frozen=True, slots=True)
class Reference:
    name: str
    """Phrase or slot."""
    label: str
    """Name under which a slot's value is given; the same as ``name`` unless ``{name:label}``."""
    column: int
    """Place in the template, from 0, for error messages."""


@dataclass(frozen=True, slots=True)
class Sequence:
    items: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Choice:
    items: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Optional:
    item: Node


@dataclass(frozen=True, slots=True)
class AnyOrder:
    items: tuple[Node, ...]


Node: TypeAlias = Word | WordClass | Reference | Sequence | Choice | Optional | AnyOrder


def references(node: Node) -> Iterator[Reference]:
    """Every phrase and slot that a template names, in order."""
    waiting = [node]
    while waiting:
        node = waiting.pop()
        if isinstance(node, Word):
            continue  # as most are
        if isinstance(node, Reference):
            yield node
        elif isinstance(node, (Sequence, Choice, AnyOrder)):
            waiting.extend(node.items[::-1])
        elif isinstance(node, Optional):
            waiting.append(node.item)


def last_references(node: Node) -> Iterator[Reference]:
    """The phrases and slots with which a template may end."""
    match node:
        case Reference():
            yield node
        case Optional(item):
            yield from last_references(item)
        case Choice(items) | AnyOrder(items):
            for item in items:
                yield from last_references(item)
        case Sequence(items):
            for item in reversed(items):
                yield from last_references(item)
                if not isinstance(item, Optional):
                    return


def most_words(node: Node, named: Callable[[Reference], int] = lambda _: 1) -> int:
    """Words of the longest way to say a template; ``named``: of what it names."""
    match node:
        case Word() | WordClass():
            return 1
        case Optional(item):
            return most_words(item, named)
        case Choice(items):
            return max(most_words(item, named) for item in items)
        case Sequence(items) | AnyOrder(items):
            return sum(most_words(item, named) for item in items)
        case Reference():
            return named(node)


def first_words(node: Node, phrases: Mapping[str, Node]) -> tuple[frozenset[str], bool]:
    """Words with which a template may begin, and whether it may say nothing; those of phrases with it, but of no slot.
    Phrases name each other in no circle."""
    match node:
        case Word(text):
            return frozenset((text,)), False
        case Reference(name) if name in phrases:
            return first_words(phrases[name], phrases)
        case Optional(item):
            return first_words(item, phrases)[0], True
        case Choice(items) | AnyOrder(items):
            found = [first_words(item, phrases) for item in items]
            either = any if isinstance(node, Choice) else all
            return frozenset[str]().union(*(words for words, _ in found)), either(empty for _, empty in found)
        case Sequence(items):
            begun: frozenset[str] = frozenset()
            for item in items:
                words, empty = first_words(item, phrases)
                begun |= words
                if not empty:
                    return begun, False
            return begun, True
        case _:
            return frozenset(), False


def says_only(node: Node, words: Collection[str]) -> bool:
    """Whether a template says one of some words, or nothing."""
    match node:
        case Word(text):
            return text in words
        case Optional(item):
            return says_only(item, words)
        case Choice(items):
            return all(says_only(item, words) for item in items)
        case _:
            return False


def template_text(node: Node) -> str:
    """A tree as a template that parses back to it, in its shortest form."""
    match node:
        case Word(text):
            return text
        case WordClass(name):
            return "{" + name + "}"
        case Reference(name, label, _):
            return "{" + (name if name == label else f"{name}:{label}") + "}"
        case Choice(items):
            return "(" + "|".join(template_text(item) for item in items) + ")"
        case AnyOrder(items):
            return "(" + "; ".join(template_text(item) for item in items) + ")"
        case Sequence(items):
            parts = [template_text(item) for item in items]
            nested = [
                f"({part})" if isinstance(item, Sequence) else part for item, part in zip(items, parts, strict=True)
            ]
            return " ".join(nested)
        case Optional(item):
            inside = template_text(item)
            return "[" + (inside[1:-1] if isinstance(item, (Choice, AnyOrder)) else inside) + "]"
