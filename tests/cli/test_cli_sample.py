"""``intent-engine sample`` and ``intent-engine test``, as a person and as a program meet them."""

from __future__ import annotations

import json

import pytest

GRAMMAR = """\
language: en
slots: {person: [anna, bob]}
intents:
  wave:
    action: {type: custom, name: wave}
    sentences: ["wave [at {person}]"]
    examples:
      - "wave at anna": {person: anna}
      - "wave at bob": {person: anna}
"""
GOOD = "grammar: wave.yaml\ntests:\n  - wave at bob: {person: bob}\n  - don't wave: rejected\n"


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "wave.yaml").write_text(GRAMMAR, "utf-8")
    (tmp_path / "good.intents.yaml").write_text(GOOD, "utf-8")
    return tmp_path


def test_sentences_with_their_meaning(in_process):
    done = in_process("sample", "-n", 5, "--intent", "turn", "--seed", 7)
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert len(lines) == 10
    assert all(line.startswith("    turn ") and "side=" in line and "-> turn " in line for line in lines[1::2])
    assert done.stdout == in_process("sample", "-n", 5, "--intent", "turn", "--seed", 7).stdout
    assert done.stdout != in_process("sample", "-n", 5, "--intent", "turn", "--seed", 8).stdout


def test_what_is_sampled_is_understood(intent_engine):
    done = intent_engine("sample", "--json", "-n", 30)
    sampled = [json.loads(line) for line in done.stdout.splitlines()]
    assert all(list(each) == ["text", "intent", "slots", "actions"] for each in sampled)
    text = "\n".join(each["text"] for each in sampled)
    parsed = intent_engine("parse", "-", stdin=text.encode())
    assert parsed.returncode == 0, parsed.stdout
    assert [json.loads(line)["intent"] for line in parsed.stdout.splitlines()] == [each["intent"] for each in sampled]


def test_an_intent_that_there_is_none_of(in_process):
    done = in_process("sample", "--intent", "mov")
    assert done.returncode == 2
    assert done.stderr == "error: there is no intent 'mov'; did you mean 'move'?\n"


def test_examples_that_hold(in_process, folder):
    done = in_process("test", folder / "good.intents.yaml")
    assert (done.returncode, done.stdout) == (0, "2 examples: 2 passed, 0 failed\n")
    assert in_process("test").returncode == 0, "those of the shipped grammar"


def test_a_table_of_failures(in_process, folder):
    done = in_process("test", "wave.yaml", "good.intents.yaml", cwd=folder)
    assert done.returncode == 1
    rows = [line.split() for line in done.stdout.splitlines()]
    assert ["wave.yaml:9", "wave", "at", "bob", "slots.person", "anna", "bob"] in rows
    assert rows[-1] == ["4", "examples:", "3", "passed,", "1", "failed"]


def test_failures_on_a_narrow_terminal_are_listed_with_no_word_cut(in_process, folder):
    (folder / "two.intents.yaml").write_text("grammar: wave.yaml\ntests: [{wave at bob: {who: anna}}]\n")
    done = in_process("test", "wave.yaml", "two.intents.yaml", cwd=folder, COLUMNS="40")
    assert done.returncode == 1
    shown = [line.rstrip() for line in done.stdout.splitlines()]
    assert shown.count("wave.yaml:9, wave at bob") == 1
    assert shown.count("two.intents.yaml:2, wave at bob") == 1, "once, though two of its slots differ"
    parts = ["slots.person", "slots.who", "slots.person"]
    assert [line for line in shown if "part" in line] == [f"  part      {part}" for part in parts]


def test_a_line_for_each_example(in_process, folder):
    done = in_process("test", "--json", "wave.yaml", cwd=folder)
    assert done.returncode == 1
    good, bad = (json.loads(line) for line in done.stdout.splitlines())
    assert (good["passed"], good["differences"], good["line"]) == (True, [], 8)
    assert bad["differences"] == [{"part": "slots.person", "expected": "anna", "found": "bob"}]
    assert bad["found"]["slots"] == {"person": "bob"}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("tests: [{say: wave, slot: {}}]", "did you mean 'slots'?"),
        ("", "bad.intents.yaml: is empty\n    the shortest test file: tests: [stop]\n"),
        ("tests:\n  - wave: 3", "is no meaning"),
        ("tests:\n  - turn left ninety degrees: {side: left, angle: 90}", "write 90 deg, or 90 rad if you mean it"),
        (
            "tests:\n  - {say: [a, b], intent: turn, slots: {angle: 90}}",
            "bad.intents.yaml:2:5: slot 'angle': 90 is 90 rad",
        ),
        ("grammar: nowhere.yaml\ntests: [wave]", "nowhere.yaml"),
        ("tests:\n  - {say: wave, actions: [{type: fly}]}", "unknown action type 'fly'"),
        ("tests:\n  wav: [wave]", "there is no intent 'wav'"),
        ("state: movin\ntests: [stop]", "bad.intents.yaml:1:8: no intent asks for a state 'movin'"),
        (
            "tests:\n  - {say: stop, state: [moving, flying]}",
            "bad.intents.yaml:2:33: no intent asks for a state 'flying'",
        ),
    ],
)
def test_a_wrong_test_file(in_process, tmp_path, text, message):
    (tmp_path / "bad.intents.yaml").write_text(text, "utf-8")
    done = in_process("test", tmp_path / "bad.intents.yaml")
    assert done.returncode == 2
    assert message in done.stderr
    assert "Traceback" not in done.stderr
