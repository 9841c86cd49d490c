"""What is taken by a hand, and what never is, though things are given to it or put there: people, and where one is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from intent_engine.language.grammar import ACTION_PARAMETERS, Grammar, Slot
from intent_engine.language.loading.grammar_intents import slot_of_parameter
from intent_engine.language.templates.template_tree import Node, Reference, references
from intent_engine.language.words.thing_words import ARTICLES, thing_words

__all__ = ["TakenThings"]


class TakenThings:
    """The slots of one grammar that hold a thing that is picked up or put somewhere, and those of type ``object``.
    Thread-safe."""

    def __init__(self, grammar: Grammar) -> None:
        self._words = words = thing_words(grammar.language)
        self._before = (words.articles or ARTICLES) | words.qualities
        self._grammar = grammar

    @cached_property
    def _held(self) -> frozenset[str]:
        return frozenset(_held(self._grammar))

    def __contains__(self, slot: Slot) -> bool:
        return slot.type == "object" or slot.name in self._held

    def stays(self, slot: Slot, said: Sequence[str]) -> str:
        """The word of a name that says that it is somebody, or where one is: "put the *man* in prison", "leave the old
        *house* by the stairs". Empty: there is none. A "bird house" is a thing, and what the slot knows or allows."""
        if slot.name not in self._held:  # an `object` may be what is looked at
            return ""
        at = next((at for at, word in enumerate(said) if word not in self._before), len(said) - 1)
        word, behind = said[at], said[at + 1 : at + 2]
        if word not in self._words.stays or word in slot.known or word in slot.allow:
            return ""
        return word if self._words.joining.issuperset(behind) else ""


def _held(grammar: Grammar) -> Iterator[str]:
    """The names of the slots whose thing is picked up or put somewhere."""
    for intent in grammar.intents.values():
        if "object" not in ACTION_PARAMETERS[intent.action.type]:
            continue
        label = slot_of_parameter(intent.action, "object")
        for sentence in intent.all_sentences:
            named = _references(grammar, sentence.template)
            yield from (one.name for one in named if one.label == label and one.name in grammar.slots)


def _references(grammar: Grammar, node: Node) -> Iterator[Reference]:
    """The slots that a template names, also in its phrases."""
    for reference in references(node):
        yield reference
        if (phrase := grammar.phrases.get(reference.name)) is not None:
            yield from _references(grammar, phrase)
