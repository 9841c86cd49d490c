"""Values in a grammar, checked against the slots and actions that take them: defaults, conditions, examples."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from intent_engine.errors import Problem
from intent_engine.hints import did_you_mean
from intent_engine.language.grammar import (
    ACTION_PARAMETERS,
    FREE_KINDS,
    QUANTITY_KINDS,
    ActionSpec,
    Grammar,
    Intent,
    Sentence,
    Slot,
    problem_at,
)
from intent_engine.language.loading.grammar_intents import amount_labels, slot_of_parameter, slots_by_label
from intent_engine.language.loading.grammar_parts import Places, hardly_meant
from intent_engine.language.loading.yaml_source import YamlPath

__all__ = ["action_problems", "doubtful_numbers", "example_problems", "value_problems"]

REQUIRED: Mapping[str, tuple[str, ...]] = {
    "navigate": ("location",),
    "pick": ("object",),
    "change_speed": ("factor",),
    "turn": ("direction",),
    "move": ("direction",),
}
"""Parameters without which an action cannot be made. A move's or turn's direction may come from the sentence's own
slots, a default or the sign of its distance or angle."""

DIRECTIONS: Mapping[str, frozenset[str]] = {
    "move": frozenset(("forward", "forwards", "backward", "backwards", "back")),
    "turn": frozenset(("left", "right", "clockwise", "counterclockwise", "anticlockwise")),
}
"""What the directions of an action are called in every language; the words that are said stand in the slot's lists."""


def value_problems(grammar: Grammar, intent: Intent, labels: set[str], places: Places) -> Iterator[Problem]:
    """Defaults, conditions and fixed slots: names that something takes, values that the slot can have."""
    base: YamlPath = ("intents", intent.name)
    slots = _slots_of(grammar, intent)
    yield from _defaults(intent, intent.defaults, labels, slots, (*base, "defaults"), places)
    for index, condition in enumerate(intent.when):
        at = (*base, "when", index)
        for label, value in condition.slots.items():
            if label not in labels and not _patterns(intent):
                message = f"'when' asks for slot {label!r}, which no sentence has"
                yield places.problem((*at, "slots", label), message, _near(label, labels), key=True)
            else:
                yield from _value(slots.get(label), value, (*at, "slots", label), places)
        yield from _defaults(intent, condition.defaults, labels, slots, (*at, "defaults"), places)
    for sentence in intent.all_sentences:
        yield from _fixed(intent, sentence, slots, grammar)


def _defaults(
    intent: Intent,
    defaults: Mapping[str, Any],
    labels: set[str],
    slots: Mapping[str, Slot],
    at: YamlPath,
    places: Places,
) -> Iterator[Problem]:
    known = {*labels, *ACTION_PARAMETERS[intent.action.type]}
    for key, value in defaults.items():
        if key not in known and not _patterns(intent) and intent.action.type != "custom":
            yield places.problem((*at, key), f"a default for {key!r}, which nothing takes", _near(key, known), key=True)
            continue
        yield from _value(slots.get(slot_of_parameter(intent.action, key)), value, (*at, key), places)
        if key == "direction" and key not in slots:
            yield from _direction(intent.action.type, value, (*at, key), places)
        if wrong := _undrivable(intent.action, key, value, led=_led(intent, labels)):
            yield places.problem((*at, key), *wrong)
    given = [key for key in defaults if key in amount_labels(intent.action)]
    if len(given) > 1:
        message = f"only one of {' and '.join(map(repr, given))} can hold where neither was said"
        yield places.problem((*at, given[1]), message, "remove one; how fast is its speed", key=True)


def _undrivable(action: ActionSpec, key: str, value: Any, *, led: bool) -> tuple[str, str] | None:
    """What is wrong with a number that no robot can move by, and what to do; None: it can, or ``key`` is something
    else.

    Args:
        led: whether something else gives the direction; where nothing does, the sign of how far may.
    """
    known = ACTION_PARAMETERS[action.type]
    parameter = next((one for one in known if key in (one, slot_of_parameter(action, one))), "")
    if known.get(parameter) not in QUANTITY_KINDS or not isinstance(value, int | float) or isinstance(value, bool):
        return None
    if value > 0 or (value < 0 and parameter in ("distance", "angle") and not led):
        return None
    message = f"{_a(parameter)} of {value:g} cannot be driven"
    if parameter == "speed":
        way = {"move": "backward", "turn": "right"}[action.type]
        return message, f"write it without a sign, and direction: {way}" if value else "write how fast; or action: stop"
    if parameter == "factor":
        return message, "more than 1 is faster, and less is slower: 0.5; or action: stop"
    if not value or parameter == "duration":
        return message, "more than 0; or leave it out"
    return f"{_a(parameter)} below zero would turn the direction round", "write it without a sign"


def _led(intent: Intent, labels: Iterable[str]) -> bool:
    """Whether an intent has a direction, said or not."""
    given = {*labels, *intent.defaults, *(label for one in intent.when for label in one.defaults)}
    known = given & {"direction", slot_of_parameter(intent.action, "direction")}
    return bool(known) or _patterns(intent) or _constant(intent.action, "direction")


def _near(word: str, known: Iterable[str]) -> str:
    return did_you_mean(word, known) or f"known: {', '.join(sorted(known)) or 'none'}"


def _value(slot: Slot | None, value: Any, at: YamlPath, places: Places) -> Iterator[Problem]:
    """A value that a slot could not have been given by words."""
    wrong = _why_not(slot, value)
    if wrong is not None:
        yield places.problem(at, *wrong)


def _why_not(slot: Slot | None, value: Any) -> tuple[str, str | None] | None:
    if slot is None:
        return None
    if slot.type in ("choice", "boolean"):
        known = [one for one, _ in slot.values]
        if not any(one == value or str(one) == str(value) for one in known):
            if slot.type == "boolean":
                return f"{value!r} is no value of slot {slot.name!r}", "write true or false, without quotes"
            names = [str(one) for one in known]
            hint = did_you_mean(str(value), names) or f"one of: {', '.join(names)}"
            return f"{value!r} is no value of slot {slot.name!r}", hint
    elif slot.type in QUANTITY_KINDS and isinstance(value, (int, float)) and (beyond := slot.beyond(value)) is not None:
        return f"{slot.written(value)} is {beyond[1]} (slot {slot.name!r})", f"change it or {beyond[0]}:"
    return None


def _fixed(intent: Intent, sentence: Sentence, slots: Mapping[str, Slot], grammar: Grammar) -> Iterator[Problem]:
    """Slots that a sentence has without saying them; their place is the sentence's."""
    taken = {slot_of_parameter(intent.action, name) for name in ACTION_PARAMETERS[intent.action.type]}
    for label, value in sentence.fixed.items():
        wrong = _why_not(slots.get(label) or grammar.slots.get(label), value)
        known = {*taken, *slots}
        if intent.action.type != "custom" and label not in known:
            wrong = (f"slot {label!r} is taken by nothing", _near(label, known))
        if wrong is None:
            own = {*sentence.fixed, *slots_by_label((sentence.template,), grammar)}
            wrong = _undrivable(intent.action, label, value, led=_led(intent, own))
        if wrong is not None and sentence.place is not None:
            place = sentence.place
            yield problem_at(place, wrong[0], wrong[1])


def _slots_of(grammar: Grammar, intent: Intent) -> dict[str, Slot]:
    return slots_by_label((sentence.template for sentence in intent.all_sentences), grammar)


def _patterns(intent: Intent) -> bool:
    """Whether slots may come from patterns, so that no list of them is complete."""
    return bool(intent.regex or intent.lark)


# -- actions --------------------------------------------------------------------------------------------------


def action_problems(grammar: Grammar, intent: Intent, given: Sequence[set[str]], places: Places) -> Iterator[Problem]:
    """An action takes slots that there are, of kinds that it can use, and gets what it cannot do without.

    Args:
        given: for each sentence, the labels of the slots that it can give.
    """
    action = intent.action
    labels = set[str]().union(*given)
    base: YamlPath = ("intents", intent.name, "action")
    slots = _slots_of(grammar, intent)
    missing: set[str] = set()
    for parameter, taken in action.parameters.items():
        if isinstance(taken, str) and taken.startswith("{"):
            label = taken.strip("{}")
            if label not in labels and label not in intent.defaults and not _patterns(intent):
                missing.add(parameter)
                message = f"the action takes {taken}, which no sentence of {intent.name!r} has"
                yield places.problem(
                    (*base, parameter), message, _near(label, labels) if labels else _takes(label, grammar)
                )
        elif parameter == "direction":
            yield from _direction(action.type, taken, (*base, parameter), places)
        else:
            if wrong := _undrivable(action, parameter, taken, led=_led(intent, labels)):
                yield places.problem((*base, parameter), *wrong)
    for parameter, kind in ACTION_PARAMETERS[action.type].items():
        label = slot_of_parameter(action, parameter)
        slot = slots.get(label) or (grammar.slots.get(label) if _patterns(intent) else None)
        if slot is None:
            continue
        if kind in QUANTITY_KINDS and slot.type not in (kind, "number"):
            message = f"the {parameter} of {action.type} is {_a(kind)}, and slot {slot.name!r} is {_a(slot.type)}"
            at = (*base, parameter) if parameter in action.parameters else ("slots", slot.name)
            yield places.problem(at, message, f"give it a slot of type {kind}")
        elif kind == "location" and slot.type not in ("location", "choice"):
            message = f"the {parameter} of {action.type} is a place on the map, and slot {slot.name!r} is {slot.type}"
            yield places.problem(("slots", slot.name), message, f"{slot.name}: {{type: location}}")
        elif parameter == "direction" and slot.type == "choice":
            for value, _ in slot.values:
                at = ("slots", slot.name, "values", value)
                yield from _direction(action.type, value, at, places, f" (slot {slot.name!r})")
    for sentence, own in zip(intent.all_sentences, given, strict=True):
        yield from _complete(intent, sentence, own, missing, grammar)


def _takes(label: str, grammar: Grammar) -> str:
    return did_you_mean(label, grammar.slots) or f"add {{{label}}} to a sentence, or write a value"


def _a(kind: str) -> str:
    return ("an " if kind[0] in "aeiou" else "a ") + kind.replace("_", " ")


def _direction(action: str, value: Any, at: YamlPath, places: Places, where: str = "") -> Iterator[Problem]:
    known = DIRECTIONS.get(action)
    if known is not None and value not in known:
        first, second = ("forward", "backward") if action == "move" else ("left", "right")
        message = f"{action} knows the directions {first} and {second}, not {value!r}{where}"
        yield places.problem(
            at, message, f"name the values so, and list the words that are said: {first}: [...]", key=True
        )


def _complete(
    intent: Intent, sentence: Sentence, given: set[str], missing: set[str], grammar: Grammar
) -> Iterator[Problem]:
    """Every sentence must be able to give what its action cannot do without."""
    given = {*given, *intent.defaults}
    for condition in intent.when:
        given.update(condition.defaults)
    action = intent.action
    for parameter in REQUIRED.get(action.type, ()):
        taken = action.parameters.get(parameter, "{" + parameter + "}")
        if (
            parameter in missing
            or _fixed_amiss(action, sentence)
            or not (isinstance(taken, str) and taken.startswith("{"))
        ):
            continue
        label = taken.strip("{}")
        if label in given or parameter in given or (parameter == "direction" and _signed(action, given)):
            continue
        message = f"{action.type} needs {parameter!r}, and this sentence cannot give it"
        hint = f"add {{{label}}} to the sentence, slots: {{{label}: ...}} beside it, or a default"
        if (other := _could_give(action.type, parameter, sentence, grammar)) is not None:
            hint = f'if that is {{{other}}}: action: {{type: {action.type}, {parameter}: "{{{other}}}"}}'
        place = sentence.place
        if place is not None:
            yield problem_at(place, message, hint)


def _signed(action: ActionSpec, given: set[str]) -> bool:
    """Whether there is a distance or an angle, whose sign may be the direction."""
    amounts = [one for one in ("distance", "angle") if one in ACTION_PARAMETERS[action.type]]
    return any(one in given or slot_of_parameter(action, one) in given or _constant(action, one) for one in amounts)


def _constant(action: ActionSpec, parameter: str) -> bool:
    return parameter in action.parameters and not str(action.parameters[parameter]).startswith("{")


def _could_give(action: str, parameter: str, sentence: Sentence, grammar: Grammar) -> str | None:
    """The one slot of a sentence that holds what a parameter takes, under another name."""
    found = []
    for label, slot in slots_by_label((sentence.template,), grammar).items():
        if parameter == "direction":
            fits = bool(slot.values) and DIRECTIONS[action].issuperset(value for value, _ in slot.values)
        elif parameter == "location":
            fits = slot.type == "location"
        else:
            fits = slot.type in FREE_KINDS
        if fits:
            found.append(label)
    return found[0] if len(found) == 1 else None


def _fixed_amiss(action: ActionSpec, sentence: Sentence) -> bool:
    """Whether a fixed slot may be the missing one misspelt; it has been told of already."""
    taken = {slot_of_parameter(action, name) for name in ACTION_PARAMETERS[action.type]}
    return any(did_you_mean(label, taken) for label in sentence.fixed if label not in taken)


# -- examples -------------------------------------------------------------------------------------------------


def example_problems(grammar: Grammar, intent: Intent, labels: set[str]) -> Iterator[Problem]:
    """Examples whose slots no sentence has, and plain numbers in them that are hardly meant: degrees, say. Whether they
    are understood so is a question for ``check`` and ``test``."""
    if _patterns(intent):
        return
    slots = _slots_of(grammar, intent)
    for example in intent.examples:
        if not isinstance(example.expected, Mapping) or example.place is None:
            continue
        for label in example.expected:
            if label not in labels and label != "steps":
                message = f"the example has slot {label!r}, which no sentence of {intent.name!r} has"
                hint = _near(str(label), labels) if labels else "{} stands for no slots"
                yield problem_at(example.place, message, hint)
        kinds = {label: slot.type for label, slot in slots.items()}
        for message, hint in doubtful_numbers(example.expected, kinds):
            yield problem_at(example.place, message, hint)


def doubtful_numbers(expected: Mapping[str, Any], kinds: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """What is wrong with numbers that somebody expects of slots, by the kinds of these, and what to write: 90 for an
    angle would be fourteen turns."""
    for label, value in _numbers(expected):
        if label in kinds and (doubt := hardly_meant(kinds[label], value)) is not None:
            yield f"slot {label!r}: {doubt[0]}", doubt[1]


def _numbers(expected: Mapping[str, Any]) -> Iterator[tuple[str, float]]:
    """The plain numbers of an example, by slot; those of its steps too."""
    for label, value in expected.items():
        if isinstance(value, int | float) and not isinstance(value, bool):
            yield label, value
        elif label == "steps" and isinstance(value, list):
            for step in value:
                yield from _numbers(step) if isinstance(step, Mapping) else ()
