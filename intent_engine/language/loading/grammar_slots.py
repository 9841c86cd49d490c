"""Slots of a grammar file, read with the place of everything that is wrong in them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from intent_engine.language.grammar import NEVER_NEGATIVE, QUANTITY_KINDS, SLOT_TYPES, Slot
from intent_engine.language.loading.grammar_parts import UNITS, PartReader
from intent_engine.language.loading.language_words import default_booleans
from intent_engine.language.loading.other_words import TYPES, meant
from intent_engine.language.loading.yaml_source import YamlPath
from intent_engine.language.normalize import words_of
from intent_engine.language.templates.template_tree import Node

__all__ = ["read_slot"]

_KEYS: Mapping[str, tuple[str, ...]] = {
    **dict.fromkeys(QUANTITY_KINDS, ("unit", "units", "min", "max", "least", "usual_step", "usual_max", "digits")),
    "number": ("unit", "units", "min", "max", "least", "usual_step", "usual_max", "whole", "digits"),
    **dict.fromkeys(("speed", "angular_speed"), ("unit", "units", "min", "max", "least", "usual_step", "usual_max")),
    "ordinal": ("unit", "min", "max", "least", "usual_step", "usual_max"),
    "choice": ("values", "fuzzy"),
    "boolean": ("values", "fuzzy"),
    "location": ("tags", "fuzzy"),
    "text": ("max_words", "dictation", "allow", "without", "known"),
    "object": ("max_words", "allow", "without", "known"),
}
"""What each type of slot takes besides its type."""
USUAL_WORDS, MOST_WORDS = 4, 12
"""Words of a text, where its slot says no number; and of one that is dictated, in a sentence of several commands."""
_BOOLEANS = {"true": True, "yes": True, "on": True, "false": False, "no": False, "off": False}


def read_slot(parts: PartReader, path: YamlPath, name: str, given: Any) -> Slot | None:
    """The slot at a path of a file; None where something is wrong in it, which is told."""
    return _SlotReader(parts).slot(path, name, given)


class _SlotReader:
    def __init__(self, parts: PartReader) -> None:
        self._parts = parts
        self._source = parts.source

    def slot(self, path: YamlPath, name: str, given: Any) -> Slot | None:
        source = self._source
        before = len(source.problems)
        spec: Mapping[str, Any]
        if isinstance(given, list):
            spec = {"type": "choice", "values": given}
            values_at = path
        else:
            spec = (
                {"type": given} if isinstance(given, str) else {key: one for _, key, one in source.entries(path, given)}
            )
            values_at = (*path, "values")
        kind = self._kind(path, name, spec)
        if kind is None:
            return None
        for at, key, _ in source.entries(path, given):
            if isinstance(given, dict) and key != "type" and key not in _KEYS[kind]:
                hint = f"a slot of type {kind} takes {', '.join(_KEYS[kind])}"
                source.problem(at, f"{key!r} means nothing for a slot of type {kind}", hint, key=True)
        unit = self._unit(path, kind, spec) if kind in QUANTITY_KINDS else None
        low, high, least, most = self._limits(path, kind, spec, unit)
        steps = self._steps((*path, "usual_step"), kind, spec.get("usual_step"), unit)
        if most is not None and most <= 0:
            message = f"{spec['usual_max']!r} is nothing that anybody would say"
            source.problem((*path, "usual_max"), message, "more than 0: 20 m")
        own = self._own_units((*path, "units"), name, kind, spec.get("units"), unit)
        values = self._values(values_at, name, kind, spec.get("values")) if kind in ("choice", "boolean") else ()
        if len(source.problems) > before or any(broken[: len(path)] == path for broken in source.broken):
            return None
        return Slot(
            name=name,
            type=kind,
            unit=unit,
            units=own,
            minimum=low,
            maximum=high,
            least=least,
            usual_steps=steps,
            usual_max=most,
            whole=spec.get("whole", False),
            digits=spec.get("digits", False),
            values=values,
            max_words=spec.get("max_words", MOST_WORDS if spec.get("dictation") else USUAL_WORDS),
            dictation=spec.get("dictation", False),
            allow=self._words((*path, "allow"), spec.get("allow")),
            without=self._words((*path, "without"), spec.get("without")),
            known=self._words((*path, "known"), spec.get("known")),
            known_names=self._names((*path, "known"), spec.get("known")),
            tags=frozenset(text for _, _, text in source.entries((*path, "tags"), spec.get("tags"))),
            fuzzy=spec.get("fuzzy", True),
            place=source.place(path, key=True),
        )

    def _kind(self, path: YamlPath, name: str, spec: Mapping[str, Any]) -> str | None:
        """The type of a slot; None: none that is known, which is told."""
        source = self._source
        if (*path, "type") in source.broken:
            return None
        kind = str(spec.get("type", "choice" if "values" in spec else ""))
        if kind in SLOT_TYPES:
            return kind
        hint = meant(kind, TYPES, SLOT_TYPES) or f"the types are {', '.join(SLOT_TYPES)}"
        message = f"slot {name!r} has no type that is known: {kind!r}" if kind else f"slot {name!r} needs a type"
        source.problem(path, message, hint)
        return None

    def _unit(self, path: YamlPath, kind: str, spec: Mapping[str, Any]) -> str | None:
        """The unit of plain numbers of a quantity; None: the usual one, or what is written is none, which is told."""
        unit = spec.get("unit")
        unit = unit.replace("\N{MICRO SIGN}", "\N{GREEK SMALL LETTER MU}") if isinstance(unit, str) else unit
        if unit is not None and kind in UNITS and self._parts.si("1", kind, unit) is None:
            unit = " ".join(words_of(unit)) or unit  # "%" is "percent"
        if unit is None or self._parts.si("1", kind, unit) is not None:
            return unit
        usual = self._parts.unit_key(unit)
        hint = f"write {usual}" if usual else f"for example {UNITS.get(kind, 'none: it is a plain number')}"
        self._source.problem((*path, "unit"), f"{spec['unit']!r} is not a unit of {kind}", hint)
        return None

    def _limits(
        self, path: YamlPath, kind: str, spec: Mapping[str, Any], unit: str | None
    ) -> tuple[float | None, float | None, float | None, float | None]:
        """The smallest and the largest value of a slot, its smallest size, and the most that is usually said."""
        source = self._source
        low, high, least, most = (
            self._parts.quantity((*path, key), kind, spec[key], unit)
            if key in spec and kind in QUANTITY_KINDS and (*path, key) not in source.broken
            else None
            for key in ("min", "max", "least", "usual_max")
        )
        part = spec.get("max", 0)
        if kind == "percent" and unit is not None and type(part) in (int, float) and 0 < part <= 1:
            message = f"{part} is {part:g} percent: a plain number is in the slot's unit"
            source.problem((*path, "max"), message, f"write {part * 100:g} %, or '{part:g} %' if you mean it")
        if low is not None and high is not None and low > high:
            source.problem((*path, "min"), f"min is larger than max: {spec['min']} > {spec['max']}", "swap them")
        if low is None and high is not None and high < 0 and kind in NEVER_NEGATIVE:
            message = f"no {kind} fits a max of {spec['max']!r}: none is less than zero"
            source.problem((*path, "max"), message, "write it without a sign")
        if least is not None and (least <= 0 or (high is not None and least > high and (low is None or -least < low))):
            source.problem((*path, "least"), f"{spec['least']!r} is no smallest size", "more than 0, and less than max")
        return low, high, least, most

    def _words(self, path: YamlPath, texts: Any) -> frozenset[str]:
        return frozenset(word for text in self._parts.plain(path, texts) for word in words_of(text))

    def _names(self, path: YamlPath, texts: Any) -> frozenset[tuple[str, ...]]:
        return frozenset(tuple(words_of(text)) for _, _, text in self._source.entries(path, texts))

    def _values(self, path: YamlPath, name: str, kind: str, values: Any) -> tuple[tuple[Any, Node], ...]:
        source = self._source
        if values is None and kind == "boolean":
            usual = default_booleans(self._parts.draft.language)
            if usual is None:
                message = f"what is said for true and for false is not known in {self._parts.draft.language!r}"
                source.problem(path, message, "write values: {true: [...], false: [...]}")
                return ()
            values = {str(value).lower(): [*said] for value, said in usual.items()}
        if not values:
            source.problem(path, "a choice needs values", "values: {red: [red, crimson], blue: [blue]}")
            return ()
        rows: list[tuple[Any, Node]] = []
        for at, key, texts in source.entries(path, values):
            value = texts if isinstance(values, list) else key
            if kind == "boolean":
                if str(value).lower() not in _BOOLEANS:
                    hint = "write values: {true: [...], false: [...]}, or type: choice"
                    source.problem(at, f"a boolean is true or false, not {value!r}", hint, key=True)
                    continue
                value = _BOOLEANS[str(value).lower()]
            node = self._parts.alternatives(at, texts, "slot", name)
            if node is not None:
                rows.append((value, node))
        return tuple(rows)

    def _steps(self, path: YamlPath, kind: str, given: Any, unit: str | None) -> tuple[float, ...]:
        """A step, or a list of some, of which people say the multiples."""
        if given is None or kind not in QUANTITY_KINDS or path in self._source.broken:
            return ()
        rows = [((*path, at), one) for at, one in enumerate(given)] if isinstance(given, list) else [(path, given)]
        found: list[float] = []
        for at, raw in rows:
            step = self._parts.quantity(at, kind, raw, unit)
            if step is not None and step <= 0:
                self._source.problem(at, f"{raw!r} has no multiples", "more than 0: 5 deg")
            elif step is not None:
                found.append(step)
        return tuple(found)

    def _own_units(
        self, path: YamlPath, name: str, kind: str, given: Any, unit: str | None
    ) -> tuple[tuple[float, Node], ...]:
        """The size of each unit that the file has of its own, and how it is said."""
        if not isinstance(given, Mapping) or "units" not in _KEYS[kind] or path in self._source.broken:
            return ()
        found: list[tuple[float, Node]] = []
        for at, key, texts in self._source.entries(path, given):
            size = self._parts.quantity(at, kind, key, unit, key=True)
            if size is not None and size <= 0:
                self._source.problem(at, f"{key!r} is no size of a unit", "more than 0: 30 cm", key=True)
            node = self._parts.alternatives(at, texts, "slot", name)
            if size is not None and node is not None:
                found.append((size, node))
        return tuple(found)
