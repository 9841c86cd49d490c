"""Files of tests: what is left out is not compared, what is written is, and what can never be is told."""

from __future__ import annotations

import textwrap
from pathlib import Path

import pytest

from intent_engine.errors import ConfigError
from intent_engine.testing.examples import load_examples, run_case


def parts(folder: Path, tests: str) -> list[list[str]]:
    """Of each test in a file, what was found otherwise."""
    file = folder / "my.intents.yaml"
    file.write_text("tests:\n" + textwrap.indent(textwrap.dedent(tests), "  "), "utf-8")
    loaded = load_examples(file)
    return [[row.part for row in run_case(loaded.engine, case).differences] for case in loaded.cases]


@pytest.mark.parametrize(
    ("steps", "differs"),
    [
        ("[{intent: turn}, {intent: move}]", []),
        ("[{slots: {side: left}}, {}]", []),
        ("[{intent: turn}, {intent: move, slots: {direction: forward, distance: 2 m}}]", []),
        ("[{intent: move}, {intent: turn}]", ["slots.steps"]),
        ("[{intent: turn, slots: {}}, {intent: move}]", ["slots.steps"]),
        ("[{intent: turn, slots: 3}, {intent: move}]", ["slots.steps"]),
        ("[turn, move]", ["slots.steps"]),
        ("[{intent: turn}]", ["slots.steps"]),
        ("turn", ["slots.steps"]),
    ],
)
def test_of_several_commands_what_is_left_out_is_not_compared(tmp_path, steps, differs):
    say = "turn left and go forward two meters"
    long = f"- say: {say}\n  intent: compound\n  slots: {{steps: {steps}}}\n"
    assert parts(tmp_path, f'{long}- "{say}": {{steps: {steps}}}\n') == [differs, differs]


@pytest.mark.parametrize(
    ("value", "differs"),
    [
        ("2 m", []),
        ("200 cm", []),
        ('"two meters"', []),
        ('"2"', []),
        ("2.0", []),
        ("2 s", ["slots.distance"]),
        ("200 %", ["slots.distance"]),
        ("2 rad", ["slots.distance"]),
        ("3 m", ["slots.distance"]),
    ],
)
def test_a_quantity_has_a_unit_of_its_kind(tmp_path, value, differs):
    test = f"go forward two meters: {{direction: forward, distance: {value}}}"
    assert parts(tmp_path, f"- {test}") == [differs]
    steps = f"[{{intent: turn}}, {{slots: {{direction: forward, distance: {value}}}}}]"
    several = ["slots.steps"] if differs else []
    assert parts(tmp_path, f"- turn left and go forward two meters: {{steps: {steps}}}") == [several]


@pytest.mark.parametrize(
    ("value", "failed"), [("90 deg", False), ("1.5707963267948966 m", True), ("1.5707963267948966 s", True)]
)
def test_an_example_of_a_grammar_has_a_unit_of_its_kind(tmp_path, value, failed):
    file = tmp_path / "dial.yaml"
    examples = f"[{{dial 90 degrees: {{by: {value}}}}}]"
    intents = f'{{dial: {{action: custom, sentences: ["dial {{by}}"], examples: {examples}}}}}'
    file.write_text(f"slots: {{by: {{type: angle}}}}\nintents: {intents}\n")
    loaded = load_examples(file)
    assert [run_case(loaded.engine, case).failed for case in loaded.cases] == [failed]


@pytest.mark.parametrize(
    ("status", "say", "differs"),
    [
        ("accepted", "turn left", ["actions"]),
        ("rejected", "the weather", []),
        ("rejected", "stop", ["status", "actions"]),
    ],
)
def test_no_actions_are_nothing_that_is_done(tmp_path, status, say, differs):
    assert parts(tmp_path, f"- {{say: {say}, status: {status}, actions: []}}") == [differs]


def test_a_grammar_with_the_name_of_a_test_file_is_told(tmp_path):
    file = tmp_path / "my.intents.yaml"
    file.write_text("intents: {shine: {action: custom, sentences: [shine]}}\n")
    with pytest.raises(ConfigError, match=r"is a grammar, not a test file\n +it has the name of a test file"):
        load_examples(file)


def test_an_intent_that_is_not_there_is_told_wherever_it_stands(tmp_path):
    with pytest.raises(ConfigError, match=r"my\.intents\.yaml:3:1\d: there is no intent 'trun'"):
        parts(tmp_path, "- say: turn left\n  intent: trun")
    with pytest.raises(ConfigError, match=r"my\.intents\.yaml:2:3: there is no intent 'trun'"):
        parts(tmp_path, "trun: [turn left]")
    assert parts(tmp_path, "compound: [turn left and go forward]\nstop: [stop]") == [[], []]


@pytest.mark.parametrize(
    ("test", "told"),
    [
        ("- {text: stop, intent: stop}", r":2:5: the sentence of this test is missing\n.*\n.*\n +write say: for text:"),
        ("- {intent: stop, status: accepted}", r":2:5: the sentence of this test is missing"),
        ("- {utterance: stop}", r":2:17: 'stop' is no meaning\n.*\n.*\n +write say: stop"),
        ("- {say: stop, intent: stpo}", r":2:25: there is no intent 'stpo'\n.*\n.*\n +did you mean 'stop'"),
        ("- stop\ngrammar: lampp.yaml", r":3:10: there is no file .*lampp.yaml\n.*\n.*\n +did you mean 'lamp.yaml'"),
        ("- stop\ngrammar: ..", r":3:10: .* is a folder\n.*\n.*\n +give the path of a file in it"),
        ("- {say: [], intent: stop}", r":2:11: 'say' is empty"),
        ("- stop\nlanguage: de", r":3:11: no grammar of this file is of language 'de'\n.*\n.*\n +there is en"),
        ("- stop\nlocations: [home, attic]", r":3:19: no file attic.yaml in locations/\n.*\n.*\n +there is home"),
    ],
)
def test_what_is_wrong_in_a_file_of_tests_has_its_place(tmp_path, test, told):
    (tmp_path / "lamp.yaml").write_text("intents: {shine: {action: custom, sentences: [shine]}}\n")
    (tmp_path / "my.intents.yaml").write_text(f"tests:\n  {test}\n")
    with pytest.raises(ConfigError, match=rf"my\.intents\.yaml{told}"):
        load_examples(tmp_path / "my.intents.yaml")
