"""The frame of the command line: help, version, colours, faults of our own."""

from __future__ import annotations

import io
import json
import os
import re
import subprocess
import sys
from importlib.metadata import version

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console
from rich.text import Text
from typer.main import get_command
from typer.testing import CliRunner

from intent_engine.cli import app, guard
from intent_engine.errors import ConfigError

VERBS = sorted(get_command(app).commands)  # type: ignore[attr-defined]


def test_version(intent_engine):
    done = intent_engine("--version")
    assert (done.returncode, done.stdout) == (0, f"intent-engine {version('intent-engine')}\n")


def test_a_terminal_without_a_width_shows_the_help(intent_engine):
    assert "Usage:" in intent_engine("parse", "--help", COLUMNS="0").stdout


def test_python_runs_the_package_as_the_same_program():
    done = subprocess.run([sys.executable, "-m", "intent_engine", "--version"], capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, f"intent-engine {version('intent-engine')}\n")


def test_without_a_verb_it_shows_the_help(intent_engine):
    done = intent_engine(COLUMNS="120")
    assert all(verb in done.stdout for verb in VERBS)
    assert "Exit codes" in done.stdout


@pytest.mark.parametrize("verb", VERBS)
def test_every_verb_has_help_with_examples_that_name_its_options(verb):
    result = CliRunner().invoke(app, [verb, "--help"], env={"COLUMNS": "200", "NO_COLOR": "1", "TERM": "dumb"})
    assert result.exit_code == 0
    assert "Examples" in result.output
    examples = [line for line in result.output.splitlines() if re.match(r"\s*intent-engine ", line)]
    assert len(examples) >= 2
    options = set(re.findall(r"(--[a-z][a-z-]+)", result.output))
    for example in examples:
        command, *_ = example.split("|")
        assert f"intent-engine {verb}" in command
        assert set(re.findall(r"(--[a-z][a-z-]+)", command)) <= options


def test_the_help_names_the_languages_whose_grammars_there_are():
    from intent_engine.cli.options import Language
    from intent_engine.resources import names

    (option,) = Language.__metadata__
    assert f": {' or '.join(sorted(names('grammars'), reverse=True))}, whose grammar is taken;" in option.help


def test_an_option_is_written_alike_with_every_verb():
    written: dict[str, set[str]] = {}
    for verb in VERBS:
        for option in get_command(app).commands[verb].params:  # type: ignore[attr-defined]
            if option.param_type_name == "option":
                written.setdefault(max(option.opts, key=len), set()).add(min(option.opts, key=len))
    assert {name: short for name, short in written.items() if len(short) > 1} == {}
    shorts = [short for (short,) in written.values() if not short.startswith("--")]
    assert len(set(shorts)) == len(shorts)


@pytest.mark.parametrize("verb", sorted({*VERBS} - {"drill", "doctor"}))
def test_every_verb_that_needs_a_grammar_takes_it_with_g(verb):
    options = [option.opts for option in get_command(app).commands[verb].params]  # type: ignore[attr-defined]
    assert ["--grammar", "-g"] in options


def test_grammars_to_test_may_be_named_both_ways(intent_engine):
    both = intent_engine("test", "en", "-g", "de", "-l", "home", "-l", "zuhause", "--json")
    assert both.returncode == 0, both.stderr
    assert {json.loads(line)["file"].split("/")[-1] for line in both.stdout.splitlines()} == {"en.yaml", "de.yaml"}


def test_colours_are_for_terminals_that_want_them(monkeypatch, capsys):
    from intent_engine.cli import terminal

    monkeypatch.setenv("FORCE_COLOR", "1")  # rich takes this for a terminal
    monkeypatch.setenv("TERM", "xterm-256color")
    terminal.say("done", "green")
    assert capsys.readouterr().out == "\x1b[32mdone\x1b[0m\n"
    monkeypatch.setenv("NO_COLOR", "1")
    terminal.say("done", "green")
    assert "\x1b[32m" not in capsys.readouterr().out


def test_what_people_said_is_never_markup(capsys):
    from intent_engine.cli import terminal

    terminal.say("[bold]go[/bold] [/nonsense]")
    assert capsys.readouterr().out == "[bold]go[/bold] [/nonsense]\n"


@given(st.text() | st.text(st.characters(codec="utf-8"), max_size=200).map(lambda text: f" {text} \n {text}"))
def test_a_pipe_gets_what_rich_would_write(text):
    """The quick way past Rich, for what is no terminal."""
    from intent_engine.cli import terminal

    quick, rich = io.StringIO(), io.StringIO()
    if terminal._plainly(quick, text):
        Console(file=rich, highlight=False, soft_wrap=True).print(Text(text, style="dim"))
        assert quick.getvalue() == rich.getvalue()


def test_rich_is_asked_where_somebody_wants_colours(monkeypatch):
    from intent_engine.cli import terminal

    assert terminal._plainly(io.StringIO(), "done")
    monkeypatch.setenv("FORCE_COLOR", "1")
    assert not terminal._plainly(io.StringIO(), "done")


@pytest.fixture
def faulty(monkeypatch):
    """A fault of ours, deep inside a verb."""

    def broken(*_: object) -> None:
        raise ZeroDivisionError("one over nothing")

    monkeypatch.setattr("intent_engine.cli.parse.load_engine", broken)
    monkeypatch.setattr(sys, "argv", ["intent-engine", "parse", "go to the kitchen"])
    monkeypatch.delenv(guard.DEBUG, raising=False)
    yield
    os.environ.pop(guard.DEBUG, None)


@pytest.mark.usefixtures("faulty")
def test_a_fault_of_ours_is_told_without_a_traceback():
    result = CliRunner().invoke(app, ["parse", "go to the kitchen"])
    assert result.exit_code == 70
    assert result.stdout == ""
    assert result.stderr.startswith("error: intent-engine failed in a way it should not: ZeroDivisionError: one over")
    assert "Traceback" not in result.stderr
    assert "intent-engine --debug parse 'go to the kitchen'" in result.stderr


@pytest.mark.usefixtures("faulty")
def test_debug_shows_where():
    result = CliRunner().invoke(app, ["--debug", "parse", "go to the kitchen"])
    assert result.exit_code == 70
    assert "Traceback" in result.stderr


@pytest.mark.parametrize(("ending", "code"), [(KeyboardInterrupt, 130), (guard.Terminated, 143)])
def test_of_a_robot_only_a_verb_that_has_one_speaks(monkeypatch, ending, code):
    def ended(*_: object, **__: object) -> None:
        raise ending

    monkeypatch.setattr("intent_engine.cli.parse.load_engine", ended)
    monkeypatch.setattr("intent_engine.cli.listening.session", ended)
    for arguments, told in ((["parse", "stop"], False), (["listen"], True), (["run", "examples/demo.flac"], True)):
        result = CliRunner().invoke(app, arguments)
        assert (result.exit_code, "the robot is stopped" in result.stderr) == (code, told)


@pytest.mark.parametrize(("ending", "code"), [(KeyboardInterrupt, 130), (guard.Terminated, 143)])
@pytest.mark.parametrize("missing", [False, True], ids=["a library", "a package that counts as missing"])
def test_an_interruption_that_became_another_error_is_told_as_what_it_was(monkeypatch, ending, code, missing):
    def loaded(*_: object, **__: object) -> None:
        try:
            try:
                raise ending
            except BaseException as interrupted:  # as libraries in C do
                raise ImportError("initialization failed") from interrupted
        except ImportError:
            if missing:
                raise ConfigError("a package is not installed") from None
            raise

    monkeypatch.setattr("intent_engine.cli.parse.load_engine", loaded)
    result = CliRunner().invoke(app, ["parse", "stop"])
    assert result.exit_code == code
    assert result.stderr in ("error: interrupted\n", "error: terminated\n")


def test_a_fault_in_what_is_done_after_an_interruption_is_told(monkeypatch):
    def ended(*_: object, **__: object) -> None:
        try:
            raise KeyboardInterrupt
        finally:
            raise ZeroDivisionError("one over nothing")

    monkeypatch.setattr("intent_engine.cli.parse.load_engine", ended)
    result = CliRunner().invoke(app, ["parse", "stop"])
    assert result.exit_code == 70
    assert "ZeroDivisionError" in result.stderr


DESTROYED = """
import signal, sys, threading, time
from intent_engine.cli.guard import robot_verb

class Held:
    def __del__(self):
        signal.raise_signal(signal.{signal})
        for _ in range(1000):  # Python looks for signals between instructions: here, where it drops what is raised.
            pass

class Again(threading.Timer):
    # While it is started, which takes a while on a busy machine, another signal comes.
    def start(self):
        super().start()
        {meanwhile}
        for _ in range(1000):
            pass

threading.Timer = Again

@robot_verb
def drive():
    held = Held()
    del held
    if sys.platform == "win32":  # where no signal ends a wait: it is seen between two
        for _ in range(1200):
            time.sleep(0.05)
    else:
        threading.Event().wait(60)
    print("drove on")

try:
    drive()
except BaseException as end:
    raise SystemExit(end.exit_code)
"""


@pytest.mark.parametrize("number", ["SIGINT", "SIGTERM"])
@pytest.mark.parametrize("meanwhile", ["", "SIGINT", "SIGTERM"])
def test_a_signal_in_a_destructor_is_not_lost(number, meanwhile):
    codes = {"SIGINT": 130, "SIGTERM": 143}
    again = f"signal.raise_signal(signal.{meanwhile})" if meanwhile else "pass"
    done = subprocess.run(
        [sys.executable, "-c", DESTROYED.format(signal=number, meanwhile=again)],
        capture_output=True,
        text=True,
        timeout=100,
        check=False,
    )
    # Of two signals that come one right after the other either may be the one that is told, on a busy machine.
    assert done.returncode in {codes[one] for one in (number, meanwhile) if one}, done.stderr
    assert done.stdout == ""
    assert done.stderr.endswith("the robot is stopped\n")
    assert "Traceback" not in done.stderr


LOADED = """
import threading
from intent_engine.cli.guard import robot_verb

@robot_verb
def drive():
    import careless
    threading.Event().wait(30)
    print("drove on")

try:
    drive()
except BaseException as end:
    raise SystemExit(end.exit_code)
"""


@pytest.mark.parametrize(("number", "code"), [("SIGINT", 130), ("SIGTERM", 143)])
def test_a_signal_while_a_library_is_loaded_is_not_lost(tmp_path, number, code):
    """One that does without what it cannot load."""
    (tmp_path / "careless.py").write_text(
        f"import signal\ntry:\n    signal.raise_signal(signal.{number})\nexcept BaseException:\n    pass\n"
    )
    path = os.pathsep.join((str(tmp_path), *sys.path))
    done = subprocess.run(
        [sys.executable, "-c", LOADED],
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        timeout=100,
        check=False,
    )
    assert (done.returncode, done.stdout) == (code, ""), done.stderr
    assert done.stderr.endswith("the robot is stopped\n")


def test_numbers_stand_to_the_right(capsys):
    from intent_engine.cli import terminal

    terminal.table("Figures", ("what", "time"), [("one", "1.0 ms"), ("two", "10.0 ms")])
    lines = [line.rstrip() for line in capsys.readouterr().out.splitlines()]
    one, two = (next(line for line in lines if line.lstrip().startswith(name)) for name in ("one", "two"))
    assert len(one) == len(two)


WIDE = ("model", "noise", *(f"column number {number}" for number in range(9)))


def test_a_table_wider_than_its_terminal_is_cut_into_several(monkeypatch, capsys):
    from intent_engine.cli import terminal

    rows = [(f"model {row}", "none", *(f"{row}.{column}" for column in range(9))) for row in range(3)]
    monkeypatch.setenv("COLUMNS", "300")
    terminal.table("", WIDE, rows, keys=2)
    assert len(capsys.readouterr().out.splitlines()) == 2 + 3
    monkeypatch.setenv("COLUMNS", "80")
    terminal.table("", WIDE, rows, keys=2)
    shown = [line.rstrip() for line in capsys.readouterr().out.splitlines()]
    assert max(map(len, shown)) <= 80
    assert sum(line.startswith("model     noise   column") for line in shown) == 3
    words = " ".join(shown)
    assert all(words.count(name) == 1 for name in WIDE[2:])
    assert all(words.count(cell) == 1 for row in rows for cell in row[2:])


@pytest.mark.parametrize("columns", ["", "0", "wide"])
def test_a_table_in_a_file_has_a_width_of_its_own(monkeypatch, capsys, columns):
    from intent_engine.cli import terminal

    monkeypatch.setenv("COLUMNS", columns)
    terminal.table("", WIDE, [WIDE], keys=2)
    assert 80 < max(map(len, capsys.readouterr().out.splitlines())) <= terminal.PIPE_WIDTH
