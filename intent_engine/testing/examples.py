"""Sentences with their meaning, from files: the ``examples`` of grammars, and test files (``*.intents.yaml``).

Both the pytest plugin and ``intent-engine test`` run them from here.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

from intent_engine.actions import Action, from_json
from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError
from intent_engine.hints import did_you_mean
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language import quantities
from intent_engine.language.grammar import QUANTITY_KINDS, Grammar, Place, problem_at
from intent_engine.language.loading.file_kind import given_for
from intent_engine.language.loading.grammar_intents import all_slots_by_label
from intent_engine.language.loading.grammar_values import doubtful_numbers
from intent_engine.language.loading.schema_problems import schema_problems
from intent_engine.language.loading.yaml_source import YamlPath, YamlSource, near_file, read_yaml
from intent_engine.language.normalize import words_of
from intent_engine.language.templates.template_tree import references
from intent_engine.language_tag import language_of
from intent_engine.resources import default_grammar, default_locations, find
from intent_engine.testing.comparison import Difference, actions_difference, differences

__all__ = ["Case", "Examples", "Outcome", "grammar_cases", "is_test_file", "load_examples", "run_case"]

SUFFIXES = (".intents.yaml", ".intents.yml")
RESULTS = tuple(status.value for status in Status)


@dataclass(frozen=True, slots=True)
class Case:
    """A sentence and what is expected of it."""

    text: str
    status: Status = Status.ACCEPTED
    intent: str | None = None
    """None: any."""
    slots: Mapping[str, Any] | None = None
    """All of them; a quantity as an SI number, or as text with its unit ("90 deg"). None: any."""
    actions: tuple[Action, ...] | None = None
    """None: any."""
    state: tuple[str, ...] = ()
    """States that the robot is in."""
    language: str | None = None
    kinds: Mapping[str, str] = field(default_factory=dict)
    """Label -> type of slot, as which an expected text is read; none: whichever fits what was found."""
    place: Place | None = None
    needs: tuple[str, ...] = ()
    """Names of places that an example of a grammar speaks of. In a map that has them not, it cannot be tried."""
    elsewhere: bool = False
    """Whether the examples of its file are of another map, in which places may have other names as well."""


@dataclass(frozen=True, slots=True)
class Examples:
    """What a file asks for, and the engine that shall answer."""

    file: Path
    engine: IntentEngine
    cases: tuple[Case, ...] = field(default_factory=tuple)


@dataclass(frozen=True, slots=True)
class Outcome:
    """How a case went."""

    case: Case
    found: Interpretation
    differences: tuple[Difference, ...]
    missing: tuple[str, ...] = ()
    """Places that the map has not, so that nothing was compared: the grammar's examples are of another map."""

    @property
    def passed(self) -> bool:
        return not self.differences and not self.missing

    @property
    def failed(self) -> bool:
        return bool(self.differences)


def is_test_file(path: Path) -> bool:
    """Whether a file is a test file, by its name."""
    return path.name.endswith(SUFFIXES)


def load_examples(path: Path, locations: Sequence[Path] = ()) -> Examples:
    """The examples of a grammar file, or the tests of a test file.

    Args:
        path: a grammar, or a file whose name ends with ``.intents.yaml``.
        locations: map files, where the file names none; without any, the map that comes with the engine.

    Raises:
        ConfigError: with everything that is wrong in the file, or in the grammar and map that it names.
    """
    if is_test_file(path):
        return _tests(path, locations)
    engine = IntentEngine.from_files(path, locations=list(locations) or default_locations([path]))
    own = {str(path), str(path.resolve())}
    cases = grammar_cases(engine)
    # What the grammar includes has examples of its own, and is tested for itself.
    return Examples(path, engine, tuple(case for case in cases if case.place is None or case.place.file in own))


def grammar_cases(engine: IntentEngine) -> list[Case]:
    """The examples that stand in the grammar files of an engine, included files too."""
    kinds = _kinds(engine)
    cases = [replace(case, kinds=kinds) for grammar in engine.grammars for case in _examples(grammar)]
    unknown = [case for case in cases if case.place is not None and not set(case.needs) <= set(engine.locations or ())]
    elsewhere = {case.place.file for case in unknown if case.place is not None}
    return [replace(case, elsewhere=case.place is not None and case.place.file in elsewhere) for case in cases]


def run_case(engine: IntentEngine, case: Case) -> Outcome:
    """Parse a case's text and compare."""
    found = engine.parse(case.text, state=case.state, language=case.language)
    missing = tuple(name for name in case.needs if _of_another_map(name, engine.locations or (), found))
    if not missing and case.elsewhere and case.status is Status.ACCEPTED and found.unknown_place:
        missing = tuple(re.findall("'([^']+)'", found.reason)) or case.needs  # a name of a place that the map has
    if missing:
        return Outcome(case, found, (), missing)
    expected = Interpretation(
        case.text,
        case.status,
        found.intent if case.intent is None else case.intent,
        found.slots if case.slots is None else _in_si(case.slots, found.slots, case.kinds),
        found.actions if case.actions is None and case.status is Status.ACCEPTED else case.actions or (),
    )
    rows = differences(expected, found)
    if case.actions == () and found.actions and case.status is Status.ACCEPTED:  # to be done is nothing, not anything
        rows = (*rows, actions_difference((), found.actions))
    return Outcome(case, found, rows)


def _of_another_map(name: str, places: Collection[str], found: Interpretation) -> bool:
    """Whether a map has no such place. One that is nearly called so, and was understood, is a slip of who wrote the
    example; one that is nearly called so by chance ("Küche" beside "kitchen") is refused."""
    return name not in places and (found.status is Status.REJECTED or did_you_mean(name, places) is None)


def _in_si(expected: Mapping[str, Any], found: Mapping[str, Any], kinds: Mapping[str, str]) -> dict[str, Any]:
    """The expected slots, with quantities that are written with a unit of their kind as numbers ("2 s" are no 2 m); of
    several commands each, in which what is left out is as it was found."""
    values = dict(expected)
    steps, got_steps = expected.get("steps"), found.get("steps")
    if isinstance(steps, list) and isinstance(got_steps, list) and len(steps) == len(got_steps):
        values["steps"] = [_step_in_si(step, got, kinds) for step, got in zip(steps, got_steps, strict=True)]
    for label, value in expected.items():
        got = found.get(label)
        if isinstance(value, str) and isinstance(got, (int, float)) and not isinstance(got, bool):
            words = [*words_of(value)]
            own = kinds.get(label)
            for kind in (own, "number") if own in QUANTITY_KINDS else QUANTITY_KINDS:
                number = quantities.evaluate(words, kind)
                if isinstance(number, float) and (kind != "ordinal" or math.isclose(number, got)):
                    values[label] = number
                    if math.isclose(number, got, rel_tol=1e-6):
                        break
    return values


def _step_in_si(expected: Any, found: Mapping[str, Any], kinds: Mapping[str, str]) -> Any:
    if not isinstance(expected, Mapping):
        return expected
    slots = expected.get("slots", found["slots"])
    return {**found, **expected, "slots": _in_si(slots, found["slots"], kinds) if isinstance(slots, Mapping) else slots}


# -- grammars -------------------------------------------------------------------------------------------------


def _examples(grammar: Grammar) -> Iterator[Case]:
    labels = _location_labels(grammar)
    for intent in grammar.intents.values():
        for example in intent.examples:
            case = Case(
                example.text, state=tuple(sorted(intent.requires)), language=grammar.language, place=example.place
            )
            if isinstance(example.expected, str):
                yield replace(case, status=Status(example.expected))
            else:
                needs = tuple(_places(example.expected, labels))
                steps = example.expected.get("steps") if example.expected is not None else None
                if isinstance(steps, list):
                    slots = {"steps": [{"intent": intent.name, "slots": step} for step in steps]}
                    yield replace(case, intent="compound", slots=slots, needs=needs)
                else:
                    yield replace(case, intent=intent.name, slots=example.expected, needs=needs)


def _location_labels(grammar: Grammar) -> frozenset[str]:
    """Under which names slots of places are given."""
    kinds = {name for name, slot in grammar.slots.items() if slot.type == "location"}
    sentences = [sentence.template for intent in grammar.intents.values() for sentence in intent.all_sentences]
    said = (one for node in (*sentences, *grammar.phrases.values()) for one in references(node))
    return frozenset(kinds | {one.label for one in said if one.name in kinds})


def _places(expected: Any, labels: frozenset[str], label: str = "") -> Iterator[str]:
    """The names of places in the slots of an example, those of its steps too."""
    if isinstance(expected, Mapping):
        for key, value in expected.items():
            yield from _places(value, labels, str(key))
    elif isinstance(expected, Sequence) and not isinstance(expected, str):
        for value in expected:
            yield from _places(value, labels, label)
    elif label in labels and isinstance(expected, str):
        yield expected


# -- test files -----------------------------------------------------------------------------------------------


@cache
def _schema() -> dict[str, Any]:
    text = resources.files("intent_engine.testing").joinpath("tests.schema.json").read_text("utf-8")
    loaded: dict[str, Any] = json.loads(text)
    return loaded


def _tests(path: Path, locations: Sequence[Path]) -> Examples:
    source = read_yaml(path, shortest="the shortest test file: tests: [stop]")
    if (other := given_for("test file", source.data, source.file)) is not None:
        raise ConfigError(
            replace(other, hint="it has the name of a test file: let it end otherwise, as lamp.yaml does")
        )
    if source.data is not None:
        source.problems.extend(schema_problems(source, _schema()))
    if source.problems:
        raise ConfigError(source.problems)
    data = source.data
    grammars = list(_named(source, "grammar", "grammars")) or [default_grammar()]
    maps = list(_named(source, "locations", "locations")) or list(locations)
    if source.problems:
        raise ConfigError(source.problems)
    engine = IntentEngine.from_files(grammars, locations=maps or default_locations(grammars))
    kinds = _kinds(engine)
    common = Case("", state=_texts(data.get("state", ())), language=data.get("language"), kinds=kinds)
    _check_states(source, ("state",), data.get("state", ()), engine)
    _check_language(source, engine)
    cases = tuple(_test_cases(source, engine, common))
    doubts = (
        problem_at(case.place, *doubt)
        for case in cases
        if case.slots is not None
        for doubt in doubtful_numbers(case.slots, kinds)
    )
    source.problems.extend(dict.fromkeys(doubts))  # each once, however many sentences have the meaning
    if source.problems:
        raise ConfigError(source.problems)
    return Examples(path, engine, cases)


def _kinds(engine: IntentEngine) -> dict[str, str]:
    """Label -> type of slot, where all slots of this label have the same."""
    found: dict[str, set[str]] = {}
    for grammar in engine.grammars:
        nodes = [sentence.template for intent in grammar.intents.values() for sentence in intent.all_sentences]
        for label, slots in all_slots_by_label(nodes, grammar).items():
            found.setdefault(label, set()).update(slot.type for slot in slots)
    return {label: next(iter(types)) for label, types in found.items() if len(types) == 1}


def _texts(value: Any) -> tuple[str, ...]:
    return (value,) if isinstance(value, str) else tuple(value)


def _named(source: YamlSource, key: str, kind: str) -> Iterator[Path]:
    """The files that a key names: beside the test file, or such as come with the engine. What there is not is told."""
    for at, _, name in source.entries((key,), source.data.get(key)):
        beside = Path(source.file).parent / name
        try:
            found = beside if beside.exists() else find(kind, name)
        except ConfigError as error:
            source.problem(at, error.problems[0].message, near_file(beside) or error.problems[0].hint)
            continue
        if found.is_file():
            yield found
        else:
            folder = "give the path of a file in it" if found.is_dir() else None
            hint = folder or near_file(beside) or "the path is taken from this file's folder"
            source.problem(at, f"{beside} is a folder" if folder else f"there is no file {beside}", hint)


def _test_cases(source: YamlSource, engine: IntentEngine, common: Case) -> Iterator[Case]:
    tests = source.data["tests"]
    if isinstance(tests, dict):
        for intent, entries in tests.items():
            path: YamlPath = ("tests", intent)
            if not _check_intent(source, path, intent, engine, key=True):
                continue
            if not isinstance(entries, list):
                source.problem(path, "the tests of an intent are a list", "- go left: {direction: left}")
            else:
                for index, entry in enumerate(entries):
                    yield from _entry(source, (*path, index), entry, replace(common, intent=intent), engine)
        return
    for index, entry in enumerate(tests):
        yield from _entry(source, ("tests", index), entry, common, engine)


def _check_intent(source: YamlSource, path: YamlPath, intent: Any, engine: IntentEngine, *, key: bool = False) -> bool:
    """Whether an intent is one of the grammars, or the one of several commands at once; told if it is not."""
    known = {name for grammar in engine.grammars for name in (*grammar.intents, grammar.stop_intent)}
    if intent in known or intent == "compound":
        return True
    hint = did_you_mean(str(intent), known) or f"known: {', '.join(sorted(known))}"
    source.problem(path, f"there is no intent {intent!r}", hint, key=key)
    return False


def _check_states(source: YamlSource, path: YamlPath, states: Any, engine: IntentEngine) -> None:
    known = sorted(engine.states)
    for index, name in enumerate(_texts(states)):
        if name not in known:
            hint = did_you_mean(name, known) or f"there is {', '.join(known)}"
            source.problem((*path, index), f"no intent asks for a state {name!r}", hint)


def _check_language(source: YamlSource, engine: IntentEngine) -> None:
    language = source.data.get("language")
    if language is not None and language_of(language) not in engine.languages:
        hint = f"there is {', '.join(engine.languages)}"
        source.problem(("language",), f"no grammar of this file is of language {language!r}", hint)


_KEYS = frozenset(("status", "intent", "slots", "actions", "state"))
"""What a test may say besides its sentence."""
_SAID = ("text", "txt", "sentence", "utterance", "phrase", "input", "query")
"""What other programs call the sentence."""


def _entry(source: YamlSource, path: YamlPath, entry: Any, common: Case, engine: IntentEngine) -> Iterator[Case]:
    common = replace(common, place=source.place(path))
    if isinstance(entry, str):
        yield replace(common, text=entry)
    elif isinstance(entry, dict) and "say" in entry:
        _check_states(source, (*path, "state"), entry.get("state", ()), engine)
        if "intent" in entry:
            _check_intent(source, (*path, "intent"), entry["intent"], engine)
        yield from _long_entry(source, path, entry, common)
    elif isinstance(entry, dict) and len(entry) == 1:
        ((text, expected),) = entry.items()
        if isinstance(expected, str) and expected in RESULTS:
            status = Status(expected)
            intent = common.intent if status is Status.ACCEPTED else None
            yield replace(common, text=text, status=status, intent=intent)
        elif expected is None or isinstance(expected, dict):
            yield replace(common, text=text, slots=expected)
        else:
            hint = f"write say: {expected}" if text in _SAID else "write {slot: value}, or rejected"
            source.problem((*path, text), f"{expected!r} is no meaning", hint)
    elif isinstance(entry, dict) and not _KEYS.isdisjoint(entry):
        wrong = next((key for key in entry if key in _SAID), None)
        source.problem(
            path, "the sentence of this test is missing", f"write say: for {wrong}:" if wrong else "say: ..."
        )
    else:
        source.problem(path, "a test is one sentence and its meaning", '- "go left": {direction: left}')


def _long_entry(source: YamlSource, path: YamlPath, entry: Mapping[str, Any], common: Case) -> Iterator[Case]:
    status = Status(entry.get("status", Status.ACCEPTED))
    actions: list[Action] | None = [] if "actions" in entry else None
    for index, action in enumerate(entry.get("actions", ())):
        try:
            assert actions is not None
            actions.append(from_json(action))
        except ValueError as error:
            source.problem(
                (*path, "actions", index), str(error), "as parse --json shows them: {type: move, distance: 2.0, ...}"
            )
    if not entry["say"]:
        source.problem((*path, "say"), "'say' is empty", "write a sentence, or several in a list")
    for text in _texts(entry["say"]):
        yield replace(
            common,
            text=text,
            status=status,
            intent=entry.get("intent", common.intent if status is Status.ACCEPTED else None),
            slots=entry.get("slots"),
            actions=None if actions is None else tuple(actions),
            state=_texts(entry["state"]) if "state" in entry else common.state,
        )
