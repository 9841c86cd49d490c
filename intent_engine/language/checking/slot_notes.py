"""What slots take, or never take, that their author may not have thought of."""

from __future__ import annotations

from collections.abc import Iterator

from intent_engine.errors import Problem
from intent_engine.language.grammar import Grammar, Slot, problem_at
from intent_engine.language.templates.template_tree import Reference, Sequence, references

__all__ = ["slot_notes"]

MESSAGE_WORDS = 6
"""Words from which a text is hardly the name of a thing."""


def slot_notes(grammar: Grammar) -> Iterator[Problem]:
    """Percentages of more than the whole, and messages that hold no words that turn a sentence."""
    ends = _always_last(grammar)
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


def _always_last(grammar: Grammar) -> set[str]:
    """Slots with which sentences end, and that stand nowhere else: what is dictated may not."""
    ends: set[str] = set()
    elsewhere = [*grammar.phrases.values()]
    for intent in grammar.intents.values():
        for sentence in intent.all_sentences:
            node = sentence.template
            *before, last = node.items if isinstance(node, Sequence) and node.items else (node,)
            if isinstance(last, Reference):
                ends.add(last.name)
            else:
                before.append(last)
            elsewhere += before
    return ends - {reference.name for node in elsewhere for reference in references(node)}
