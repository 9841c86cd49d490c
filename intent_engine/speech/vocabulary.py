"""The words of a grammar, as a text that a Whisper model is shown before it listens.

Whisper takes what was said before as context. Shown the names and words of the grammar it writes "light roast" where it
would have written "light rose", at no cost in time. It also writes them where they were not said, so its words are then
only a second draft; whether a command was said is judged without the hint.
"""

from __future__ import annotations

from itertools import islice

from intent_engine.language.exploration import vocabulary as grammar_words
from intent_engine.language.free_text import ARTICLES
from intent_engine.language.grammar import Slot
from intent_engine.language.matcher import Matcher, spoken_trees
from intent_engine.language.numbers.english import NUMBER_WORDS
from intent_engine.language.spellings import spellings
from intent_engine.language.template_tree import AnyOrder, Choice, Node, Optional, Sequence, Word
from intent_engine.language.utterance import Utterance

__all__ = ["known_words", "vocabulary"]

MAX_NAMES = 60
"""Names of places; a map with thousands would crowd out everything else."""
MAX_VALUES = 24
"""Values of one slot."""


def vocabulary(matcher: Matcher, most_letters: int = 700) -> str:
    """Words and names of a grammar, most telling first: values of slots, names of places, words of sentences."""
    seen: dict[str, None] = {}
    for slot in matcher.grammar.slots.values():
        for text in _slot_texts(slot, matcher):
            seen.setdefault(text)
    for _, sentence in matcher.sentences:
        for word in _words(sentence.template):
            if len(word) > 3:
                seen.setdefault(word)
    kept: list[str] = []
    letters = 0
    for text in seen:
        letters += len(text) + 2
        if letters > most_letters:
            break
        kept.append(text)
    return ", ".join(kept) + "." if kept else ""


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


def _slot_texts(slot: Slot, matcher: Matcher) -> list[str]:
    if slot.type == "location" and matcher.locations is not None:
        return list(islice(matcher.locations, MAX_NAMES))
    texts: dict[str, None] = {}
    known: set[str] = set()
    for _, node in slot.values:
        for words in spellings(node, matcher.grammar.phrases, 1):
            # "a little bit of skim milk" shows nothing that "skim milk" has not shown
            new = [word for word in words if word not in known]
            if new:
                texts.setdefault(" ".join(words))
                known.update(words)
    return list(islice(texts, MAX_VALUES))


def _words(node: Node) -> list[str]:
    match node:
        case Word(text):
            return [text]
        case Sequence(items) | Choice(items) | AnyOrder(items):
            return [word for item in items for word in _words(item)]
        case Optional(item):
            return _words(item)
    return []
