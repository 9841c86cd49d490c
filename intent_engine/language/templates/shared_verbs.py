"""Templates in which a verb is said once of several things: who writes "open the {door}" is told "open the hatch and
the gate" as well."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass

from intent_engine.language.templates.template_tree import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
    WordClass,
    references,
    says_only,
)

__all__ = ["SharedVerbs"]

MOST_MORE = 3
"""Things after the first."""


@dataclass(frozen=True, slots=True)
class SharedVerbs:
    """Puts further things into templates."""

    joint: Node
    """What stands between two things."""
    is_named: Callable[[str], bool]
    """Whether a slot or a phrase tells one thing from another."""
    articles: Collection[str]
    """Of the language."""

    def several(self, node: Node) -> Node:
        """A template with further things: straight behind one ("put the cup and the plate down"), or at the end with
        all that is said of each ("A to twenty and B to thirty")."""
        return Sequence((self._with_more(node, begun=False), *self.more_of(node)))

    def more_of(self, node: Node) -> Iterable[Node]:
        """What may follow a whole sentence: further things, with all that is said of each. Empty: nothing may."""
        items = list(_laid_open(node))
        ends: list[Node] = []
        for place, item in enumerate(items):
            names = [one.name for rest in items[place:] for one in references(rest)]
            if isinstance(item, Reference) and _says_a_word(items[:place]) and any(map(self.is_named, names)):
                ends.append(Sequence((*self._before(items, place, begun=False), *items[place:])))
        return (self._more(ends),) if ends else ()

    def _with_more(self, node: Node, *, begun: bool) -> Node:
        """With further things straight behind each; ``begun``: whether the verb stands before."""
        match node:
            case Choice(items):
                return Choice(tuple(self._with_more(one, begun=begun) for one in items))
            case AnyOrder(items):
                return AnyOrder(tuple(self._with_more(one, begun=begun) for one in items))
            case Optional(inner):
                return Optional(self._with_more(inner, begun=begun))
            case Reference(name) if begun and self.is_named(name):
                return Sequence((node, self._more([node])))
            case Sequence():
                parts: list[Node] = []
                laid_open = list(_laid_open(node))
                for place, item in enumerate(laid_open):
                    behind = begun or _says_a_word(laid_open[:place])
                    if isinstance(item, Reference) and behind and self.is_named(item.name):
                        other = Sequence((*self._before(laid_open, place, begun=begun), item))
                        parts += [item, self._more([other])]
                    else:
                        parts.append(self._with_more(item, begun=behind))
                return Sequence(tuple(parts))
        return node

    def _more(self, things: list[Node]) -> Node:
        """Several more of some things, or none."""
        thing = things[0] if len(things) == 1 else Choice(tuple(things))
        found: Node = Optional(Sequence((self.joint, thing)))
        for _ in range(MOST_MORE - 1):
            found = Optional(Sequence((self.joint, thing, found)))
        return found

    def _before(self, items: list[Node], place: int, *, begun: bool) -> list[Node]:
        """The words before a thing as they may be said again: its article; and as many before that as are not the verb,
        nor belong to what is named before ("in the hall and *in* the lab")."""
        begin = article = place
        while begin > 0 and next(references(items[begin - 1]), None) is None:
            if not (begun or _says_a_word(items[: begin - 1])):
                break
            begin -= 1
            if article == begin + 1 and says_only(items[begin], self.articles):
                article = begin
        again: Node | None = None
        for item in items[begin:article]:
            again = Optional(item if again is None else Sequence((again, item)))
        return [*([again] if again is not None else []), *items[article:place]]


def _laid_open(node: Node) -> Iterable[Node]:
    """The items of a sequence, those of sequences in it among them."""
    if not isinstance(node, Sequence):
        return (node,)
    return [inner for item in node.items for inner in _laid_open(item)]


def _says_a_word(items: Iterable[Node]) -> bool:
    """Whether a word is said in any case."""
    return any(isinstance(item, (Word, Choice, Reference, WordClass, AnyOrder)) for item in items)
