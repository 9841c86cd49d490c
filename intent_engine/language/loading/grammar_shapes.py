"""What is known of a template before anybody says it: whether it needs a word, which slots it gives, how wide it is."""

from __future__ import annotations

from intent_engine.language.grammar import FREE_KINDS, QUANTITY_KINDS, Grammar
from intent_engine.language.templates.template_tree import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
    WordClass,
)

__all__ = ["Shapes"]

QUANTITY_WAYS = 40
"""Ways to begin or to go on with a quantity, more or less: the English tree of distances has 30."""


class Shapes:
    """What can be said of templates without saying them. Each phrase is looked at once, however often it is named."""

    def __init__(self, grammar: Grammar) -> None:
        self._grammar = grammar
        self._empty: dict[str, bool] = {}
        self._free: dict[str, bool] = {}
        self._labels: dict[str, dict[str, int]] = {}
        self._always: dict[str, frozenset[str]] = {}
        self._entries: dict[str, int] = {}
        self._widest: dict[str, int] = {}

    def empty(self, node: Node) -> bool:
        """Whether a template can be said with no word at all."""
        return self._only(node, self._empty, free=False)

    def free(self, node: Node) -> bool:
        """Whether a template can be said with words of text slots alone: then it fits whatever anybody says."""
        return self._only(node, self._free, free=True)

    def _only(self, node: Node, known: dict[str, bool], *, free: bool) -> bool:
        match node:
            case Word() | WordClass():
                return False
            case Optional():
                return True
            case Choice(items):
                return any(self._only(item, known, free=free) for item in items)
            case Sequence(items) | AnyOrder(items):
                return all(self._only(item, known, free=free) for item in items)
            case Reference(name):
                phrase = self._grammar.phrases.get(name)
                if phrase is None:
                    slot = self._grammar.slots.get(name)
                    return free and slot is not None and slot.type in FREE_KINDS
                if name not in known:
                    known[name] = self._only(phrase, known, free=free)
                return known[name]

    def labels(self, node: Node) -> dict[str, int]:
        """Slot label to how often it can be said in one way through a template."""
        match node:
            case Word() | WordClass():
                return {}
            case Optional(item):
                return self.labels(item)
            case Choice(items):
                counts: dict[str, int] = {}
                for item in items:
                    for label, count in self.labels(item).items():
                        counts[label] = max(count, counts.get(label, 0))
                return counts
            case Sequence(items) | AnyOrder(items):
                counts = {}
                for item in items:
                    for label, count in self.labels(item).items():
                        counts[label] = count + counts.get(label, 0)
                return counts
            case Reference(name, label):
                slots = self._grammar.slots
                if name not in self._grammar.phrases:  # {far:distance} is told to be the other way round
                    return {name if name not in slots and label in slots else label: 1}
                if name not in self._labels:
                    self._labels[name] = self.labels(self._grammar.phrases[name])
                return self._labels[name]

    def always(self, node: Node) -> frozenset[str]:
        """The labels of the slots that are said in whatever way a template is."""
        match node:
            case Word() | WordClass() | Optional():
                return frozenset()
            case Choice(items):
                return frozenset.intersection(*map(self.always, items))
            case Sequence(items) | AnyOrder(items):
                return frozenset[str]().union(*map(self.always, items))
            case Reference(name, label):
                if name not in self._grammar.phrases:
                    return frozenset((label,))
                if name not in self._always:
                    self._always[name] = self.always(self._grammar.phrases[name])
                return self._always[name]

    # -- how wide ---------------------------------------------------------------------------------------------

    def entries(self, node: Node) -> int:
        """In how many networks a template may begin: what follows an empty part counts as well."""
        match node:
            case Word() | WordClass():
                return 0
            case Optional(item):
                return self.entries(item)
            case Choice(items):
                return sum(self.entries(item) for item in items)
            case Sequence(items):
                total = 0
                for item in items:
                    total += self.entries(item)
                    if not self.empty(item):
                        break
                    total += 1
                return total
            case AnyOrder(items):
                idle = sum(self.empty(item) for item in items)
                return (1 + sum(self.entries(item) for item in items)) * int(2**idle)
            case Reference(name):
                if name not in self._entries:
                    self._entries[name] = self._named_entries(name)
                return self._entries[name]

    def _named_entries(self, name: str) -> int:
        if name in self._grammar.phrases:
            return 1 + self.entries(self._grammar.phrases[name])
        slot = self._grammar.slots.get(name)
        if slot is None:
            return 1
        if slot.type in QUANTITY_KINDS:
            return QUANTITY_WAYS
        return 2 + sum(1 + self.entries(node) for _, node in slot.values)

    def widest(self, node: Node) -> int:
        """At most so many ways there are to go on from one place in a template, or from its beginning."""
        return max(self.entries(node), self._inside(node))

    def _inside(self, node: Node) -> int:
        match node:
            case Word() | WordClass():
                return 0
            case Optional(item):
                return self._inside(item)
            case Choice(items):
                return max(self._inside(item) for item in items)
            case Sequence(items):
                behind = 0
                most = 0
                for item in reversed(items):
                    most = max(most, self._inside(item) + behind)
                    behind = 1 + self.entries(item) + (behind if self.empty(item) else 0)
                return most
            case AnyOrder(items):
                return max(self._inside(item) for item in items) + self.entries(node)
            case Reference(name):
                if name not in self._widest:
                    phrase = self._grammar.phrases.get(name)
                    self._widest[name] = self._inside(phrase) if phrase is not None else QUANTITY_WAYS
                return self._widest[name]
