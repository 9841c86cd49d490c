"""Which numbers people say: of the angles by which they turn a robot nearly all are multiples of five degrees."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from intent_engine.interpretation import Interpretation
from intent_engine.language.grammar import Grammar
from intent_engine.language.grammar_intents import slots_by_label

__all__ = ["UsualNumbers"]

NEARLY = 1e-3
"""Steps by which a number may be beside a multiple: 90 degrees in rad is none but nearly."""


class UsualNumbers:
    """The steps in which the numbers of a grammar are usually said: ``usual_step`` of its slots."""

    def __init__(self, grammar: Grammar) -> None:
        self._steps: dict[str, dict[str, float]] = {}
        for name, intent in grammar.intents.items():
            slots = {**grammar.slots, **slots_by_label((one.template for one in intent.sentences), grammar)}
            steps = {label: slot.usual_step for label, slot in slots.items() if slot.usual_step is not None}
            if steps:
                self._steps[name] = steps

    def unusual(self, meaning: Interpretation) -> int:
        """Numbers in the slots of a sentence, those of several commands too, that are no multiples of their step."""
        if not self._steps:
            return 0
        return sum(
            abs(value / step - round(value / step)) > NEARLY
            for intent, slots in _commands(meaning.intent, meaning.slots)
            for label, step in self._steps.get(intent, {}).items()
            if isinstance(value := slots.get(label), float | int)
        )


def _commands(intent: str | None, slots: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Each command that was said: its intent and its slots."""
    steps = slots.get("steps")
    if isinstance(steps, list):
        for step in steps:
            yield from _commands(step.get("intent"), step.get("slots", {}))
    elif intent is not None:
        yield intent, slots
