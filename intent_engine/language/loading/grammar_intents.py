"""Intents of a grammar file: sentences, action, defaults, conditions and examples."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from intent_engine.hints import did_you_mean
from intent_engine.language.grammar import (
    ACTION_PARAMETERS,
    LONGEST_WAIT,
    QUANTITY_KINDS,
    ActionSpec,
    Condition,
    Example,
    Grammar,
    Intent,
    Sentence,
    Slot,
)
from intent_engine.language.loading.grammar_parts import PartReader
from intent_engine.language.loading.other_words import ACTIONS, meant
from intent_engine.language.loading.yaml_source import YamlPath
from intent_engine.language.templates.template_tree import Node, references

__all__ = ["amount_labels", "merged", "read_intent", "slot_of_parameter", "slots_by_label", "with_defaults"]

RESULTS = ("accepted", "rejected", "ambiguous", "incomplete")
"""What an example may say of a sentence instead of its slots."""
_SLOT = re.compile(r"\{\w+\}")
_AMOUNTS: Mapping[str, tuple[str, str]] = {"move": ("distance", "duration"), "turn": ("angle", "duration")}


def read_intent(
    parts: PartReader,
    path: YamlPath,
    name: str,
    spec: Mapping[str, Any],
    known: Grammar,
) -> Intent:
    """The intent at a path of a file; what is wrong in it is told, and left out of it.

    Args:
        known: the slots and phrases of all files, and the intents of those before this one.
    """
    source = parts.source
    if any(broken[: len(path)] == path for broken in source.broken):
        parts.draft.partial.add(name)
    action = _action(parts, (*path, "action"), name, spec.get("action", "custom"))
    read: dict[str, list[tuple[YamlPath, Any, Node]]] = {"sentences": [], "then": []}
    for key, templates in read.items():
        for at, _, entry in source.entries((*path, key), spec.get(key)):
            said = (*at, "say") if isinstance(entry, dict) else at
            if said in source.broken:
                continue
            node = parts.template(said, entry["say"] if isinstance(entry, dict) else entry, "sentence", name)
            if node is None:
                parts.draft.partial.add(name)
            else:
                templates.append((at, entry, node))
        if (*path, key) in source.broken:
            parts.draft.partial.add(name)
    before = known.intents.get(name)
    usual = before.priority if before else 0
    nodes = [node for templates in read.values() for _, _, node in templates]
    nodes += [one.template for one in (before.all_sentences if before else ())]
    slots = {**known.slots, **slots_by_label(nodes, known)}
    sentences: dict[str, list[Sentence]] = {"sentences": [], "then": []}
    for key, templates in read.items():
        for at, entry, node in templates:
            if isinstance(entry, dict):
                fixed = _values(parts, (*at, "slots"), entry.get("slots"), action, slots)
                sentences[key].append(Sentence(entry["say"], node, fixed, source.place((*at, "say"))))
            else:
                sentences[key].append(Sentence(entry, node, {}, source.place(at)))
    conditions = []
    for at, _, item in source.entries((*path, "when"), spec.get("when")):
        asked = _values(parts, (*at, "slots"), item["slots"], ActionSpec("custom"), slots)
        conditions.append(Condition(asked, _values(parts, (*at, "defaults"), item["defaults"], action, slots)))
    patterns = [text for _, _, text in source.entries((*path, "regex"), spec.get("regex"))]
    return Intent(
        name=name,
        action=action,
        sentences=tuple(sentences["sentences"]),
        then=tuple(sentences["then"]),
        regex=tuple(patterns),
        lark=spec.get("lark") if (*path, "lark") not in source.broken else None,
        defaults=_values(parts, (*path, "defaults"), spec.get("defaults"), action, slots),
        when=tuple(conditions),
        requires=frozenset(text for _, _, text in source.entries((*path, "requires"), spec.get("requires"))),
        excludes=frozenset(text for _, _, text in source.entries((*path, "excludes"), spec.get("excludes"))),
        priority=usual if (*path, "priority") in source.broken else spec.get("priority", usual),
        min_confidence=spec.get("min_confidence") if (*path, "min_confidence") not in source.broken else None,
        wait=_wait(parts, (*path, "wait"), spec),
        examples=tuple(_examples(parts, (*path, "examples"), spec.get("examples"))),
        description=str(spec.get("description", "")),
        place=source.place(path, key=True),
    )


def slots_by_label(nodes: Iterable[Node], known: Grammar) -> dict[str, Slot]:
    """The slots that templates fill, through their phrases, by label; of several with one label the first."""
    return {label: slots[0] for label, slots in all_slots_by_label(nodes, known).items()}


def all_slots_by_label(nodes: Iterable[Node], known: Grammar) -> dict[str, list[Slot]]:
    """The slots that templates fill, through their phrases, by label, in the order met."""
    found: dict[str, list[Slot]] = {}
    met: set[str] = set()
    pending = [reference for node in nodes for reference in references(node)]
    while pending:
        reference = pending.pop(0)
        if reference.name in known.slots:
            slots = found.setdefault(reference.label, [])
            if known.slots[reference.name] not in slots:
                slots.append(known.slots[reference.name])
        elif reference.name in known.phrases and reference.name not in met:
            met.add(reference.name)
            pending.extend(references(known.phrases[reference.name]))
    return found


def merged(old: Intent, new: Intent) -> Intent:
    """An intent to which a second file adds sentences and examples, or gives other defaults."""
    return replace(
        old,
        sentences=old.sentences + new.sentences,
        then=old.then + new.then,
        regex=old.regex + new.regex,
        lark=new.lark or old.lark,
        defaults=with_defaults(old.action, old.defaults, new.defaults),
        when=old.when + new.when,
        requires=old.requires | new.requires,
        excludes=old.excludes | new.excludes,
        priority=new.priority,  # which is that of the old one, unless its file gives another
        min_confidence=old.min_confidence if new.min_confidence is None else new.min_confidence,
        wait=old.wait if new.wait is None else new.wait,
        examples=old.examples + new.examples,
        description=old.description or new.description,
    )


def with_defaults(action: ActionSpec, earlier: Mapping[str, Any], later: Mapping[str, Any]) -> dict[str, Any]:
    """Defaults to which others are added. How far and how long are two ways to say how much: the later one holds."""
    amounts = amount_labels(action)
    lost = amounts if not amounts.isdisjoint(later) else frozenset()
    return {**{label: value for label, value in earlier.items() if label not in lost}, **later}


def amount_labels(action: ActionSpec) -> frozenset[str]:
    """The names under which a default says how far a robot moves, or for how long."""
    amounts = _AMOUNTS.get(action.type, ())
    return frozenset((*amounts, *(slot_of_parameter(action, amount) for amount in amounts)))


def slot_of_parameter(action: ActionSpec, parameter: str) -> str:
    """The label of the slot that a parameter of an action takes: its own name unless the file says another."""
    taken = action.parameters.get(parameter)
    return taken.strip("{}") if isinstance(taken, str) and taken.startswith("{") else parameter


def _action(parts: PartReader, path: YamlPath, name: str, spec: Any) -> ActionSpec:
    source = parts.source
    if path in source.broken or (*path, "type") in source.broken:
        parts.draft.partial.add(name)
        return ActionSpec("custom", name)
    if isinstance(spec, str):
        if spec not in ACTION_PARAMETERS:
            near = meant(spec, ACTIONS, ACTION_PARAMETERS)
            near = near or f"one of: {', '.join(ACTION_PARAMETERS)}"
            own = f"for your own: action: {{type: custom, name: {spec if spec.isidentifier() else name}}}"
            source.problem(path, f"no action is called {spec!r}", f"{near}{' ' if near.endswith('?') else '; '}{own}")
            parts.draft.partial.add(name)
            return ActionSpec("custom", name)
        return ActionSpec(spec, name if spec == "custom" else None)
    kind = spec["type"]
    known = ACTION_PARAMETERS[kind]
    parameters: dict[str, Any] = {}
    for at, key, value in source.entries(path, spec):
        if key in ("type", "name"):
            continue
        if kind != "custom" and key not in known:
            hint = did_you_mean(key, known) or f"{kind} takes {', '.join(known) or 'nothing'}"
            source.problem(at, f"{kind} has no parameter {key!r}", hint, key=True)
        elif isinstance(value, str) and (held := _SLOT.search(value)) is not None and held[0] != value:
            hint = f'write {key}: "{held[0]}", and put together in the program what stands around it'
            source.problem(at, f"a parameter is one slot or one value, and {value!r} is neither", hint)
        elif known.get(key) in QUANTITY_KINDS and not str(value).startswith("{"):
            parameters[key] = parts.quantity(at, known[key], value, None)
        elif parts.finite(at, value):
            parameters[key] = value
    if kind == "custom":
        return ActionSpec(kind, spec.get("name", name), parameters)
    if "name" in spec:
        source.problem((*path, "name"), f"{kind} has no name; a custom action has one", "remove it", key=True)
    return ActionSpec(kind, None, parameters)


def _values(
    parts: PartReader, path: YamlPath, values: Any, action: ActionSpec, slots: Mapping[str, Slot]
) -> dict[str, Any]:
    """Slot values as a file writes them, quantities in SI."""
    kinds = ACTION_PARAMETERS.get(action.type, {})
    result: dict[str, Any] = {}
    for at, key, value in parts.source.entries(path, values):
        slot = slots.get(slot_of_parameter(action, key))
        kind = kinds.get(key) or (slot.type if slot else None)
        if kind in QUANTITY_KINDS:
            found = parts.quantity(at, kind, value, None)  # a plain number is in SI: units are for what is said
            if found is not None:
                result[key] = slot.counted(found) if slot is not None else found
        elif parts.finite(at, value):
            result[key] = value
    return result


def _wait(parts: PartReader, path: YamlPath, spec: Mapping[str, Any]) -> float | None:
    """The silence that ends a sentence; one without end would keep a robot from what it was told."""
    if "wait" not in spec or path in parts.source.broken:
        return None
    wait = parts.quantity(path, "duration", spec["wait"], None)
    if wait is not None and not 0 <= wait <= LONGEST_WAIT:
        hint = f"0 to {LONGEST_WAIT:g} s, for example wait: 450 ms"
        parts.source.problem(path, f"a wait of {wait:g} s is none that ends a sentence", hint)
        return None
    return wait


def _examples(parts: PartReader, path: YamlPath, examples: Any) -> Iterator[Example]:
    source = parts.source
    if isinstance(examples, dict):
        entries = [((*path, text), path, {text: expected}) for text, expected in examples.items()]
    else:
        entries = [(at, at, entry) for at, _, entry in source.entries(path, examples)]
    for at, above, entry in entries:
        if isinstance(entry, str):
            yield Example(entry, None, source.place(at))
            continue
        if not isinstance(entry, dict) or len(entry) != 1:
            raw = source.raw.get(at)
            hint = f'quote it: "{raw}"' if raw else 'write: - "go left": {direction: left}'
            source.problem(at, "an example is one sentence and its meaning", hint)
            continue
        ((text, expected),) = entry.items()
        meaning = (*above, text)
        if isinstance(expected, str) and expected not in RESULTS:
            hint = did_you_mean(expected, RESULTS) or f"write {{slot: value}} or one of: {', '.join(RESULTS)}"
            source.problem(meaning, f"{expected!r} is no result of a sentence", hint)
        elif expected is not None and not isinstance(expected, (str, dict)):
            source.problem(meaning, "the meaning of an example is {slot: value} or rejected", f"not {expected!r}")
        else:
            yield Example(text, None if expected == "accepted" else expected, source.place(at))
