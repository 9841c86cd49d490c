"""Templates with what says how something is done elsewhere: who writes "[{pace}] turn the crank" is told "turn the
crank slowly" as well, and the other way round."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from intent_engine.language.templates.template_tree import Choice, Node, Optional, Reference, Sequence, Word

__all__ = ["manner_moved"]


def manner_moved(node: Node, is_manner: Callable[[str], bool], says_how: Callable[[str], bool]) -> Iterator[Node]:
    """The other templates that say the same: with what stands at their end first, and what stands first at their end.

    Args:
        node: the template.
        is_manner: whether a word is such an adverb.
        says_how: whether each value of a slot is one.
    """
    match node:
        case Sequence((first, *_, last)):
            inner = node.items[1:-1]
            if _is_how(first, is_manner, says_how):
                yield Sequence((*inner, last, _said(first)))
            elif _is_how(last, is_manner, says_how):
                yield Sequence((_said(last), first, *inner))
        case Choice(items):
            for one in items:
                yield from manner_moved(one, is_manner, says_how)


def _is_how(item: Node, is_manner: Callable[[str], bool], says_how: Callable[[str], bool]) -> bool:
    match item:
        case Optional(inner):
            return _is_how(inner, is_manner, says_how)
        case Choice(items):
            return all(_is_how(one, is_manner, says_how) for one in items)
        case Word(text):
            return is_manner(text)
        case Reference(name):
            return says_how(name)
    return False


def _said(item: Node) -> Node:
    """What may be left out, said: without it the sentence is as it was."""
    return item.item if isinstance(item, Optional) else item
