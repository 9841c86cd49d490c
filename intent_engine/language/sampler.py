"""Trees to sentences: all short spellings of a value, or random sentences with their known meaning."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import islice, permutations

from intent_engine.language.template import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
)

__all__ = ["spellings"]


def spellings(node: Node, phrases: Mapping[str, Node], most: int) -> list[tuple[str, ...]]:
    """Up to ``most`` ways to say a template that holds words and phrases only."""
    return list(islice(_all(node, phrases), most))


def _all(node: Node, phrases: Mapping[str, Node]) -> Iterator[tuple[str, ...]]:
    match node:
        case Word(text):
            yield (text,)
        case Choice(items):
            for item in items:
                yield from _all(item, phrases)
        case Optional(item):
            yield from _all(item, phrases)
            yield ()
        case Sequence(items):
            yield from _joined(items, phrases)
        case AnyOrder(items):
            for order in permutations(items):
                yield from _joined(order, phrases)
        case Reference(name) if name in phrases:
            yield from _all(phrases[name], phrases)


def _joined(items: tuple[Node, ...], phrases: Mapping[str, Node]) -> Iterator[tuple[str, ...]]:
    if not items:
        yield ()
        return
    for head in _all(items[0], phrases):
        for tail in _joined(items[1:], phrases):
            yield (*head, *tail)
