"""The words of a grammar."""

from __future__ import annotations

from collections.abc import Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.templates.template_tree import AnyOrder, Choice, Node, Optional, Sequence, Word

__all__ = ["listed_words", "vocabulary", "words_in"]


def vocabulary(grammar: Grammar) -> frozenset[str]:
    """Every word that stands in the sentences, phrases and lists of a grammar."""
    trees = [sentence.template for intent in grammar.intents.values() for sentence in intent.all_sentences]
    trees += grammar.phrases.values()
    trees += [node for slot in grammar.slots.values() for _, node in (*slot.values, *slot.units)]
    return frozenset(word for tree in trees for word in words_in(tree))


def listed_words(grammar: Grammar) -> frozenset[str]:
    """Every word of the values of its lists."""
    nodes = (node for slot in grammar.slots.values() if slot.type == "choice" for _, node in slot.values)
    return frozenset(word for node in nodes for word in words_in(node))


def words_in(node: Node) -> Iterator[str]:
    """The words of a template, without those of what it refers to."""
    match node:
        case Word(text):
            yield text
        case Optional(item):
            yield from words_in(item)
        case Choice(items) | Sequence(items) | AnyOrder(items):
            for item in items:
                yield from words_in(item)
