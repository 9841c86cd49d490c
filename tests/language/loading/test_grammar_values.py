"""Any value at any place of a grammar file: it loads and understands, or its author is told. Nothing else happens."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError

FILE = yaml.safe_load("""
language: en
fillers: [please]
wake: [robot]
sound_alikes: {whale: [wave]}
operators: {stop: [freeze now]}
phrases: {go: (go|move)}
slots:
  direction: [forward, backward]
  distance: {type: distance, min: 1 cm, max: 5 m}
  speed: speed
  side: {values: {left: [left, port], right: right}}
  angle: {type: angle, unit: deg, min: -90}
  place: {type: location, tags: []}
  thing: {type: text, max_words: 2, allow: [and], without: [email]}
  code: {type: text, max_words: 2}
intents:
  move:
    action: move
    defaults: {speed: 0.5 m/s}
    when: [{slots: {direction: backward}, defaults: {speed: 0.2}}]
    sentences: ['{go} {direction} [{distance}] [at {speed}]', {say: back up, slots: {direction: backward}}]
    examples: [go forward: {direction: forward}, back up, never go: rejected]
    priority: 2
    min_confidence: 0.5
    wait: 400 ms
  turn:
    {action: {type: turn, direction: "{side}"}, sentences: ["turn {side} [{angle}]"], requires: [], excludes: ['off']}
  visit: {action: {type: navigate, location: '{place}'}, sentences: ['visit {place}'], description: places}
  push: {action: {type: custom, name: push, what: '{thing}', times: 3}, sentences: ['push {thing}', 'push']}
  ticket: {action: custom, regex: 'ticket (?P<code>[a-z])', lark: 'start: "stack"'}
""")
TEXTS = ("go forward", "back up", "turn left 90", "visit kitchen", "push the cup", "push", "ticket a", "stack", "stop")
VALUES = st.one_of(
    st.sampled_from(
        [None, True, False, 0, -1, 3.7, float("nan"), float("inf"), 10**400, [], {}, [[]], {"a": 1}, ["a"]]
    ),
    st.sampled_from(
        ["", "a", "{go}", "{side}", "(", "3 m", "-5", "inf m", "nan", "custom", "move", "yes", "2024-01-01"]
    ),
    st.sampled_from(
        [{"type": "move"}, {"type": "custom", "name": "1"}, {"say": "hi"}, {"say": 3}, {"say": "x", "slots": 1}]
    ),
    st.text(max_size=5),
)
KEYS = st.sampled_from(
    ["action", "sentences", "slots", "type", "say", "values", "min", "unit", "regex", "lark", "when"]
)


def places(data: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    children = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    return [path, *(inner for key, value in children for inner in places(value, (*path, key)))]


@st.composite
def changed_files(draw: st.DrawFn) -> str:
    """The file with one to three values or keys changed, removed or added."""
    data = copy.deepcopy(FILE)
    for _ in range(draw(st.integers(1, 3))):
        above, key = data, None
        *way, key = draw(st.sampled_from([path for path in places(data) if path] or [("language",)]))
        for step in way:
            above = above[step]
        how = draw(st.sampled_from(["set", "set", "set", "remove", "rename", "add"]))
        if how == "rename" and isinstance(above, dict) and key in above:
            above[draw(KEYS)] = above.pop(key)
        elif how == "add" and isinstance(above, list):
            above.append(copy.deepcopy(draw(VALUES)))
        elif how == "remove" and (isinstance(above, list) or key in above):
            del above[key]
        else:
            above[key] = copy.deepcopy(draw(VALUES))
    return yaml.safe_dump(data, allow_unicode=True, sort_keys=False)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_file_itself_is_right(folder):
    Path("g.yaml").write_text(yaml.safe_dump(FILE))
    engine = IntentEngine.from_files("g.yaml", locations={"kitchen": (1.0, 2.0)})
    assert [engine.parse(text).status for text in TEXTS] == ["accepted"] * len(TEXTS)


@settings(max_examples=120, deadline=None)
@given(text=changed_files())
def test_any_value_anywhere_loads_or_is_told(tmp_path_factory, text):
    path = tmp_path_factory.getbasetemp() / "changed.yaml"
    path.write_text(text, "utf-8")
    try:
        engine: IntentEngine | None = IntentEngine.from_files(path, locations={"kitchen": (1.0, 2.0)})
    except ConfigError as error:
        engine = None
        problems = error.problems
    if engine is None:
        assert all(problem.message and problem.file == str(path) for problem in problems)
    else:
        for said in TEXTS:
            json.dumps(engine.parse(said).to_json(), allow_nan=False)


@pytest.mark.parametrize("number", [".nan", ".inf", "-.inf", "1.0e+300", "1" + "0" * 400])
@pytest.mark.parametrize("place", ["min", "default", "fixed", "constant", "custom"])
def test_numbers_that_no_robot_can_use(folder, number, place):
    data = {
        "slots": {"distance": {"type": "distance"}},
        "intents": {
            "go": {"action": "move", "sentences": ["go {distance}", {"say": "go", "slots": {"direction": "forward"}}]},
            "push": {"action": {"type": "custom", "name": "push"}, "sentences": ["push"], "defaults": {"times": 1}},
        },
    }
    there = {
        "min": data["slots"]["distance"],
        "default": data["intents"]["go"].setdefault("defaults", {}),
        "fixed": data["intents"]["go"]["sentences"][1]["slots"],
        "constant": data["intents"]["push"]["action"],
        "custom": data["intents"]["push"]["defaults"],
    }[place]
    there[{"min": "min", "default": "speed", "fixed": "distance"}.get(place, "times")] = "NUMBER"
    Path("g.yaml").write_text(yaml.safe_dump(data).replace("NUMBER", number))
    with pytest.raises(ConfigError, match="is no number that a robot can use"):
        IntentEngine.from_files("g.yaml")
