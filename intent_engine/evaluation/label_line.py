"""One line of a labels file, checked: a row, or what is wrong with it and where."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from intent_engine.actions import Action, from_json
from intent_engine.engine import IntentEngine
from intent_engine.errors import Problem
from intent_engine.evaluation.label_json import LabelLineError, read_object
from intent_engine.evaluation.label_values import SlotValueError, SlotValues
from intent_engine.evaluation.labels import COMPOUND, Expected, Row, Step, steps_in, steps_of
from intent_engine.hints import did_you_mean
from intent_engine.interpretation import Status
from intent_engine.language.grammar import ACTION_PARAMETERS
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["LabelLine"]

KEYS = ("audio", "text", "intent", "slots", "actions", "start", "end", "speech_end", "id")
ELSEWHERE = {
    "audio": (
        *("audio_filepath", "audio_file", "audio_path", "path", "file", "file_name", "filename"),
        *("wav", "wav_path", "wav_filename", "filepath"),
    ),
    "text": ("sentence", "transcript", "transcription", "utterance", "normalized_text"),
}
"""Keys -> what NeMo, Common Voice, Hugging Face and others call them."""


@dataclass(frozen=True)
class LabelLine:
    """One line of a labels file."""

    path: Path
    """Of the file; audio files are named relative to its folder."""
    number: int
    """Of the line, from 1."""
    line: str
    intents: set[str]
    """Names that the grammars know."""
    slots: Mapping[str, set[str]]
    """By intent, the names of its slots; none: any may be there."""
    values: SlotValues
    problems: list[Problem]
    """What is wrong with the file; more is added to them."""
    doubts: list[Problem] = field(default_factory=list)
    """What can hardly be meant in the line, though it can be read."""

    def wrong(self, message: str, key: str | None = None, hint: str | None = None) -> None:
        """Note a problem, at a key if that can be found in the line."""
        self.problems.append(self._problem(message, key, hint))

    def odd(self, message: str, key: str, hint: str | None) -> None:
        """Note a doubt: a label may be of a robot that can do more, and counts as any other."""
        self.doubts.append(self._problem(message, key, hint))

    def _problem(self, message: str, key: str | None, hint: str | None) -> Problem:
        at = self.line.find(f'"{key}"') if key else -1
        column = at + 1 if at >= 0 else None
        # A line of labels is long; the place in it is told by its key.
        return Problem(message, str(self.path), self.number, column, hint=hint)

    def row(self, engine: IntentEngine) -> Row | None:
        """The row of the line; None: something is wrong with it, and noted.

        Args:
            engine: what a text means.
        """
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
        return Row(name, self.number, audio, expected, text, start, end, speech_end, tuple(self.doubts))

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
            other = _renamed(data, "audio") if "audio" not in data else None
            self.wrong(f"'audio' {given}", "audio", hint=other or '"audio": "one.wav"')
            return None
        audio = self.path.parent / name
        if not _is_file(audio):
            if os.path.isdir(audio):  # noqa: PTH112 - never raises, of whatever name
                self.wrong(f"{audio} is a folder", "audio", hint="give each sound file in it a line")
            else:
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
            hint = _renamed(data, "text") or "add 'text', or 'intent' and 'slots', or 'actions'"
            self.wrong("says nothing of what is said", hint=hint)
            return None
        for key in ("slots", "actions"):
            if not _is_finite(data.get(key)):
                self.wrong(f"'{key}' holds NaN or an infinite number", key, hint="leave such a value out")
                return None
        steps: tuple[Step, ...] = ()
        if "intent" in data:
            steps = self._steps(data)
        elif "slots" in data:
            self.wrong("has 'slots' but no 'intent'", "slots", hint="say whose slots they are")
        actions, types = self._actions(data, engine)
        labelled = "actions" in data and data["actions"] is not None
        if "intent" in data and labelled and bool(data["intent"]) is not bool(data["actions"]):
            what = "an 'intent' and yet no 'actions'" if data["intent"] else "'actions' and yet no 'intent' (null)"
            self.odd(f"has {what}", "actions", hint="leave out what is not meant")
        if "intent" not in data and not labelled:
            meaning = engine.parse(text or "", spoken=True)
            steps = steps_of(meaning)
            actions = meaning.actions if meaning.status is Status.ACCEPTED else None
        kinds = types or tuple(action.type for action in actions or ()) or tuple(map(self._kind(engine), steps))
        stops = bool(kinds) and set(kinds) == {"stop"} and (text is None or _says_stop(engine, text))
        return Expected(steps, actions, types, by_text=actions is not None and not labelled, stops=stops)

    def _kind(self, engine: IntentEngine) -> Callable[[Step], str]:
        kinds = {grammar.stop_intent: "stop" for grammar in engine.grammars}
        for grammar in engine.grammars:
            kinds |= {name: intent.action.type for name, intent in grammar.intents.items()}
        return lambda step: kinds.get(step.intent, "")

    def _steps(self, data: Mapping[str, Any]) -> tuple[Step, ...]:
        intent = self._typed(data, "intent", str, "the name of an intent, or null for no command")
        slots = self._typed(data, "slots", dict, "an object") or {}
        if intent is None:
            if slots:
                self.wrong("has 'slots' but no intent", "slots", hint="no command has no slots")
            return ()
        if intent == COMPOUND:
            listed = slots.get("steps")
            if isinstance(listed, list) and listed and all(map(_is_step, listed)):
                steps = steps_in(slots)
            else:
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
                self.odd(str(error), name, hint=error.hint)
        return Step(step.intent, read)

    def _actions(
        self, data: Mapping[str, Any], engine: IntentEngine
    ) -> tuple[tuple[Action, ...] | None, tuple[str, ...] | None]:
        listed = self._typed(data, "actions", list, "a list of actions")
        if listed is None:
            return None, None
        if listed and all(isinstance(item, str) for item in listed):
            known = [*ACTION_PARAMETERS, *_own_actions(engine)]
            for item in listed:
                if item not in known:
                    hint = did_you_mean(item, known) or f"there is {', '.join(known)}"
                    self.wrong(f"there is no action {item!r}", "actions", hint=hint)
            return None, tuple(listed)
        return tuple(found for item in listed if (found := self._action(item)) is not None), None

    def _action(self, item: Any) -> Action | None:
        if isinstance(item, str):
            self.wrong("'actions' are whole actions, or their types and names only", "actions", hint='["move", "turn"]')
            return None
        try:
            return from_json(item)
        except ValueError as error:
            self.wrong(f"'actions': {error}", "actions")
            return None


def _own_actions(engine: IntentEngine) -> Collection[str]:
    """Names of the grammars' custom actions."""
    intents = [intent for grammar in engine.grammars for intent in grammar.intents.values()]
    return sorted({intent.action.name for intent in intents if intent.action.name is not None})


def _renamed(data: Mapping[str, Any], key: str) -> str | None:
    """What to write for a key that is not there, if the line has it by a name of another format."""
    other = next((name for name in ELSEWHERE[key] if isinstance(data.get(name), str)), None)
    return other and f"here {other!r} is called {key!r}"


def _is_step(value: Any) -> bool:
    """Whether a value is one of several commands."""
    if not isinstance(value, Mapping):
        return False
    return isinstance(value.get("intent"), str) and isinstance(value.get("slots"), Mapping | None)


def _is_finite(value: Any) -> bool:
    """Whether all numbers in a value are: Python reads others too, but nothing that is told of them would be JSON."""
    if isinstance(value, Mapping):
        return all(map(_is_finite, value.values()))
    if isinstance(value, list):
        return all(map(_is_finite, value))
    return not isinstance(value, float) or math.isfinite(value)


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


def _says_stop(engine: IntentEngine, text: str) -> bool:
    words = Utterance.of(text).words
    return any(PhraseSet(grammar.operators.stop).find(words) is not None for grammar in engine.grammars)


def _nearly(key: str, known: str) -> bool:
    """Whether one key is the other with a slip; one of few letters is, with another letter, any word."""
    from rapidfuzz.distance import OSA

    plain = key.lower().replace("-", "_")
    return plain == known or (len(known) > 3 and OSA.distance(plain, known) <= 1 + (len(known) > 5))
