"""Templates and quantities of a grammar file, read with the place of everything that is wrong in them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from intent_engine.errors import Problem
from intent_engine.language import quantities
from intent_engine.language.grammar import QUANTITY_KINDS, Place, problem_at
from intent_engine.language.loading.value_hints import number_in_text
from intent_engine.language.loading.yaml_source import YamlPath, YamlSource
from intent_engine.language.normalize import words_of
from intent_engine.language.numbers.units import units
from intent_engine.language.template import TemplateError, parse_template
from intent_engine.language.templates.template_tree import Choice, Node

__all__ = ["UNITS", "Draft", "PartReader", "Places", "Written", "hardly_meant"]

UNITS: Mapping[str, str] = {
    "distance": "m, cm, mm, km, ft, in",
    "angle": "deg, rad",
    "duration": "s, ms, min, h",
    "speed": "m/s, km/h, cm/s",
    "angular_speed": "rad/s, deg/s",
    "percent": "percent",
}
"""How a grammar file may write the units of each kind of quantity."""
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

    # -- quantities -------------------------------------------------------------------------------------------

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
            hint = number_in_text(raw) or "write a number"
            if kind in UNITS:
                usual = self.unit_key(str(raw))
                hint = f"{hint} in SI units, or one with its unit ({UNITS[kind]})"
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

    def unit_key(self, text: str) -> str | None:
        """How a grammar file writes the unit with which a text of its language ends: "deg" of "5 Grad"."""
        table = units(self.draft.language)
        found = table.unit_at_end(words_of(text)) if table is not None and self.draft.language != "en" else None
        return found[0] if found else None
