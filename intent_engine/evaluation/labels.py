"""Recordings and what they mean: a folder with ``labels.jsonl``, one JSON object a line.

``audio``        path of the sound file, from the folder of the labels; the only key that must be there
``text``         what is said
``intent``       what it means; ``null``: no command, and nothing may be done
``slots``        values that must come out; others that come out are not held against it
``actions``      what must be done: whole actions, or their types only (``["move", "turn"]``); ``[]``: nothing
``start, end``   s: the part of the file that is meant
``speech_end``   s from the start of the sound: the end of the last word, to measure latency from
``id``           a name for the row

A row with a text alone means what the grammar makes of the text; no command, if the grammar makes nothing of it. Other
keys are left alone, but for those that are nearly one of these that the row has not.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from intent_engine.actions import Action, from_json
from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError, Problem
from intent_engine.evaluation.label_lines import LabelLineError, file_in_other_form, read_object
from intent_engine.evaluation.label_values import SlotValueError, SlotValues
from intent_engine.hints import did_you_mean
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.grammar import ACTION_PARAMETERS
from intent_engine.language.loading.yaml_source import not_utf8
from intent_engine.language.template_tree import references
from intent_engine.language.utterance import PhraseSet, Utterance

__all__ = ["Expected", "Row", "Step", "evenly", "find_labels", "read_labels", "steps_of"]

FILE = "labels.jsonl"
KEYS = ("audio", "text", "intent", "slots", "actions", "start", "end", "speech_end", "id")
MOST_PROBLEMS = 10
"""Shown of one labels file; a wrong grammar makes one of every row."""
COMPOUND = "compound"


@dataclass(frozen=True, slots=True)
class Step:
    """One command of an utterance."""

    intent: str
    slots: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Expected:
    """What a recording means."""

    steps: tuple[Step, ...] = ()
    """Commands in the order said; empty: not labelled, or no command."""
    actions: tuple[Action, ...] | None = None
    """What must be done; None: not labelled."""
    types: tuple[str, ...] | None = None
    """Types of what must be done; None: not labelled."""
    by_text: bool = False
    """Whether all this was taken from the text: then the same, done after other words ("go for two feet"), is right."""
    stops: bool = False
    """Whether it is a stop that the reflex knows: one of the grammar's stop phrases is said."""

    @property
    def command(self) -> bool:
        """Whether anything is to be done."""
        return bool(self.steps or self.actions or self.types)


@dataclass(frozen=True, slots=True)
class Row:
    """One recording with its label."""

    id: str
    line: int
    """In the labels file, from 1."""
    audio: Path
    expected: Expected
    text: str | None = None
    """What is said; None: not labelled."""
    start: float = 0.0
    """s"""
    end: float | None = None
    """s; None: the end of the file."""
    speech_end: float | None = None
    """s after ``start``; None: not labelled."""


def find_labels(folder: Path) -> Path:
    """The labels file of a folder; or the file itself, if it is one.

    Raises:
        ConfigError: there is none.
    """
    if folder.is_file():
        return folder
    if not folder.is_dir():
        raise ConfigError(Problem("no such folder", file=str(folder), hint="give a folder with audio and labels.jsonl"))
    if (folder / FILE).is_file():
        return folder / FILE
    others = sorted(path.name for path in folder.glob("*.jsonl"))
    if others:
        hint = f"give the file itself: intent-engine evaluate {folder / others[0]}"
    else:
        hint = 'write one JSON object a line: {"audio": "one.wav", "text": "go forward two meters"}'
        if strange := sorted(path.name for path in folder.glob("labels.*")):
            hint = f"{strange[0]} is not read; {hint}"
    raise ConfigError(Problem(f"the folder has no {FILE}", file=str(folder), hint=hint))


def evenly(rows: list[Row], limit: int | None) -> list[Row]:
    """At most ``limit`` rows, spread over the file: labels are often sorted by what they say."""
    if limit is None or limit >= len(rows):
        return rows
    return [rows[index * len(rows) // limit] for index in range(limit)]


def read_labels(path: Path, engine: IntentEngine) -> list[Row]:
    """Read and check a labels file.

    Args:
        path: of the file; its rows name audio files relative to its folder.
        engine: knows the intents and slots, and what a text means.

    Raises:
        ConfigError: with everything that is wrong, each with its line.
    """
    problems: list[Problem] = []
    rows: list[Row] = []
    try:
        text = path.read_text("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ConfigError(not_utf8(str(path), error, f"give the folder with it and {FILE}")) from None
    except OSError as error:
        raise ConfigError(Problem(f"cannot be read: {error.strerror}", file=str(path))) from None
    intents = {name for grammar in engine.grammars for name in grammar.intents}
    slots = {name: _slot_names(engine, name) for name in intents}
    values = SlotValues(engine)
    other_form = file_in_other_form(text)
    if other_form is not None:
        at, form = other_form
        raise ConfigError(Problem(str(form), str(path), at, hint=form.hint))
    for number, line in enumerate(text.split("\n"), 1):
        if not line.strip():
            continue
        reader = _Reader(path, number, line, intents, slots, values, problems)
        row = reader.row(engine)
        if row is not None:
            rows.append(row)
    if problems:
        left = len(problems) - MOST_PROBLEMS
        if left > 0:
            problems = [*problems[:MOST_PROBLEMS], Problem(f"and {left} more like these", file=str(path))]
        raise ConfigError(problems)
    if not rows:
        raise ConfigError(Problem("holds no labels", file=str(path), hint='{"audio": "one.wav", "text": "stop"}'))
    return rows


def steps_of(meaning: Interpretation) -> tuple[Step, ...]:
    """The commands of an accepted interpretation; none of any other."""
    if meaning.status is not Status.ACCEPTED or meaning.intent is None:
        return ()
    if meaning.intent == COMPOUND:
        return _compound(meaning.slots)
    return (Step(meaning.intent, meaning.slots),)


def _compound(slots: Mapping[str, Any]) -> tuple[Step, ...]:
    return tuple(Step(step["intent"], step.get("slots", {})) for step in slots["steps"])


def _says_stop(engine: IntentEngine, text: str) -> bool:
    words = Utterance.of(text).words
    return any(PhraseSet(grammar.operators.stop).find(words) is not None for grammar in engine.grammars)


def _slot_names(engine: IntentEngine, intent: str) -> set[str]:
    names: set[str] = set()
    for grammar in engine.grammars:
        found = grammar.intents.get(intent)
        if found is None:
            continue
        if found.regex or found.lark:
            return set()  # named in another language; anything may come out
        for sentence in found.sentences:
            names |= set(sentence.fixed)
            names |= _labels(sentence.template, grammar.phrases, set())
    return names


def _labels(node: Any, phrases: Mapping[str, Any], seen: set[str]) -> set[str]:
    found: set[str] = set()
    for reference in references(node):
        if reference.name not in phrases:
            found.add(reference.label)
        elif reference.name not in seen:
            found |= _labels(phrases[reference.name], phrases, seen | {reference.name})
    return found


def _nearly(key: str, known: str) -> bool:
    """Whether one key is the other with a slip; one of few letters is, with another letter, any word."""
    from rapidfuzz.distance import OSA

    plain = key.lower().replace("-", "_")
    return plain == known or (len(known) > 3 and OSA.distance(plain, known) <= 1 + (len(known) > 5))


@dataclass(frozen=True)
class _Reader:
    """One line of a labels file."""

    path: Path
    number: int
    line: str
    intents: set[str]
    slots: Mapping[str, set[str]]
    values: SlotValues
    problems: list[Problem]

    def wrong(self, message: str, key: str | None = None, hint: str | None = None) -> None:
        """Note a problem, at a key if that can be found in the line."""
        at = self.line.find(f'"{key}"') if key else -1
        column = at + 1 if at >= 0 else None
        # A line of labels is long; the place in it is told by its key.
        self.problems.append(Problem(message, str(self.path), self.number, column, hint=hint))

    def row(self, engine: IntentEngine) -> Row | None:
        try:
            data: Mapping[str, Any] = read_object(self.line)
        except LabelLineError as error:
            self.problems.append(Problem(str(error), str(self.path), self.number, error.column, hint=error.hint))
            return None
        before = len(self.problems)
        data = self._without_slips(data)
        audio = self._audio(data)
        text = self._typed(data, "text", str, "a text")
        start = self._seconds(data, "start") or 0.0
        end = self._seconds(data, "end")
        if end is not None and end <= start:
            self.wrong(f"'end' is {end:g} s, not after 'start', {start:g} s", "end")
        expected = self._expected(data, text, engine)
        speech_end = self._seconds(data, "speech_end")
        if len(self.problems) > before or audio is None or expected is None:
            return None
        name = str(data.get("id", f"{data['audio']}" + (f"@{start:g}" if start else "")))
        return Row(name, self.number, audio, expected, text, start, end, speech_end)

    def _without_slips(self, data: Mapping[str, Any]) -> Mapping[str, Any]:
        """Note keys that are probably one of ours, and read on as if they were. A key that has nothing to do with them
        is somebody's own."""
        meant = dict(data)
        for key in data:
            free = [known for known in KEYS if known not in meant and _nearly(key, known)]
            if key not in KEYS and free:
                self.wrong(f"unknown key {key!r}", key, hint=f"did you mean {free[0]!r}?")
                meant[free[0]] = meant.pop(key)
        return meant

    def _audio(self, data: Mapping[str, Any]) -> Path | None:
        name = data.get("audio")
        if not isinstance(name, str) or not name:
            given = "is missing" if "audio" not in data else f"must be the path of a sound file, not {name!r}"
            self.wrong(f"'audio' {given}", "audio", hint='"audio": "one.wav"')
            return None
        audio = self.path.parent / name
        if not _is_file(audio):
            self.wrong(f"there is no sound file {audio}", "audio", hint=_other_file(name, audio))
            return None
        return audio

    def _typed(self, data: Mapping[str, Any], key: str, kind: type, name: str) -> Any:
        value = data.get(key)
        if value is None or isinstance(value, kind):
            return value
        self.wrong(f"'{key}' must be {name}, not {value!r}", key)
        return None

    def _seconds(self, data: Mapping[str, Any], key: str) -> float | None:
        value = data.get(key)
        if value is None:
            return None
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value) or value < 0:
            self.wrong(f"'{key}' must be a number of seconds, not {value!r}", key)
            return None
        return float(value)

    def _expected(self, data: Mapping[str, Any], text: str | None, engine: IntentEngine) -> Expected | None:
        if "intent" not in data and data.get("text") is None and data.get("actions") is None:
            self.wrong("says nothing of what is said", hint="add 'text', or 'intent' and 'slots', or 'actions'")
            return None
        steps: tuple[Step, ...] = ()
        if "intent" in data:
            steps = self._steps(data)
        elif "slots" in data:
            self.wrong("has 'slots' but no 'intent'", "slots", hint="say whose slots they are")
        actions, types = self._actions(data)
        labelled = "actions" in data and data["actions"] is not None
        if "intent" in data and labelled and bool(data["intent"]) is not bool(data["actions"]):
            what = "an 'intent' and yet no 'actions'" if data["intent"] else "'actions' and yet no 'intent' (null)"
            self.wrong(f"has {what}", "actions", hint="leave out what is not meant")
        if "intent" not in data and not labelled:
            meaning = engine.parse(text or "", spoken=True)
            steps = steps_of(meaning)
            actions = meaning.actions if meaning.status is Status.ACCEPTED else None
        kinds = types or tuple(action.type for action in actions or ()) or tuple(map(self._kind(engine), steps))
        stops = bool(kinds) and set(kinds) == {"stop"} and (text is None or _says_stop(engine, text))
        return Expected(steps, actions, types, by_text=actions is not None and not labelled, stops=stops)

    def _kind(self, engine: IntentEngine) -> Callable[[Step], str]:
        kinds = {name: intent.action.type for grammar in engine.grammars for name, intent in grammar.intents.items()}
        return lambda step: kinds.get(step.intent, "")

    def _steps(self, data: Mapping[str, Any]) -> tuple[Step, ...]:
        intent = self._typed(data, "intent", str, "the name of an intent, or null for no command")
        slots = self._typed(data, "slots", dict, "an object") or {}
        if intent is None:
            if slots:
                self.wrong("has 'slots' but no intent", "slots", hint="no command has no slots")
            return ()
        if intent == COMPOUND:
            try:
                steps = _compound(slots)
            except (KeyError, TypeError, AttributeError):
                self.wrong(
                    "'compound' needs its steps",
                    "slots",
                    hint='"slots": {"steps": [{"intent": "move", "slots": {}}, {"intent": "turn", "slots": {}}]}',
                )
                return ()
        else:
            steps = (Step(intent, slots),)
        return tuple(self._known(step) for step in steps)

    def _known(self, step: Step) -> Step:
        """A step with its values as the engine gives them; what it cannot give is noted."""
        if step.intent not in self.intents:
            message = f"intent {step.intent!r} is not in the grammar"
            if any(problem.message == message for problem in self.problems):
                return step  # a wrong grammar is one mistake, not one of every row
            self.wrong(
                message,
                "intent",
                hint=_other_intent(step.intent, self.intents),
            )
            return step
        known = self.slots[step.intent]
        read = dict(step.slots)
        for name, value in step.slots.items():
            if known and name not in known:
                self.wrong(
                    f"intent {step.intent!r} has no slot {name!r}", name, hint=f"it has {', '.join(sorted(known))}"
                )
                continue
            try:
                read[name] = self.values.read(step.intent, name, value)
            except SlotValueError as error:
                self.wrong(str(error), name, hint=error.hint)
        return Step(step.intent, read)

    def _actions(self, data: Mapping[str, Any]) -> tuple[tuple[Action, ...] | None, tuple[str, ...] | None]:
        listed = self._typed(data, "actions", list, "a list of actions")
        if listed is None:
            return None, None
        if listed and all(isinstance(item, str) for item in listed):
            for item in listed:
                if item not in ACTION_PARAMETERS:
                    known = ", ".join(ACTION_PARAMETERS)
                    self.wrong(f"there is no action {item!r}", "actions", hint=f"there is {known}")
            return None, tuple(listed)
        return tuple(found for item in listed if (found := self._action(item)) is not None), None

    def _action(self, item: Any) -> Action | None:
        try:
            return from_json(item)
        except ValueError as error:
            self.wrong(f"'actions': {error}", "actions")
            return None


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # a name too long for any file, or a folder that may not be looked into
        return False


def _other_file(name: str, path: Path) -> str:
    """What to write for a sound file that is not there."""
    if "\\" in name:
        return "write paths with /"
    beside = sorted(other.name for other in path.parent.iterdir()) if path.parent.is_dir() else []
    for alike in (lambda one: one.lower(), lambda one: Path(one).stem.lower()):
        found = [one for one in beside if alike(one) == alike(path.name)]
        if found:
            return f"did you mean {found[0]!r}?"
    return "its path is taken from the folder of the labels"


def _other_intent(name: str, known: Collection[str]) -> str:
    """What to write for an intent that the grammar has not."""
    if name in ("none", "null", "None", ""):
        return "no command is null, without quotes"
    listed = f"it has {', '.join(sorted(known))}; another grammar: --grammar FILE"
    near = did_you_mean(name, known)
    return f"{near} {listed}" if near else listed
