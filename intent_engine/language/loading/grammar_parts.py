"""Templates, slots and quantities of a grammar file, read with the place of everything that is wrong in them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from intent_engine.errors import Problem
from intent_engine.language import quantities
from intent_engine.language.grammar import QUANTITY_KINDS, SLOT_TYPES, Place, Slot, problem_at
from intent_engine.language.loading.language_words import default_booleans
from intent_engine.language.loading.other_words import TYPES, meant
from intent_engine.language.loading.yaml_source import YamlPath, YamlSource
from intent_engine.language.normalize import words_of
from intent_engine.language.numbers.units import units
from intent_engine.language.template import TemplateError, parse_template
from intent_engine.language.templates.template_tree import Choice, Node

__all__ = ["Draft", "PartReader", "Places", "Written", "hardly_meant"]

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
_UNITS: Mapping[str, str] = {
    "distance": "m, cm, mm, km, ft, in",
    "angle": "deg, rad",
    "duration": "s, ms, min, h",
    "speed": "m/s, km/h, cm/s",
    "angular_speed": "rad/s, deg/s",
    "percent": "percent",
}
USUAL_WORDS, MOST_WORDS = 4, 12
"""Words of a text, where its slot says no number; and of one that is dictated, in a sentence of several commands."""
MANY = 10
"""From here on a plain number for a percentage or an angle is hardly meant as it is written: 80 would be 8,000
percent, and 90, in rad, fourteen turns; and 50, of a robot's speed, 180 km/h."""
_SPEEDS: Mapping[str, tuple[str, tuple[float, str], str]] = {
    "speed": ("m/s", (3.6, "km/h"), "cm/s"),
    "angular_speed": ("rad/s", (1 / math.tau, "turns a second"), "deg/s"),
}
"""Kind -> the unit of a plain number, how it is told how much that is, and a unit that may be meant."""
LARGEST = 1e15
"""Beyond it two whole numbers may be the same float."""
_BOOLEANS = {"true": True, "yes": True, "on": True, "false": False, "no": False, "off": False}


@dataclass(frozen=True, slots=True)
class Written:
    """A template where it was written; phrases and slots hold several."""

    kind: Literal["sentence", "phrase", "slot"]
    name: str
    """Of the phrase, the slot or the intent."""
    node: Node
    text: str
    source: YamlSource
    path: YamlPath

    def problem(self, message: str, hint: str | None = None, column: int = 0) -> Problem:
        """A problem at a column of the template, from 0."""
        place = self.source.place(self.path, column)
        return problem_at(place, message, hint)


@dataclass
class Draft:
    """What is known of one language's grammar besides the grammar itself."""

    language: str = "en"
    written: list[Written] = field(default_factory=list)
    broken: set[str] = field(default_factory=set)
    """Names of slots and phrases that exist and could not be read: nobody should call them missing."""
    partial: set[str] = field(default_factory=set)
    """Intents some part of which could not be read: what seems to be missing in them may stand there."""
    blind: bool = False
    """Whether a file could not be read at all, so that any name may be defined in it."""
    mute: bool = False
    """Whether intents could not be read at all, so that something may be said though nothing is known of it."""


class Places:
    """Where things stand, for messages that are made when all files have been read."""

    def __init__(self, sources: list[YamlSource]) -> None:
        self._sources = sources

    def of(self, path: YamlPath, *, key: bool = False) -> Place | None:
        """The place in the first file that has something at a path, or above it."""
        while path:
            for source in self._sources:
                if path in source.marks:
                    return source.place(path, key=key)
            path = path[:-1]
        return None

    def texts(self, section: str) -> Iterator[tuple[Place, str]]:
        """The texts of a list, as every file has them, with where each stands."""
        for source in self._sources:
            rows = source.data.get(section)
            if isinstance(rows, str):
                yield source.place((section,)), rows
            for index, text in enumerate(rows if isinstance(rows, list) else ()):
                if isinstance(text, str):
                    yield source.place((section, index)), text

    def problem(
        self, path: YamlPath, message: str, hint: str | None = None, *, key: bool = False, line: int = 0
    ) -> Problem:
        """A problem at a path, or at a line below where that begins (of a text of several lines)."""
        place = self.of(path, key=key)
        if place is None:
            return Problem(message, self._sources[-1].file if self._sources else None, hint=hint)
        lines = next(source.lines for source in self._sources if source.file == place.file)
        if line and place.source.rstrip()[-1:] in "|>+-" and place.line + line <= len(lines):
            return Problem(message, place.file, place.line + line, None, lines[place.line + line - 1], hint)
        return problem_at(place, message, hint)


def hardly_meant(kind: str, raw: float) -> tuple[str, str] | None:
    """What is wrong with a plain number in SI units that is hardly meant as it is written, and what to write."""
    if abs(raw) < MANY:
        return None
    if kind == "percent":
        return f"{raw} is {raw * 100:,.0f} percent: a plain number is a part of one", f"write {raw} %"
    if kind == "angle":
        message = f"{raw} is {raw} rad, which is {abs(raw) / math.tau:.1f} turns: a plain number is in rad"
        return message, f"write {raw} deg, or {raw} rad if you mean it"
    if kind in _SPEEDS:
        unit_of, too_much, other = _SPEEDS[kind]
        message = f"{raw} is {raw} {unit_of}, which is {abs(raw) * too_much[0]:.4g} {too_much[1]}"
        return f"{message}: a plain number is in {unit_of}", f"write {raw} {other}, or {raw} {unit_of} if you mean it"
    return None


class PartReader:
    """Reads the parts of one file. What is wrong goes into the file's problems, and the part is then None."""

    def __init__(self, source: YamlSource, draft: Draft) -> None:
        self.source = source
        self.draft = draft

    # -- templates --------------------------------------------------------------------------------------------

    def template(
        self, path: YamlPath, text: str, kind: Literal["sentence", "phrase", "slot"], name: str
    ) -> Node | None:
        try:
            node = parse_template(text)
        except TemplateError as error:
            if path in self.source.folded and " - " in text:
                message = "YAML reads these lines as one text"
                self.source.problem(path, message, "begin every '-' in the same column")
            else:
                self.source.problem(path, error.message, error.hint, offset=error.column)
            return None
        self.draft.written.append(Written(kind, name, node, text, self.source, path))
        return node

    def plain(self, path: YamlPath, texts: Any) -> Iterator[str]:
        """Phrases that are no templates: each stands for itself. What is none is told, and left out."""
        for at, _, text in self.source.entries(path, texts):
            if any(sign in "()[]{}|;" for sign in text):
                message = f"{text!r} is a template, and only plain words can stand here"
                self.source.problem(at, message, "write each way to say it as an entry of its own")
            elif not words_of(text):
                self.source.problem(
                    at, f"{text!r} has no word that can be said", "write letters or digits, or remove it"
                )
            else:
                yield text

    def alternatives(self, path: YamlPath, templates: Any, kind: Literal["phrase", "slot"], name: str) -> Node | None:
        """One template or a list of them; None if any cannot be read."""
        if isinstance(templates, str):
            return self.template(path, templates, kind, name)
        nodes = [self.template(at, text, kind, name) for at, _, text in self.source.entries(path, templates)]
        kept = tuple(node for node in nodes if node is not None)
        if len(kept) < len(templates):
            return None
        return kept[0] if len(kept) == 1 else Choice(kept)

    # -- slots ------------------------------------------------------------------------------------------------

    def slot(self, path: YamlPath, name: str, given: Any) -> Slot | None:
        source = self.source
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
        if (*path, "type") in source.broken:
            return None
        kind = str(spec.get("type", "choice" if "values" in spec else ""))
        if kind not in SLOT_TYPES:
            hint = meant(kind, TYPES, SLOT_TYPES) or f"the types are {', '.join(SLOT_TYPES)}"
            message = f"slot {name!r} has no type that is known: {kind!r}" if kind else f"slot {name!r} needs a type"
            source.problem(path, message, hint)
            return None
        for at, key, _ in source.entries(path, given):
            if isinstance(given, dict) and key != "type" and key not in _KEYS[kind]:
                hint = f"a slot of type {kind} takes {', '.join(_KEYS[kind])}"
                source.problem(at, f"{key!r} means nothing for a slot of type {kind}", hint, key=True)
        unit = spec.get("unit") if kind in QUANTITY_KINDS else None
        unit = unit.replace("\N{MICRO SIGN}", "\N{GREEK SMALL LETTER MU}") if isinstance(unit, str) else unit
        if unit is not None and kind in _UNITS and self.si("1", kind, unit) is None:
            unit = " ".join(words_of(unit)) or unit  # "%" is "percent"
        if unit is not None and self.si("1", kind, unit) is None:
            usual = self._unit_key(unit)
            hint = f"write {usual}" if usual else f"for example {_UNITS.get(kind, 'none: it is a plain number')}"
            source.problem((*path, "unit"), f"{spec['unit']!r} is not a unit of {kind}", hint)
            unit = None
        low, high, least, most = (
            self.quantity((*path, key), kind, spec[key], unit)
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
        if least is not None and (least <= 0 or (high is not None and least > high and (low is None or -least < low))):
            source.problem((*path, "least"), f"{spec['least']!r} is no smallest size", "more than 0, and less than max")
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

    def _words(self, path: YamlPath, texts: Any) -> frozenset[str]:
        return frozenset(word for text in self.plain(path, texts) for word in words_of(text))

    def _names(self, path: YamlPath, texts: Any) -> frozenset[tuple[str, ...]]:
        return frozenset(tuple(words_of(text)) for _, _, text in self.source.entries(path, texts))

    def _values(self, path: YamlPath, name: str, kind: str, values: Any) -> tuple[tuple[Any, Node], ...]:
        source = self.source
        if values is None and kind == "boolean":
            usual = default_booleans(self.draft.language)
            if usual is None:
                message = f"what is said for true and for false is not known in {self.draft.language!r}"
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
            node = self.alternatives(at, texts, "slot", name)
            if node is not None:
                rows.append((value, node))
        return tuple(rows)

    # -- quantities -------------------------------------------------------------------------------------------

    def _steps(self, path: YamlPath, kind: str, given: Any, unit: str | None) -> tuple[float, ...]:
        """A step, or a list of some, of which people say the multiples."""
        if given is None or kind not in QUANTITY_KINDS or path in self.source.broken:
            return ()
        rows = [((*path, at), one) for at, one in enumerate(given)] if isinstance(given, list) else [(path, given)]
        found: list[float] = []
        for at, raw in rows:
            step = self.quantity(at, kind, raw, unit)
            if step is not None and step <= 0:
                self.source.problem(at, f"{raw!r} has no multiples", "more than 0: 5 deg")
            elif step is not None:
                found.append(step)
        return tuple(found)

    def _own_units(
        self, path: YamlPath, name: str, kind: str, given: Any, unit: str | None
    ) -> tuple[tuple[float, Node], ...]:
        """The size of each unit that the file has of its own, and how it is said."""
        if not isinstance(given, Mapping) or "units" not in _KEYS[kind] or path in self.source.broken:
            return ()
        found: list[tuple[float, Node]] = []
        for at, key, texts in self.source.entries(path, given):
            size = self.quantity(at, kind, key, unit, key=True)
            if size is not None and size <= 0:
                self.source.problem(at, f"{key!r} is no size of a unit", "more than 0: 30 cm", key=True)
            node = self.alternatives(at, texts, "slot", name)
            if size is not None and node is not None:
                found.append((size, node))
        return tuple(found)

    def quantity(self, path: YamlPath, kind: str, raw: Any, unit: str | None, *, key: bool = False) -> float | None:
        """A limit, default or fixed value: text with its unit, or a plain number in ``unit`` (None: in SI). ``key``
        tells whether it stands before a colon."""
        if not self.finite(path, raw):
            return None
        if isinstance(raw, (int, float)) and not isinstance(raw, bool) and unit is None:
            if (doubt := hardly_meant(kind, raw)) is not None:
                self.source.problem(path, *doubt, key=key)
                return None
            return float(raw)
        value = self.si(str(raw), kind, unit) if kind in QUANTITY_KINDS else None
        if value is None:
            hint = "write a number"
            if kind in _UNITS:
                usual = self._unit_key(str(raw))
                hint = f"write a number in SI units, or one with its unit ({_UNITS[kind]})"
                hint = f"write it with the unit {usual}, in English whatever is spoken" if usual else hint
            article = "an" if kind[0] in "aeiou" else "a"
            self.source.problem(path, f"{raw!r} is not {article} {kind.replace('_', ' ')}", hint, key=key)
        return value

    def finite(self, path: YamlPath, raw: Any) -> bool:
        """Whether a value is no infinite or endless number; told if it is."""
        if isinstance(raw, (int, float)) and not -LARGEST <= raw <= LARGEST:
            self.source.problem(
                path,
                f"{raw if isinstance(raw, float) else 'this'} is no number that a robot can use",
                "leave it out if there is none",
            )
            return False
        return True

    def si(self, text: str, kind: str, unit: str | None) -> float | None:
        """The value of a text in SI units; grammar files write numbers and units in English."""
        found = quantities.evaluate(words_of(text), kind, "en", unit)
        return float(found) if isinstance(found, (int, float)) else None

    def _unit_key(self, text: str) -> str | None:
        """How a grammar file writes the unit with which a text of its language ends: "deg" of "5 Grad"."""
        table = units(self.draft.language)
        found = table.unit_at_end(words_of(text)) if table is not None and self.draft.language != "en" else None
        return found[0] if found else None
