"""What slots take, or never take, that their author may not have thought of."""

from __future__ import annotations

from collections.abc import Iterator

from intent_engine.errors import Problem
from intent_engine.language.grammar import Grammar, Slot, problem_at
from intent_engine.language.templates.template_tree import Node, Reference, Sequence

__all__ = ["slot_notes"]

MESSAGE_WORDS = 6
"""Words from which a text is hardly the name of a thing."""


def slot_notes(grammar: Grammar) -> Iterator[Problem]:
    """Percentages of more than the whole, and messages that hold no words that turn a sentence."""
    ends = {name for intent in grammar.intents.values() for one in intent.sentences for name in _last(one.template)}
    for slot in grammar.slots.values():
        if slot.type == "percent" and slot.maximum is None:
            yield problem_at(
                slot.place, f"slot {slot.name!r} takes 150 percent as well", "with 'max: 100 %' it does not"
            )
        if slot.name in ends and _is_message(slot):
            words = ", ".join(repr(word) for word in ("we", "if", "not") if word in grammar.operators.closed)
            message = f"slot {slot.name!r} takes no message with a word like {words}" if words else ""
            if message:
                yield problem_at(slot.place, message, "with 'dictation: true' it takes all that is said from there on")


def _is_message(slot: Slot) -> bool:
    return slot.type == "text" and slot.max_words >= MESSAGE_WORDS and not (slot.dictation or slot.known)


def _last(node: Node) -> Iterator[str]:
    """The slot or phrase with which a template ends."""
    match node:
        case Reference(name):
            yield name
        case Sequence(items) if items:
            yield from _last(items[-1])
