"""Recordings and what they mean: a folder with ``labels.jsonl``, one JSON object a line.

``audio``        path of the sound file, from the folder of the labels; the only key that must be there
``text``         what is said
``intent``       what it means; ``null``: no command, and nothing may be done
``slots``        values that must come out; others that come out are not held against it
``actions``      what must be done: whole actions, or only their types (``["move", "turn"]``) and the names of custom
                 ones (``["wave"]``); ``[]``: nothing
``start, end``   s: the part of the file that is meant
``speech_end``   s from the start of the sound: the end of the last word, to measure latency from
``id``           a name for the row

A row with a text alone means what the grammar makes of the text; no command, if the grammar makes nothing of it. Other
keys are left alone, but for those that are nearly one of these that the row has not.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError, Problem
from intent_engine.evaluation.label_json import file_in_other_form
from intent_engine.evaluation.label_line import LabelLine
from intent_engine.evaluation.label_values import SlotValues
from intent_engine.evaluation.labels import Row
from intent_engine.language.loading.yaml_source import not_utf8
from intent_engine.language.templates.template_tree import references

__all__ = ["MOST_PROBLEMS", "find_labels", "read_labels"]

FILE = "labels.jsonl"
MOST_PROBLEMS = 10
"""Shown of one labels file; a wrong grammar makes one of every row."""


def find_labels(folder: Path) -> Path:
    """The labels file of a folder; or the file itself, if it is one.

    Raises:
        ConfigError: there is none.
    """
    try:
        is_file, is_folder = folder.is_file(), folder.is_dir()
    except OSError as error:  # of a name too long for any file, or in a folder that may not be looked into
        raise ConfigError(Problem(f"cannot be read: {error.strerror}", file=str(folder))) from None
    if is_file:
        return folder
    if not is_folder:
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
    intents = {name for grammar in engine.grammars for name in (*grammar.intents, grammar.stop_intent)}
    slots = {name: _slot_names(engine, name) for name in intents}
    values = SlotValues(engine)
    other_form = file_in_other_form(text)
    if other_form is not None:
        at, form = other_form
        raise ConfigError(Problem(str(form), str(path), at, hint=form.hint))
    for number, line in enumerate(text.split("\n"), 1):
        if not line.strip():
            continue
        reader = LabelLine(path, number, line, intents, slots, values, problems)
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
    return _with_doubles(rows, path)


def _with_doubles(rows: list[Row], path: Path) -> list[Row]:
    """The rows, with a doubt about each whose sound another row has already."""
    known: dict[tuple[Path, float, float | None], Row] = {}
    found = []
    for row in rows:
        first = known.setdefault((row.audio.resolve(), row.start, row.end), row)
        if first is not row:
            same = row.expected == first.expected
            what = "it counts twice" if same else "as something else, and cannot be both"
            message = f"{row.audio.name} is labelled in line {first.line} already: {what}"
            hint = "leave one of them out; parts of one file have a 'start' and an 'end'"
            row = replace(row, doubts=(*row.doubts, Problem(message, str(path), row.line, hint=hint)))
        found.append(row)
    return found


def _slot_names(engine: IntentEngine, intent: str) -> set[str]:
    names: set[str] = set()
    for grammar in engine.grammars:
        found = grammar.intents.get(intent)
        if found is None:
            continue
        if found.regex or found.lark:
            return set()  # named in another language; anything may come out
        for sentence in found.all_sentences:
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
