"""The sentences of a grammar nearest to words that are none of them, for "did you mean"."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import islice

from intent_engine.language.grammar import Sentence
from intent_engine.language.matcher import Matcher
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

__all__ = ["Nearest"]

MAX_OUTLINES = 2_000
"""Outlines kept for comparison; each sentence has a few."""
PER_SENTENCE = 12
CUTOFF = 55.0
"""rapidfuzz ``ratio`` below which a suggestion would only puzzle."""


class Nearest:
    """Suggestions, made at first need. Thread-safe: at worst the outlines are made twice."""

    def __init__(self, matcher: Matcher) -> None:
        self._matcher = matcher

    @cached_property
    def _outlines(self) -> list[str]:
        found: dict[str, None] = {}
        for sentence in self._whole_sentences():
            for words in islice(self._say(sentence.template, 0), PER_SENTENCE):
                found[" ".join(words)] = None
                if len(found) >= MAX_OUTLINES:
                    return list(found)
        return list(found)

    def _whole_sentences(self) -> Iterator[Sentence]:
        for intent in self._matcher.grammar.intents.values():
            yield from intent.sentences

    def sentences(self, words: list[str], most: int = 3) -> tuple[str, ...]:
        """Up to three sentences, with slots in braces, nearest first; none if none is near."""
        from rapidfuzz import fuzz, process

        text = " ".join(words[:20])
        best = process.extract(text, self._outlines, scorer=fuzz.ratio, limit=most, score_cutoff=CUTOFF)
        return tuple(outline for outline, _, _ in best)

    def _say(self, node: Node, depth: int) -> Iterator[tuple[str, ...]]:
        """A few ways to say a template, with the slots named."""
        grammar = self._matcher.grammar
        match node:
            case Word(text):
                yield (text,)
            case WordClass():
                yield ("<number>",)
            case Reference(name, label, _):
                if name in grammar.phrases and depth < 6:
                    yield from islice(self._say(grammar.phrases[name], depth + 1), 3)
                else:
                    yield ("{" + label + "}",)
            case Choice(items):
                for item in items[:4]:
                    yield from islice(self._say(item, depth), 2)
            case Optional(item):
                yield ()
                yield from islice(self._say(item, depth), 1)
            case Sequence(items) | AnyOrder(items):
                yield from self._joined(items, depth)

    def _joined(self, items: tuple[Node, ...], depth: int) -> Iterator[tuple[str, ...]]:
        if not items:
            yield ()
            return
        for head in self._say(items[0], depth):
            for tail in self._joined(items[1:], depth):
                yield (*head, *tail)
