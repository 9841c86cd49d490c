"""The plugin, in runs of pytest of its own."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
import yaml  # noqa: F401  here, for pytester forgets what is first imported in its runs, and yaml's C part is loaded once

from intent_engine.engine import IntentEngine

pytest_plugins = ["pytester"]
ROOT = Path(__file__).resolve().parent.parent.parent

GRAMMAR = """\
language: en
slots:
  person: [anna, bob]
  angle: {type: angle, unit: deg}
intents:
  wave:
    action: {type: custom, name: wave}
    sentences:
      - "wave [at {person}]"
      - "greet {person}"
    examples:
      - "wave at anna": {person: anna}
      - "wave at bob": {person: anna}
      - "don't wave": rejected
  spin:
    action: {type: custom, name: spin}
    sentences: ["spin {angle}"]
    examples:
      - "spin ninety degrees": {angle: 90 deg}
  nod: {action: {type: custom, name: nod}, sentences: [nod]}
"""
TESTS = """\
grammar: wave.yaml
tests:
  wave:
    - "wave": {}
    - say: ["greet bob", "greet bob twice"]
      slots: {person: bob}
      actions: [{type: custom, name: wave, slots: {person: bob}}]
  spin:
    - "spin 1.5 rad": {angle: 1.5}
    - "spin right round": rejected
"""


@pytest.fixture
def folder(pytester):
    (pytester.path / "wave.yaml").write_text(GRAMMAR, "utf-8")
    (pytester.path / "wave.intents.yaml").write_text(TESTS, "utf-8")
    return pytester


def test_test_files_are_collected_by_their_name(folder):
    result = folder.runpytest("-v")
    result.stdout.fnmatch_lines(
        [
            "wave.intents.yaml::4: wave PASSED*",
            "wave.intents.yaml::5: greet bob PASSED*",
            "wave.intents.yaml::5: greet bob twice FAILED*",
            "wave.intents.yaml::9: spin 1.5 rad PASSED*",
            "wave.intents.yaml::10: spin right round PASSED*",
        ]
    )
    assert "wave.yaml" not in result.stdout.str().replace("wave.intents.yaml", ""), "a grammar is no test by itself"
    result.assert_outcomes(passed=4, failed=1)


def test_a_grammar_named_on_the_command_line_or_by_the_settings(folder):
    folder.runpytest("wave.yaml").assert_outcomes(passed=3, failed=1)
    folder.makeini("[pytest]\nintent_grammars = *.yaml\n")
    folder.runpytest().assert_outcomes(passed=3 + 4, failed=2)


def test_a_failure_names_its_line_and_shows_the_slots_that_differ(folder):
    result = folder.runpytest("wave.yaml", "-rf")
    result.stdout.fnmatch_lines(
        [
            "*_ wave.yaml:13 wave at bob _*",
            "wave.yaml:13: 'wave at bob' is understood otherwise",
            "              expected  found",
            "slots.person  anna      bob",
            "FAILED wave.yaml::13: wave at bob*",
        ]
    )
    assert "Traceback" not in result.stdout.str()
    assert "pytest_plugin.py" not in result.stdout.str()


def test_a_reason_is_told_for_what_was_not_accepted(folder):
    tests = TESTS.replace("greet bob twice", "greet zoe")
    (folder.path / "wave.intents.yaml").write_text(tests, "utf-8")
    result = folder.runpytest("wave.intents.yaml")
    result.stdout.fnmatch_lines(["status*accepted*rejected (*'zoe')", "reason: *", "nearest: bob, anna"])


def test_a_broken_file_is_told_as_the_engine_tells_it(folder):
    (folder.path / "wave.intents.yaml").write_text("grammar: wave.yaml\ntests:\n  wav: []\n", "utf-8")
    result = folder.runpytest()
    result.stdout.fnmatch_lines(["*wave.intents.yaml:3:3: there is no intent 'wav'"])
    result.assert_outcomes(errors=1)
    (folder.path / "wave.intents.yaml").write_text("tests: [{say: wave, slot: {}}]\n", "utf-8")
    result = folder.runpytest()
    assert "did you mean 'slots'?" in result.stdout.str()


def test_the_map_of_the_settings(folder):
    (folder.path / "go.yaml").write_text(
        "language: en\nslots: {place: {type: location}}\n"
        "intents:\n  go:\n    action: {type: navigate, location: '{place}'}\n"
        "    sentences: ['go to {place}']\n    examples:\n      - go to bay one: {place: bay 1}\n",
        "utf-8",
    )
    (folder.path / "map.yaml").write_text("locations: {bay 1: {x: 1.0, y: 2.0, yaw: 0.0}}\n", "utf-8")
    result = folder.runpytest("go.yaml", "-rs")
    result.assert_outcomes(skipped=1)
    result.stdout.fnmatch_lines(["*no place of the map is called 'bay 1'; the ini option intent_locations*"])
    folder.makeini("[pytest]\nintent_locations = map.yaml\n")
    folder.runpytest("go.yaml").assert_outcomes(passed=1)


def test_coverage_lists_what_no_test_reaches(folder):
    result = folder.runpytest("wave.yaml", "--intent-coverage")
    result.stdout.fnmatch_lines(
        [
            "*= intent coverage =*",
            "wave.yaml: 2 of 3 intents, 2 of 4 sentences, 2 of 2 slots",
            "  intent   wave.yaml:20 * nod",
            "  sentence wave.yaml:10 * wave: greet {person}",
            "  sentence wave.yaml:20 * nod: nod",
        ]
    )
    result = folder.runpytest("wave.yaml", "wave.intents.yaml", "--intent-coverage")
    result.stdout.fnmatch_lines(["wave.yaml: 2 of 3 intents, 3 of 4 sentences, 2 of 2 slots"])


def test_coverage_counts_what_an_included_grammar_of_the_engine_has(folder):
    """Its own tests are elsewhere: two hundred lines of it would hide the two that are missing here."""
    (folder.path / "nod.yaml").write_text(
        "include: [en]\nintents:\n  nod:\n    action: custom\n    sentences: [nod, bow]\n    examples: [nod]\n", "utf-8"
    )
    told = folder.runpytest("nod.yaml", "--intent-coverage").stdout.lines
    (title,) = (at for at, line in enumerate(told) if "nod.yaml: 1 of" in line)
    assert told[title + 1].split() == ["sentence", "nod.yaml:5", "nod:", "bow"]
    assert told[title + 2].startswith("  and of the engine's own en.yaml 15 intents, ")
    assert "en.yaml:" not in "".join(told[title + 1 :])
    (folder.path / "test_it.py").write_text(
        "from intent_engine import IntentEngine\n\n"
        "def test_it():\n    assert IntentEngine.from_files('en').parse('turn left').actions\n",
        "utf-8",
    )
    told = folder.runpytest("test_it.py", "--intent-coverage").stdout.lines
    assert any(line.startswith("  intent") and "en.yaml:" in line for line in told)


def test_coverage_counts_a_users_own_tests(folder):
    folder.makepyfile(
        """
        from intent_engine import IntentEngine

        def test_nod():
            assert IntentEngine.from_files("wave.yaml").parse("nod, then wave at bob").actions
        """
    )
    result = folder.runpytest("--intent-coverage", "test_coverage_counts_a_users_own_tests.py")
    result.assert_outcomes(passed=1)
    result.stdout.fnmatch_lines(["wave.yaml: 2 of 3 intents, 2 of 4 sentences, 1 of 2 slots"])


def test_coverage_of_several_processes_is_what_none_of_them_missed(folder, monkeypatch):
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    options = ("--intent-coverage", "-n2", "--dist", "loadfile")
    (folder.path / "more.intents.yaml").write_text("grammar: wave.yaml\ntests: [nod]\n", "utf-8")
    result = folder.runpytest_subprocess("wave.intents.yaml", "more.intents.yaml", *options)
    result.stdout.fnmatch_lines(
        [
            "wave.yaml: 3 of 3 intents, 4 of 4 sentences, 2 of 2 slots",
        ]
    )
    result.stdout.no_fnmatch_line("*no grammar was used*")


def test_what_one_process_reached_is_no_longer_missed_by_another(folder):
    from intent_engine.testing.coverage import Coverage

    engine = IntentEngine.from_files(folder.path / "wave.yaml")
    apart = []
    for text in ("nod", "wave at bob"):
        coverage = Coverage()
        coverage.start()
        engine.parse(text)
        coverage.stop()
        apart.append(coverage)
    both, alone = Coverage(), Coverage()
    for coverage in apart:
        both.add(json.loads(json.dumps(coverage.told())))
    alone.start()
    for text in ("nod", "wave at bob"):
        engine.parse(text)
    alone.stop()
    assert list(both.lines()) == list(alone.lines())
    assert both.missed() == alone.missed()
    assert [len(next(iter(coverage.missed().values()))) for coverage in (*apart, both)] == [7, 6, 4]


def test_a_run_that_does_not_use_it_loads_nothing_of_the_engine(pytester):
    pytester.makepyfile("def test_nothing(): pass")
    (pytester.path / "values.yaml").write_text("intents: [of another program]\n", "utf-8")
    (pytester.path / "conftest.py").write_text(
        "import sys\n\ndef pytest_unconfigure(config):\n"
        "    names = [name for name in sys.modules if name.startswith('intent_engine')]\n"
        "    print('LOADED', sorted(names), 'yaml' in sys.modules, 'numpy' in sys.modules)\n",
        "utf-8",
    )
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-s", "-p", "no:cacheprovider", "-p", "no:hypothesispytest"],
        cwd=pytester.path,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    loaded = re.search(r"LOADED (\[.*?\]) (\w+) (\w+)", done.stdout)
    assert loaded
    assert eval(loaded[1]) == ["intent_engine", "intent_engine.testing", "intent_engine.testing.pytest_plugin"]
    assert loaded.groups()[1:] == ("False", "False")


def test_coverage_leaves_the_engine_as_it_was():
    from intent_engine.language.meaning import Interpreter
    from intent_engine.testing.coverage import Coverage

    before = dict(vars(Interpreter))
    coverage = Coverage()
    coverage.start()
    assert dict(vars(Interpreter)) != before
    coverage.stop()
    coverage.stop()
    assert dict(vars(Interpreter)) == before
