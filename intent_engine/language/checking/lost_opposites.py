"""Words of which one means the opposite of the other, where nothing tells the action which of them was said: who writes
"(open|close) the gripper" gets one command, and no program knows what to do of both.

Phrases are left out, of which one may have two dozen verbs that are much the same in a sentence ("pull up to", "push on
to"); and so are sentences that give a slot a value themselves, of which their author has thought.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import combinations

from intent_engine.errors import Problem
from intent_engine.language.grammar import Grammar, Intent, Sentence, problem_at
from intent_engine.language.templates.template_tree import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Word,
    template_text,
)
from intent_engine.language.templates.template_tree import Sequence as Row
from intent_engine.language.words.opposites import opposed

__all__ = ["lost_opposites"]

_STOP = "stop"


def lost_opposites(grammar: Grammar) -> Iterator[Problem]:
    """A problem for each two such words of an intent that does something."""
    for intent in grammar.intents.values():
        if intent.action.type == _STOP:
            continue
        found: dict[tuple[str, str], Sentence] = {}
        for sentence in (one for one in intent.sentences if not one.fixed):
            for choice in _choices(sentence.template):
                for one, other in combinations(map(_words, choice.items), 2):
                    if (two := _opposites(one, other, grammar.language)) is not None:
                        found.setdefault(two, sentence)
        for (one, other), sentence in {**dict(_of_sentences(intent, grammar.language)), **found}.items():
            yield problem_at(
                sentence.place,
                f"{one!r} and {other!r} are opposites, and nothing tells the action of {intent.name!r} which was said",
                f"make a slot of them, {{does}} with values: [{one}, {other}], or an intent of each",
            )


def _of_sentences(intent: Intent, language: str) -> Iterator[tuple[tuple[str, str], Sentence]]:
    """The same of sentences that differ in one such word, and give the same values."""
    for one, other in combinations(intent.sentences, 2):
        rows = [template_text(sentence.template).split() for sentence in (one, other)]
        differ = [pair for pair in zip(*rows, strict=False) if pair[0] != pair[1]]
        if len(rows[0]) == len(rows[1]) and len(differ) == 1 and not (one.fixed or other.fixed):
            ((word, against),) = differ
            if (two := _opposites([word], [against], language)) is not None:
                yield two, other


def _choices(node: Node) -> Iterator[Choice]:
    """The alternatives that are written in a template."""
    match node:
        case Optional(item):
            yield from _choices(item)
        case Choice(items) | Row(items) | AnyOrder(items):
            if isinstance(node, Choice):
                yield node
            for item in items:
                yield from _choices(item)


def _words(node: Node) -> Collection[str]:
    """The words of an alternative; none where it has a slot, which may tell."""
    items = node.items if isinstance(node, Row) else (node,)
    words = [item.text for item in items if isinstance(item, Word)]
    return words if len(words) == len(items) else ()


def _opposites(one: Collection[str], other: Collection[str], language: str) -> tuple[str, str] | None:
    """The words by which two alternatives mean the opposite; None: they do not."""
    ways: Sequence[tuple[str, str]] = [
        (word, against)
        for word in one
        if word not in other
        for against in other
        if against not in one and against in opposed(word, language)
    ]
    return ways[0] if ways else None
