"""Slots that stand as alternatives in a sentence: of "shake the ({tool}|{reagent})" either may be meant by a name that
is not said as it is written."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import permutations

from intent_engine.language.templates.template_tree import AnyOrder, Choice, Node, Optional, Reference, Sequence

__all__ = ["alternatives"]

Labelled = tuple[str, str]
"""A label, and the name of its slot."""


def alternatives(node: Node, phrases: Mapping[str, Node]) -> dict[Labelled, tuple[Labelled, ...]]:
    """For each slot of a template the others that may stand alone in its place.

    Args:
        node: the template.
        phrases: those that it may name, none in a circle.
    """
    found: dict[Labelled, dict[Labelled, None]] = {}
    for choice in _choices(node, phrases):
        alone = [slot for item in choice.items for slot in _alone(item, phrases)]
        for one, other in permutations(dict.fromkeys(alone), 2):
            found.setdefault(one, {})[other] = None
    return {one: tuple(others) for one, others in found.items()}


def _choices(node: Node, phrases: Mapping[str, Node]) -> Iterator[Choice]:
    match node:
        case Choice(items):
            yield node
            for item in items:
                yield from _choices(item, phrases)
        case Sequence(items) | AnyOrder(items):
            for item in items:
                yield from _choices(item, phrases)
        case Optional(item):
            yield from _choices(item, phrases)
        case Reference(name, _, _) if name in phrases:
            yield from _choices(phrases[name], phrases)


def _alone(node: Node, phrases: Mapping[str, Node]) -> Iterator[Labelled]:
    """The slots that may be all of a template."""
    match node:
        case Choice(items):
            for item in items:
                yield from _alone(item, phrases)
        case Optional(item) | Sequence((item,)):
            yield from _alone(item, phrases)
        case Reference(name, _, _) if name in phrases:
            yield from _alone(phrases[name], phrases)
        case Reference(name, label, _):
            yield label, name
