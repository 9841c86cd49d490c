"""What slots take, or never take, that their author may not have thought of."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from intent_engine.errors import Problem
from intent_engine.language.grammar import QUANTITY_KINDS, Grammar, Slot, problem_at
from intent_engine.language.templates.template_tree import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    references,
)

__all__ = ["slot_notes"]

MESSAGE_WORDS = 6
"""Words from which a text is hardly the name of a thing."""


def slot_notes(grammar: Grammar) -> Iterator[Problem]:
    """Percentages of more than the whole, messages without words that turn a sentence, and numbers side by side."""
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
    for intent in grammar.intents.values():
        for sentence in intent.all_sentences:
            for one, other in dict.fromkeys(_side_by_side(grammar, sentence.template)):
                message = f"{{{one}}} and {{{other}}} are numbers side by side: what could be one number is refused"
                yield problem_at(sentence.place, message, f"put a word between them: {{{one}}} with {{{other}}}")


def _side_by_side(grammar: Grammar, node: Node) -> Iterator[tuple[str, str]]:
    """The labels of a number and of an amount that follows it without a word between them."""
    match node:
        case Reference(name) if name in grammar.phrases:
            yield from _side_by_side(grammar, grammar.phrases[name])
        case Optional(item):
            yield from _side_by_side(grammar, item)
        case Choice(items) | Sequence(items) | AnyOrder(items):
            for one, other in pairwise(items) if isinstance(node, Sequence) else ():
                number, amount = _amount(grammar, one, at=-1), _amount(grammar, other, at=0)
                if number is not None and amount is not None:
                    slot = grammar.slots[number.name]
                    if slot.type == "number" and not slot.units and grammar.slots[amount.name].type != "ordinal":
                        yield number.label, amount.label
            for item in items:
                yield from _side_by_side(grammar, item)


def _amount(grammar: Grammar, node: Node, *, at: int) -> Reference | None:
    """A quantity with which that begins (``at`` 0) or ends (-1)."""
    while isinstance(node, Optional) or (isinstance(node, Sequence) and node.items):
        node = node.item if isinstance(node, Optional) else node.items[at]
    slot = grammar.slots.get(node.name) if isinstance(node, Reference) and node.name not in grammar.phrases else None
    return node if isinstance(node, Reference) and slot is not None and slot.type in QUANTITY_KINDS else None


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
