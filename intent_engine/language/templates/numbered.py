"""Templates whose numbers may also be written otherwise: "channel 5" is heard as "channel five", and "gear twenty one"
is written "gear 21" by a recogniser.
"""

from __future__ import annotations

import operator
from collections.abc import Iterator
from functools import lru_cache

from intent_engine.language.numbers.spelled import number_otherwise
from intent_engine.language.templates.template_tree import AnyOrder, Choice, Node, Optional, Sequence, Word

__all__ = ["numbers_either_way"]


def numbers_either_way(node: Node) -> Node:
    """An English template with every number in it also in digits and in words. One without numbers is given back."""
    match node:
        case Word(text):
            return _number((text,)) if number_otherwise([text])[0] else node
        case Choice(items) | AnyOrder(items):
            otherwise = tuple(map(numbers_either_way, items))
            return node if _same(items, otherwise) else type(node)(otherwise)
        case Optional(item):
            other = numbers_either_way(item)
            return node if other is item else Optional(other)
        case Sequence(items):
            otherwise = tuple(_sequence(items))
            return node if _same(items, otherwise) else Sequence(otherwise)
    return node


def _same(items: tuple[Node, ...], others: tuple[Node, ...]) -> bool:
    return len(items) == len(others) and all(map(operator.is_, items, others))


def _sequence(items: tuple[Node, ...]) -> Iterator[Node]:
    """The parts of a sequence, numbers of several words together."""
    words = [item.text if isinstance(item, Word) else "" for item in items]
    at = 0
    while at < len(items):
        count, _ = number_otherwise(words[at:])
        if count:
            yield _number(tuple(words[at : at + count]))
            at += count
        else:
            yield numbers_either_way(items[at])
            at += 1


@lru_cache(maxsize=1024)
def _number(words: tuple[str, ...]) -> Node:
    """A number as it is written in a template, and all its other ways."""
    _, others = number_otherwise(words)
    return Choice(tuple(map(_node, (words, *others)))) if others else _node(words)


def _node(words: tuple[str, ...]) -> Node:
    return Word(words[0]) if len(words) == 1 else Sequence(tuple(map(Word, words)))
