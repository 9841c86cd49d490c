"""Which numbers people say: of the angles by which they turn a robot nearly all are multiples of five degrees, and no
distance is a hundred meters."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from intent_engine.actions import Turn
from intent_engine.interpretation import Interpretation
from intent_engine.language.grammar import Grammar, Slot
from intent_engine.language.loading.grammar_intents import slots_by_label
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import plain

__all__ = ["UsualNumbers", "circles"]

NEARLY = 1e-3
"""Steps by which a number may be beside a multiple: 90 degrees in rad is none but nearly."""
TIMES = 5.0
"""A number that is so many times as large as the most that people say is unusual twice, and so on. Of 358 distances
that people told a robot the largest are 20 feet (SCOUT); robots in a field go farther."""
MOST_PERCENT = 1.0
"""The most percent that people usually say, a whole, of a slot that names no limit of its own."""
FULL_CIRCLE = 2 * math.pi + 0.01
"""rad of a turn that people ask for, and a little."""


class UsualNumbers:
    """The numbers of a grammar as they are usually said: ``usual_step`` and ``usual_max`` of its slots."""

    def __init__(self, grammar: Grammar) -> None:
        self._language = grammar.language
        self._slots: dict[str, dict[str, Slot]] = {}
        self._fixed = {
            (name, label, value)
            for name, intent in grammar.intents.items()
            for sentence in intent.all_sentences
            for label, value in sentence.fixed.items()
            if isinstance(value, float | int)
        }
        """What a sentence says without a number: "a little"."""
        for name, intent in grammar.intents.items():
            slots = {**grammar.slots, **slots_by_label((one.template for one in intent.all_sentences), grammar)}
            known = {label: slot for label, slot in slots.items() if slot.usual_steps or _most(slot) is not None}
            if known:
                self._slots[name] = known

    def unusual(self, meaning: Interpretation) -> int:
        """How unusual the numbers in the slots of a sentence are, those of several commands too: one for each step of
        its slot that it is no multiple of, or if it is more than people say, and one more for each five times that it
        is as much."""
        if not self._slots:
            return 0
        return sum(
            _beside(value, slot.usual_steps) + _beyond(value, _most(slot)) for value, slot in self._said(meaning)
        )

    def more_than_whole(self, meaning: Interpretation) -> bool:
        """Whether it says more than a hundred percent of what names no limit: "two thousand" may be "two thirds"."""
        return any(_more_than_whole(value, slot) for value, slot in self._said(meaning))

    def _said(self, meaning: Interpretation) -> Iterator[tuple[float, Slot]]:
        """The numbers of a sentence that were said as such, each with its slot."""
        said = any(is_number(word, self._language) for word in plain(meaning.text))
        return (
            (value, slot)
            for intent, slots in _commands(meaning.intent, meaning.slots)
            for label, slot in self._slots.get(intent, {}).items()
            if isinstance(value := slots.get(label), float | int)
            and (said or (intent, label, value) not in self._fixed)
        )


def _more_than_whole(value: float, slot: Slot) -> bool:
    return slot.usual_max is None and _beyond(value, _most(slot)) > 0


def _beside(value: float, steps: Iterable[float]) -> int:
    """Of how many steps a number is no multiple."""
    return sum(abs(value / step - round(value / step)) > NEARLY for step in steps)


def _most(slot: Slot) -> float | None:
    """The most of a slot that people say; None: any."""
    if slot.usual_max is None and slot.maximum is None and slot.type == "percent":
        return MOST_PERCENT
    return slot.usual_max


def _beyond(value: float, most: float | None) -> int:
    """How far a number is beyond the most that people say."""
    if most is None or abs(value) <= most * (1 + NEARLY):
        return 0
    return 1 + int(math.log(abs(value) / most, TIMES))


def _commands(intent: str | None, slots: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Each command that was said: its intent and its slots."""
    steps = slots.get("steps")
    if isinstance(steps, list):
        for step in steps:
            yield from _commands(step.get("intent"), step.get("slots", {}))
    elif intent is not None:
        yield intent, slots


def circles(meaning: Interpretation) -> int:
    """Turns of more than a circle in a sentence."""
    return sum(isinstance(action, Turn) and abs(action.angle) > FULL_CIRCLE for action in meaning.actions)
