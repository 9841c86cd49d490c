"""Where the values of a command come from: said, of the sentence, or a default that made a difference."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from intent_engine.language.explanation import Candidate, SlotSource
from intent_engine.language.grammar import Intent, Place
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.quantities import Relative
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.slots.action_builder import CannotActError, build_action, defaults_of, holds

__all__ = ["candidate", "sources"]


def candidate(reading: Reading, refused: str) -> Candidate:
    """A reading as it is told, and why it was not taken."""
    return Candidate(
        reading.intent.name,
        reading.sentence.text.strip(),
        _at(reading.sentence.place or reading.intent.place),
        " ".join(reading.words),
        (*(_said(slot, reading) for slot in reading.slots), *_fixed(reading)),
        round(reading.score, 4),
        reading.intent.priority,
        reading.free_words,
        refused,
    )


def _at(place: Place | None) -> str:
    return f"{place.file}:{place.line}" if place is not None else ""


def _value(value: Any) -> Any:
    return value.factor if isinstance(value, Relative) else value


def _said(slot: SlotReading, reading: Reading) -> SlotSource:
    words = " ".join(reading.words[slot.start : slot.end])
    rivals = tuple((name, round(score, 3)) for name, score in slot.rivals)
    return SlotSource(slot.label, _value(slot.value), "said", words, slot.status, round(slot.score, 3), rivals)


def _fixed(reading: Reading) -> list[SlotSource]:
    spoken = {slot.label for slot in reading.slots}
    return [
        SlotSource(label, value, "sentence") for label, value in reading.sentence.fixed.items() if label not in spoken
    ]


def sources(clause: Clause, locations: Any) -> tuple[SlotSource, ...]:
    """Every value of a command: said, fixed by the sentence, or a default that made a difference."""
    reading = clause.reading
    if reading is None:
        return ()
    found = [*(_said(slot, reading) for slot in reading.slots), *_fixed(reading)]
    intent, values = reading.intent, reading.values()
    for label, value in defaults_of(intent, values).items() if clause.accepted else ():
        if _mattered(intent, values, label, locations):
            condition = next(
                (one for one in reversed(intent.when) if label in one.defaults and holds(one, values)), None
            )
            words = ", ".join(f"{name}: {one}" for name, one in condition.slots.items()) if condition else ""
            found.append(SlotSource(label, _value(value), "condition" if condition else "default", words))
    return tuple(found)


def _mattered(intent: Intent, values: Mapping[str, Any], label: str, locations: Any) -> bool:
    """Whether the action would be another with another default."""

    def other(defaults: Mapping[str, Any]) -> dict[str, Any]:
        changed = dict(defaults)
        if isinstance(changed.get(label), (int, float)):
            changed[label] = changed[label] * 1.5 + 0.1
        else:
            changed.pop(label, None)
        return changed

    conditions = tuple(replace(one, defaults=other(one.defaults)) for one in intent.when)
    changed = replace(intent, defaults=other(intent.defaults), when=conditions)
    try:
        return build_action(changed, values, locations) != build_action(intent, values, locations)
    except CannotActError:
        return True
