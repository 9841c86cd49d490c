"""Grammar files: YAML to a checked :class:`Grammar`. Everything wrong is found at load, and all of it at once."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

from intent_engine.errors import ConfigError, Problem
from intent_engine.language import quantities
from intent_engine.language.grammar import (
    ACTION_PARAMETERS,
    QUANTITY_KINDS,
    SLOT_TYPES,
    ActionSpec,
    Condition,
    Example,
    Grammar,
    Intent,
    Operators,
    Sentence,
    Slot,
)
from intent_engine.language.grammar_checks import check_meaning
from intent_engine.language.normalize import tokenize
from intent_engine.language.schema_problems import schema_problems
from intent_engine.language.template import Choice, Node, TemplateError, parse_template
from intent_engine.language.yaml_source import YamlPath, YamlSource, did_you_mean, read_yaml

__all__ = ["load_grammars", "schema"]

DEFAULT_SOUND_ALIKES: Mapping[str, Mapping[str, tuple[str, ...]]] = {
    "en": {
        "two": ("to",), "too": ("to", "two"), "to": ("two",),
        "for": ("four",), "four": ("for",), "fore": ("for", "four"),
        "write": ("right",),
        "rite": ("right",), "wright": ("right",), "write's": ("right",),
        "bae": ("bay",), "bey": ("bay",), "foreword": ("forward",), "forwards": ("forward",), "forword": ("forward",),
        "meeters": ("meters",), "meeter": ("meter",), "metres": ("meters",), "ford": ("forward",),
        "won": ("one",), "ate": ("eight",), "tree": ("three",), "sex": ("six",), "turned": ("turn",),
        "moved": ("move",), "stopped": ("stop",), "goto": ("go",), "b": ("bay",), "lift": ("left",),
    },
}  # fmt: skip
"""Words that recognisers write for function words of commands. Names have their own index; these are for the rest."""


@cache
def schema() -> dict[str, Any]:
    """The JSON Schema of a grammar file."""
    text = resources.files("intent_engine.language").joinpath("grammar.schema.json").read_text("utf-8")
    loaded: dict[str, Any] = json.loads(text)
    return loaded


@cache
def default_operators(language: str) -> Mapping[str, tuple[str, ...]]:
    """The operators that every grammar of a language has; empty for a language that we do not know."""
    folder = resources.files("intent_engine.language").joinpath("operators")
    file = folder.joinpath(f"{language}.yaml")
    if not file.is_file():
        return {}
    source = read_yaml(str(file))
    return {key: tuple(str(item) for item in items) for key, items in source.data.items()}


def phrase(text: str) -> tuple[str, ...]:
    """The normalised words of a plain phrase."""
    return tuple(token.word for token in tokenize(text))


def load_grammars(paths: str | Path | Sequence[str | Path]) -> tuple[Grammar, ...]:
    """Read grammar files and what they include; files of one language make one grammar.

    Returns:
        One grammar for each language, in the order in which the languages are first met.

    Raises:
        ConfigError: with every problem of every file.
    """
    names = [paths] if isinstance(paths, (str, Path)) else list(paths)
    if not names:
        raise ConfigError("no grammar file was given")
    sources: list[YamlSource] = []
    problems: list[Problem] = []
    seen: set[Path] = set()
    pending = [Path(name) for name in names]
    while pending:
        path = pending.pop(0)
        if path.resolve() in seen:
            continue
        seen.add(path.resolve())
        source = read_yaml(path)
        if source.data is not None:
            source.problems.extend(schema_problems(source, schema()))
        sources.append(source)
        if isinstance(source.data, dict) and not source.problems:
            pending.extend(path.parent / name for name in source.data.get("include", ()))
    builders: dict[str, _Builder] = {}
    for source in sources:
        if not source.problems:
            language = source.data.get("language", "en").split("-")[0]
            builders.setdefault(language, _Builder(language)).add(source)
    grammars = []
    for builder in builders.values():
        builder.add_intents()
    for source in sources:
        problems.extend(source.problems)
    for builder in builders.values():
        if problems:
            break  # what a broken file leaves out would only be reported twice, as missing
        grammar, found = builder.finish()
        problems.extend(found)
        grammars.append(grammar)
    if problems:
        raise ConfigError(problems)
    return tuple(grammars)


class _Builder:
    """Gathers the files of one language."""

    def __init__(self, language: str) -> None:
        self.language = language
        self.fillers: list[str] = []
        self.wake: list[str] = []
        self.phrases: dict[str, Node] = {}
        self.slots: dict[str, Slot] = {}
        self.intents: dict[str, Intent] = {}
        self.operators: dict[str, list[str]] = {key: list(items) for key, items in default_operators(language).items()}
        self.alikes: dict[str, tuple[str, ...]] = dict(DEFAULT_SOUND_ALIKES.get(language, {}))
        self.sources: list[YamlSource] = []

    def add(self, source: YamlSource) -> None:
        data = source.data
        self.sources.append(source)
        self.fillers.extend(data.get("fillers", ()))
        self.wake.extend(data.get("wake", ()))
        for key, items in data.get("operators", {}).items():
            self.operators.setdefault(key, []).extend(items)
        for heard, meant in data.get("sound_alikes", {}).items():
            self.alikes[heard.lower()] = tuple(word.lower() for word in meant)
        for name, templates in data.get("phrases", {}).items():
            self._once(source, ("phrases", name), name)
            node = self._alternatives(source, ("phrases", name), templates)
            if node is not None:
                self.phrases[name] = node
        for name, spec in data.get("slots", {}).items():
            self._once(source, ("slots", name), name)
            slot = self._slot(source, ("slots", name), name, spec)
            if slot is not None:
                self.slots[name] = slot

    def add_intents(self) -> None:
        """Read the intents of all files, once the slots of all files are known."""
        for source in self.sources:
            for name, spec in source.data.get("intents", {}).items():
                if name in self.intents:
                    self.intents[name] = self._merged(source, name, spec)
                else:
                    self.intents[name] = self._intent(source, ("intents", name), name, spec)

    def _once(self, source: YamlSource, path: YamlPath, name: str) -> None:
        kind = "slot" if name in self.slots else "phrase" if name in self.phrases else None
        if kind is not None:
            source.problem(path, f"{name!r} is already the name of a {kind}", "give it another name", key=True)

    def _template(self, source: YamlSource, path: YamlPath, text: str) -> Node | None:
        try:
            return parse_template(text)
        except TemplateError as error:
            source.problem(path, error.message, error.hint, offset=error.column)
            return None

    def _alternatives(self, source: YamlSource, path: YamlPath, templates: Any) -> Node | None:
        if isinstance(templates, str):
            return self._template(source, path, templates)
        nodes = [self._template(source, (*path, index), text) for index, text in enumerate(templates)]
        kept = tuple(node for node in nodes if node is not None)
        if not kept:
            return None
        return kept[0] if len(kept) == 1 else Choice(kept)

    def _slot(self, source: YamlSource, path: YamlPath, name: str, spec: Any) -> Slot | None:
        if isinstance(spec, list):
            spec = {"type": "choice", "values": spec}
        elif isinstance(spec, str):
            spec = {"type": spec}
        kind = spec.get("type", "choice" if "values" in spec else None)
        if kind not in SLOT_TYPES:
            hint = did_you_mean(str(kind), SLOT_TYPES) or f"the types are {', '.join(SLOT_TYPES)}"
            source.problem(path, f"slot {name!r} has no known type" if kind else f"slot {name!r} needs a type", hint)
            return None
        limits = {}
        for key in ("min", "max"):
            if key in spec:
                limits[key] = self._quantity(source, (*path, key), kind, spec[key], spec.get("unit"))
        low, high = limits.get("min"), limits.get("max")
        if low is not None and high is not None and low > high:
            source.problem((*path, "min"), "min is larger than max", "swap them")
        unit = spec.get("unit")
        if unit is not None and kind in QUANTITY_KINDS and self._value("1", kind, unit) is None:
            source.problem(
                (*path, "unit"), f"{unit!r} is not a unit of {kind}", "examples: m, cm, ft, deg, rad, s, m/s"
            )
        values = self._values(source, path, spec) if kind in ("choice", "boolean") else ()
        return Slot(
            name=name,
            type=kind,
            unit=unit,
            minimum=limits.get("min"),
            maximum=limits.get("max"),
            values=values,
            max_words=spec.get("max_words", 4),
            allow=frozenset(word for text in spec.get("allow", ()) for word in phrase(text)),
            without=frozenset(word for text in spec.get("without", ()) for word in phrase(text)),
            tags=frozenset(spec.get("tags", ())),
            fuzzy=spec.get("fuzzy", True),
            place=source.place(path, key=True),
        )

    def _values(self, source: YamlSource, path: YamlPath, spec: Mapping[str, Any]) -> tuple[tuple[Any, Node], ...]:
        values = spec.get("values")
        if values is None:
            if spec["type"] == "boolean":
                values = {"true": ["(yes|on|true)"], "false": ["(off|false)"]}
            else:
                source.problem(path, "a choice needs values", "values: {red: [red, crimson], blue: [blue]}")
                return ()
        rows: list[tuple[Any, Node]] = []
        items: Iterable[tuple[Any, Any, YamlPath]]
        if isinstance(values, list):
            items = [(text, text, (*path, "values", index)) for index, text in enumerate(values)]
        else:
            items = [(key, texts, (*path, "values", key)) for key, texts in values.items()]
        for value, texts, at in items:
            node = self._alternatives(source, at, texts)
            if node is not None:
                rows.append((value == "true" if spec["type"] == "boolean" else value, node))
        return tuple(rows)

    def _value(self, text: str, kind: str, unit: str | None) -> float | None:
        words = [token.word for token in tokenize(text)]
        found = quantities.evaluate(words, kind, "en", unit)
        return float(found) if isinstance(found, (int, float)) else None

    def _quantity(self, source: YamlSource, path: YamlPath, kind: str, raw: Any, unit: str | None) -> float | None:
        """A limit or default: SI number, or text with a unit."""
        if isinstance(raw, (int, float)) and not isinstance(raw, bool):
            if unit is not None:
                return self._value(repr(raw), kind, unit)
            return float(raw)
        value = self._value(str(raw), kind, unit) if kind in QUANTITY_KINDS else None
        if value is None:
            what = f"is not a {kind}" if kind in QUANTITY_KINDS else f"has no meaning for a slot of type {kind}"
            source.problem(path, f"{raw!r} {what}", "write a number in SI units, or one with its unit: 0.5 m/s")
        return value

    def _intent(self, source: YamlSource, path: YamlPath, name: str, spec: Mapping[str, Any]) -> Intent:
        action = self._action(source, (*path, "action"), name, spec["action"])
        sentences = []
        for index, entry in enumerate(spec.get("sentences", ())):
            at: YamlPath = (*path, "sentences", index)
            fixed: Mapping[str, Any] = {}
            if isinstance(entry, dict):
                fixed, at, entry = entry.get("slots", {}), (*at, "say"), entry["say"]
            node = self._template(source, at, entry)
            if node is not None:
                sentences.append(Sentence(entry, node, fixed, source.place(at)))
        kinds = ACTION_PARAMETERS.get(action.type, {})
        regex = spec.get("regex", ())
        conditions = [
            Condition(
                item["slots"],
                self._defaults(source, (*path, "when", index, "defaults"), item["defaults"], kinds),
            )
            for index, item in enumerate(spec.get("when", ()))
        ]
        return Intent(
            name=name,
            action=action,
            sentences=tuple(sentences),
            regex=(regex,) if isinstance(regex, str) else tuple(regex),
            lark=spec.get("lark"),
            defaults=self._defaults(source, (*path, "defaults"), spec.get("defaults", {}), kinds),
            when=tuple(conditions),
            requires=frozenset(spec.get("requires", ())),
            excludes=frozenset(spec.get("excludes", ())),
            priority=spec.get("priority", 0),
            examples=tuple(self._examples(source, (*path, "examples"), spec.get("examples", ()))),
            description=spec.get("description", ""),
            place=source.place(path, key=True),
        )

    def _merged(self, source: YamlSource, name: str, spec: Mapping[str, Any]) -> Intent:
        """A second file may add sentences and examples to an intent of the same action."""
        old = self.intents[name]
        new = self._intent(source, ("intents", name), name, spec)
        if new.action != old.action:
            source.problem(
                ("intents", name),
                f"intent {name!r} already exists with another action",
                "use another name",
                key=True,
            )
        return replace(
            old,
            sentences=old.sentences + new.sentences,
            regex=old.regex + new.regex,
            lark=new.lark or old.lark,
            defaults={**old.defaults, **new.defaults},
            when=old.when + new.when,
            examples=old.examples + new.examples,
        )

    def _action(self, source: YamlSource, path: YamlPath, name: str, spec: Any) -> ActionSpec:
        if isinstance(spec, str):
            if spec not in ACTION_PARAMETERS:
                hint = did_you_mean(spec, ACTION_PARAMETERS) or "for your own: action: {type: custom, name: ...}"
                source.problem(path, f"no action is called {spec!r}", hint)
            return ActionSpec(spec, name if spec == "custom" else None)
        kind = spec["type"]
        known = ACTION_PARAMETERS.get(kind, {})
        parameters = {key: value for key, value in spec.items() if key not in ("type", "name")}
        if kind == "custom":
            return ActionSpec(kind, spec.get("name", name), parameters)
        for key, value in parameters.items():
            if key not in known:
                hint = did_you_mean(key, known) or f"{kind} takes {', '.join(known) or 'nothing'}"
                source.problem((*path, key), f"{kind} has no parameter {key!r}", hint, key=True)
            elif known[key] in QUANTITY_KINDS and not str(value).startswith("{"):
                parameters[key] = self._quantity(source, (*path, key), known[key], value, None)
        return ActionSpec(kind, None, parameters)

    def _defaults(
        self, source: YamlSource, path: YamlPath, defaults: Mapping[str, Any], kinds: Mapping[str, str]
    ) -> dict[str, Any]:
        result: dict[str, Any] = {}
        for key, value in defaults.items():
            slot = self.slots.get(key)
            kind = kinds.get(key) or (slot.type if slot else None)
            if kind in QUANTITY_KINDS:
                result[key] = self._quantity(source, (*path, key), kind, value, slot.unit if slot else None)
            else:
                result[key] = value
        return result

    def _examples(self, source: YamlSource, path: YamlPath, examples: Any) -> Iterable[Example]:
        if isinstance(examples, dict):
            examples = [{text: expected} for text, expected in examples.items()]
        for index, entry in enumerate(examples):
            at: YamlPath = (*path, index)
            if isinstance(entry, str):
                yield Example(entry, None, source.place(at))
                continue
            if not isinstance(entry, dict) or len(entry) != 1:
                source.problem(at, "an example is one sentence and its meaning", '"go left": {direction: left}')
                continue
            ((text, expected),) = entry.items()
            if isinstance(expected, str) and expected not in (
                "accepted",
                "rejected",
                "ambiguous",
                "incomplete",
            ):
                hint = did_you_mean(expected, ("rejected", "ambiguous", "incomplete"))
                source.problem((*at, text), f"{expected!r} is no result", hint or "write {slot: value} or rejected")
                continue
            if expected is not None and not isinstance(expected, (str, dict)):
                source.problem((*at, text), "the meaning of an example is {slot: value} or rejected")
                continue
            yield Example(text, None if expected == "accepted" else expected, source.place(at))

    def finish(self) -> tuple[Grammar, list[Problem]]:
        operators = {key: tuple(phrase(text) for text in texts) for key, texts in self.operators.items()}
        single = {words[0] for key in ("negation",) for words in operators.get(key, ()) if len(words) == 1}
        closed = single | {words[0] for words in operators.get("closed", ()) if len(words) == 1}
        closed |= {words[0] for words in operators.get("sequence", ()) if len(words) == 1}
        closed |= {words[0] for words in operators.get("contrast", ()) if len(words) == 1}
        closed |= {words[0] for words in operators.get("stop", ()) if len(words) == 1}
        closed |= {words[0] for words in operators.get("correction", ()) if len(words) == 1}
        grammar = Grammar(
            language=self.language,
            fillers=tuple(phrase(text) for text in self.fillers),
            phrases=self.phrases,
            slots=self.slots,
            intents=self.intents,
            operators=Operators(
                **{key: tuple(words for words in rows if words) for key, rows in operators.items() if key != "closed"},
                closed=frozenset(closed),
            ),
            sound_alikes=self.alikes,
            wake=tuple(phrase(text) for text in self.wake),
            files=tuple(source.file for source in self.sources),
        )
        problems, warnings = check_meaning(grammar)
        return replace(grammar, warnings=tuple(str(warning) for warning in warnings)), problems
