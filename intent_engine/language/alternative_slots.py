"""Slots that stand as alternatives in a sentence: of "shake the ({tool}|{reagent})" either may be meant by a name that
is not said as it is written."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import permutations

from intent_engine.language.template_tree import AnyOrder, Choice, Node, Optional, Reference, Sequence

__all__ = ["alternatives"]

Labelled = tuple[str, str]
"""A label, and the name of its slot."""


def alternatives(node: Node, phrases: Mapping[str, Node]) -> dict[Labelled, tuple[Labelled, ...]]:
    """For each slot of a template the others that may stand alone in its place.

    Args:
        node: the template.
        phrases: those that it may name.
    """
    found: dict[Labelled, dict[Labelled, None]] = {}
    for choice in _choices(node, phrases, frozenset()):
        alone = [slot for item in choice.items for slot in _alone(item, phrases, frozenset())]
        for one, other in permutations(dict.fromkeys(alone), 2):
            found.setdefault(one, {})[other] = None
    return {one: tuple(others) for one, others in found.items()}


def _choices(node: Node, phrases: Mapping[str, Node], within: frozenset[str]) -> Iterator[Choice]:
    match node:
        case Choice(items):
            yield node
            for item in items:
                yield from _choices(item, phrases, within)
        case Sequence(items) | AnyOrder(items):
            for item in items:
                yield from _choices(item, phrases, within)
        case Optional(item):
            yield from _choices(item, phrases, within)
        case Reference(name, _, _) if name in phrases and name not in within:
            yield from _choices(phrases[name], phrases, within | {name})


def _alone(node: Node, phrases: Mapping[str, Node], within: frozenset[str]) -> Iterator[Labelled]:
    """The slots that may be all of a template."""
    match node:
        case Choice(items):
            for item in items:
                yield from _alone(item, phrases, within)
        case Optional(item) | Sequence((item,)):
            yield from _alone(item, phrases, within)
        case Reference(name, _, _) if name in phrases:
            if name not in within:
                yield from _alone(phrases[name], phrases, within | {name})
        case Reference(name, label, _):
            yield label, name
