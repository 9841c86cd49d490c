"""The words of a grammar, for telling what a free slot took from what the grammar has."""

from __future__ import annotations

from intent_engine.language.exploration import vocabulary as grammar_words
from intent_engine.language.free_text import ARTICLES
from intent_engine.language.matcher import Matcher, spoken_trees
from intent_engine.language.numbers.english import NUMBER_WORDS
from intent_engine.language.template_tree import AnyOrder, Choice, Node, Optional, Sequence, Word
from intent_engine.language.utterance import Utterance

__all__ = ["known_words"]


def known_words(matcher: Matcher) -> frozenset[str]:
    """Every word that a list of the grammar has: those of sentences, values, quantities, places and free slots."""
    grammar = matcher.grammar
    found = set(NUMBER_WORDS) | set(grammar_words(grammar)) | ARTICLES
    for node in spoken_trees(grammar.language).values():
        found.update(_words(node))
    for slot in grammar.slots.values():
        found |= slot.known
    found.update(word for words in (*grammar.fillers, *grammar.wake, *grammar.operators.sequence) for word in words)
    for name in matcher.locations or ():
        found.update(Utterance.of(name, grammar.language).words)
    return frozenset(found)


def _words(node: Node) -> list[str]:
    match node:
        case Word(text):
            return [text]
        case Sequence(items) | Choice(items) | AnyOrder(items):
            return [word for item in items for word in _words(item)]
        case Optional(item):
            return _words(item)
    return []
