"""Templates with an article before the names that they have none before: who writes "photograph {thing}" is told
"photograph the bridge" as well."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from intent_engine.language.templates.template_tree import AnyOrder, Choice, Node, Optional, Reference, Sequence, Word

__all__ = ["led"]


def led(
    node: Node, leading: Mapping[str, Collection[str]], numbers: Collection[str], articles: Collection[str]
) -> Node:
    """A template in which an article may stand before a name, where none is written and no number is before it.

    Args:
        node: the template.
        leading: the articles that may stand before each slot that holds names.
        numbers: the slots that hold amounts.
        articles: of its language.
    """

    def ends(item: Node, before: bool = False) -> bool:
        """Whether it may end in what no article stands behind; ``before``: whether what is before it does."""
        match item:
            case Word(text):
                return text in articles
            case Reference(name, _, _):
                return name in numbers
            case Choice(items) | AnyOrder(items):
                return any(ends(one, before) for one in items)
            case Optional(inner):
                return before or ends(inner)
            case Sequence(items):
                for one in items:
                    before = ends(one, before)
                return before
        return False

    def counts(item: Node) -> bool:
        """Whether it ends in an amount, however it is said."""
        match item:
            case Reference(name, _, _):
                return name in numbers
            case Choice(items):
                return all(map(counts, items))
            case Sequence(items):
                return counts(items[-1])
        return False

    def walk(item: Node, before: bool) -> Node:
        match item:
            case Reference(name, _, _) if leading.get(name) and not before:
                return Sequence((Optional(Choice(tuple(map(Word, sorted(leading[name]))))), item))
            case Choice(items):
                return Choice(tuple(walk(one, before) for one in items))
            case AnyOrder(items):
                return AnyOrder(tuple(walk(one, before) for one in items))
            case Optional(inner):
                return Optional(walk(inner, before))
            case Sequence(items):
                parts: list[Node] = []
                for place, one in enumerate(items):
                    if isinstance(one, Optional) and not before and counts(one.item) and place + 1 < len(items):
                        # "bring [{count}] {item}": where no number is said, an article may be.
                        rest = Sequence(items[place + 1 :])
                        bare, counted = walk(rest, False), walk(rest, True)
                        if bare != counted:
                            return Sequence((*parts, Choice((bare, Sequence((walk(one.item, False), counted))))))
                    parts.append(walk(one, before))
                    before = ends(one, before)
                return Sequence(tuple(parts))
        return item

    return walk(node, False)
