"""What a person is told. The messages themselves are in golden/errors.txt, to be read in every change of them.

After a change of wording: ``UPDATE_GOLDEN=1 pytest tests/test_errors.py``, and read the diff.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from intent_engine import errors
from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError, IntentEngineError, Problem
from intent_engine.execution.robots.robot_file import load_robot
from intent_engine.resources import find
from intent_engine.speech.sources.file import FileSource
from intent_engine.speech.weights import find_weights

GOLDEN = Path(__file__).parent / "golden" / "errors.txt"


def _grammar(text: str) -> Callable[[], object]:
    def load() -> object:
        Path("grammar.yaml").write_text(text, "utf-8")
        return IntentEngine.from_files("grammar.yaml")

    return load


def _map(text: str) -> Callable[[], object]:
    def load() -> object:
        Path("grammar.yaml").write_text("language: en\nintents:\n  stop: {action: stop, sentences: [stop]}\n", "utf-8")
        Path("map.yaml").write_text(text, "utf-8")
        return IntentEngine.from_files("grammar.yaml", locations="map.yaml")

    return load


def _robot(text: str) -> Callable[[], object]:
    def load() -> object:
        Path("robot.yaml").write_text(text, "utf-8")
        return load_robot("robot.yaml")

    return load


def _sound(name: str, data: bytes) -> Callable[[], object]:
    def load() -> object:
        Path(name).write_bytes(data)
        return FileSource(name)

    return load


WAVE = "language: en\nintents:\n  wave:\n    action: {type: custom, name: wave}\n    sentences:\n"

CASES: dict[str, Callable[[], object]] = {
    "grammar: missing": lambda: IntentEngine.from_files("nowhere.yaml"),
    "grammar: not YAML": _grammar("language: en\nintents: [wave\n"),
    "grammar: misspelt key": _grammar("language: en\nintent:\n  wave: {action: stop, sentences: [wave]}\n"),
    "grammar: misspelt slot": _grammar(
        "language: en\nslots:\n  person: {type: text}\n"
        "intents:\n  wave:\n    action: {type: custom, name: wave}\n    sentences:\n      - 'wave [at {persn}]'\n"
    ),
    "grammar: open bracket": _grammar(WAVE + "      - 'wave [at me'\n"),
    "grammar: YAML's yes": _grammar(WAVE + "      - yes\n"),
    "grammar: several mistakes at once": _grammar(
        WAVE + "      - 'wave {who}'\n      - 'wave [at {whom}'\n      - 'look [at me'\n"
    ),
    "grammar: a map": _grammar("frame: map\nlocations:\n  kitchen: {x: 5, y: 2.0, yaw: 0.0}\n"),
    "grammar: waypoints": _grammar("waypoints:\n  kitchen: {pose: [5, 2, 0]}\n"),
    "grammar: a robot": _grammar("name: rover\nlimits: {linear_velocity: 0.5}\n"),
    "grammar: the same sentence twice": _grammar(
        WAVE + "      - wave\n  greet: {action: {type: custom, name: greet}, sentences: [wave]}\n"
    ),
    "map: missing": lambda: (
        _grammar(WAVE + "      - wave\n")(),
        IntentEngine.from_files("grammar.yaml", locations="no.yaml"),
    ),
    "map: no number": _map("frame: map\nlocations:\n  kitchen: {x: five, y: 2.0, yaw: 0.0}\n"),
    "map: a grammar": _map("language: en\nintents:\n  wave: {action: custom, sentences: [wave]}\n"),
    "map: a robot": _map("name: rover\nrates: {rate: 20}\n"),
    "map: said alike": _map(
        "frame: map\nlocations:\n  bay 3: {x: 1, y: 2, yaw: 0}\n  bay three: {x: 1, y: 3, yaw: 0}\n"
    ),
    "robot: misspelt limit": _robot("name: r\nlimits: {linear_velocty: 1.0}\n"),
    "robot: unknown capability": _robot("name: r\ncapabilities: [fly]\n"),
    "robot: a grammar": _robot(WAVE + "      - wave\n"),
    "robot: a map": _robot("locations: {kitchen: {x: 5, y: 2.0}}\n"),
    "robot: no such name": lambda: load_robot("turtlebot"),
    "sound: missing": lambda: FileSource("missing.wav"),
    "sound: empty": _sound("empty.wav", b""),
    "sound: not sound": _sound("notes.wav", b"go forward two meters"),
    "model: no such folder": lambda: find_weights("models/none"),
}


def _message(case: Callable[[], object]) -> str:
    with pytest.raises(IntentEngineError) as caught:
        case()
    return f"[{type(caught.value).__name__}, exit code {caught.value.exit_code}]\n{caught.value}"


def test_messages_are_as_they_were_read(tmp_path, monkeypatch, root):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "grammars").symlink_to(root / "grammars")
    told = "\n\n".join(f"== {name} ==\n{_message(case)}" for name, case in CASES.items()) + "\n"
    if os.environ.get("UPDATE_GOLDEN"):
        GOLDEN.write_text(told, "utf-8")
    assert told == GOLDEN.read_text("utf-8")


def test_a_shipped_file_that_there_is_none_of():
    with pytest.raises(ConfigError, match=r"no file klingon.yaml in grammars/\n    there is .*\ben\b"):
        find("grammars", "klingon")


def test_every_kind_has_its_own_exit_code():
    kinds = [getattr(errors, name) for name in errors.__all__ if name != "Problem"]
    codes = {kind.__name__: kind.exit_code for kind in kinds}
    assert len(set(codes.values())) == len(codes)
    assert codes == {
        "IntentEngineError": 1,
        "ConfigError": 2,
        "AudioError": 3,
        "DeviceError": 4,
        "WeightsError": 5,
        "RobotError": 6,
        "TextTooLongError": 7,
    }, "programs and scripts rely on these"


@pytest.mark.parametrize(
    ("problem", "text"),
    [
        (Problem("it is wrong"), "it is wrong"),
        (Problem("it is wrong", "a.yaml"), "a.yaml: it is wrong"),
        (Problem("it is wrong", "a.yaml", 3, 7), "a.yaml:3:7: it is wrong"),
        (Problem("it is wrong", "a.yaml", 3, 3, "abcdef"), "a.yaml:3:3: it is wrong\n    abcdef\n      ^"),
        (Problem("it is wrong", hint="mend it"), "it is wrong\n    mend it"),
    ],
)
def test_a_problem_shows_its_place(problem, text):
    assert str(problem) == text


def test_all_problems_are_told_at_once():
    problems = [Problem("one", "a.yaml", 1), Problem("two", "b.yaml", 2)]
    error = ConfigError(problems)
    assert error.problems == tuple(problems)
    assert str(error) == "a.yaml:1: one\nb.yaml:2: two"
    assert ConfigError("alone").problems == (Problem("alone"),)
