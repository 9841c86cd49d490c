"""Slot values of a label: read as the grammar's slots have them, or refused where no sentence gives them."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any

from intent_engine.engine import IntentEngine
from intent_engine.evaluation.sameness import same
from intent_engine.hints import did_you_mean
from intent_engine.language import quantities
from intent_engine.language.grammar import QUANTITY_KINDS, Grammar, Intent, Slot
from intent_engine.language.loading.grammar_intents import all_slots_by_label
from intent_engine.language.locations import LocationMap
from intent_engine.language.normalize import words_of

__all__ = ["SlotValueError", "SlotValues"]

MOST_NAMED = 12
"""Values that a hint lists."""
UNITS: Mapping[str, str] = {
    "distance": "m",
    "angle": "rad",
    "duration": "s",
    "speed": "m/s",
    "angular_speed": "rad/s",
    "percent": "1 for 100 %",
}
"""In what a plain number of a label is counted."""
EXAMPLES: Mapping[str, str] = {
    "distance": "2 m",
    "angle": "90 deg",
    "duration": "3 s",
    "speed": "0.5 m/s",
    "angular_speed": "30 deg/s",
    "percent": "50 %",
}


class SlotValueError(ValueError):
    """A slot cannot have a value.

    Args:
        message: what is wrong.
        hint: what to write.
    """

    def __init__(self, message: str, hint: str | None) -> None:
        super().__init__(message)
        self.hint = hint


class SlotValues:
    """The values that the slots of each intent can have.

    Args:
        engine: of the grammars and the map.
    """

    def __init__(self, engine: IntentEngine) -> None:
        self._places = engine.locations
        self._intents: dict[str, dict[str, list[tuple[Slot, str]]]] = {}
        self._given: dict[tuple[str, str], list[Any]] = {}
        for grammar in engine.grammars:
            for intent in grammar.intents.values():
                self._learn(grammar, intent)

    def _learn(self, grammar: Grammar, intent: Intent) -> None:
        if intent.regex or intent.lark:
            return  # a pattern may give anything
        slots = all_slots_by_label((sentence.template for sentence in intent.all_sentences), grammar)
        known = self._intents.setdefault(intent.name, {})
        for label, found in slots.items():
            known.setdefault(label, []).extend((slot, grammar.language) for slot in found)
        fixed = [sentence.fixed for sentence in intent.all_sentences]
        for values in (*fixed, intent.defaults, *(condition.defaults for condition in intent.when)):
            for label, value in values.items():
                self._given.setdefault((intent.name, label), []).append(value)

    def read(self, intent: str, label: str, value: Any) -> Any:
        """A label's value as the engine gives it: ``"2 m"`` as 2.0.

        Raises:
            SlotValueError: no sentence of the intent gives it.
        """
        slots = self._intents.get(intent, {}).get(label)
        if not slots or any(same(value, one) for one in self._given.get((intent, label), ())):
            return value
        problems = []
        for slot, language in slots:
            try:
                return _value(slot, label, language, value, self._places)
            except SlotValueError as error:
                problems.append(error)
        raise problems[0]


def _value(slot: Slot, label: str, language: str, value: Any, places: LocationMap | None) -> Any:
    if slot.type in ("choice", "boolean"):
        return _named(label, value, [one for one, _ in slot.values])
    if slot.type == "location" and places is not None:
        return _named(label, value, list(places))
    if slot.type in QUANTITY_KINDS:
        return _quantity(slot, label, language, value)
    return value


def _named(label: str, value: Any, known: Sequence[Any]) -> Any:
    if any(same(value, one) for one in known):
        return value
    names = [str(one) for one in known]
    raise SlotValueError(f"{value!r} is no value of slot {label!r}", _nearest(str(value), names))


def _nearest(value: str, names: Collection[str]) -> str | None:
    more = ", ..." if len(names) > MOST_NAMED else ""
    listed = f"there is {', '.join(list(names)[:MOST_NAMED])}{more}" if names else None
    return did_you_mean(value, names) or listed


def _quantity(slot: Slot, label: str, language: str, value: Any) -> float:
    number = value
    if isinstance(value, str):
        words = [*words_of(value)]
        # Units are written alike in all languages; words are those of the grammar.
        number = quantities.evaluate(words, slot.type, language, slot.unit)
        if not isinstance(number, float):
            number = quantities.evaluate(words, slot.type, "en", slot.unit)
    if isinstance(number, bool) or not isinstance(number, (int, float)):
        raise SlotValueError(f"{value!r} is no {slot.type.replace('_', ' ')} (slot {label!r})", _how(slot))
    beyond = slot.beyond(number)
    if beyond is not None or number != number:
        why = beyond[1] if beyond is not None else "no number"
        raise SlotValueError(f"{value!r}, which is {slot.written(number)}, is {why} (slot {label!r})", _how(slot))
    return number


def _how(slot: Slot) -> str:
    if slot.type not in UNITS:
        return "give a number"
    return f'give a number ({UNITS[slot.type]}), or a text with its unit: "{EXAMPLES[slot.type]}"'
