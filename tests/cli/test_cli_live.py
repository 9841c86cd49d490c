"""``--live``: the way of the robot, drawn while it goes, on a real terminal."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
import soundfile

pty = pytest.importorskip("pty", reason="needs a pseudo terminal")


@pytest.fixture
def short(root: Path, tmp_path: Path) -> Path:
    """ "go forward two meters", 2 s."""
    samples, rate = soundfile.read(root / "examples" / "demo.flac", dtype="float32")
    soundfile.write(tmp_path / "short.wav", samples[int(1.2 * rate) : int(3.2 * rate)], rate)
    return tmp_path / "short.wav"


def on_a_terminal(command: list[str], *, cwd: Path, **env: str) -> tuple[int, str]:
    """The exit code of a program, and what it writes to both its streams on a terminal."""
    ours, theirs = pty.openpty()
    clean = {name: value for name, value in os.environ.items() if name != "NO_COLOR"}
    with subprocess.Popen(
        command, stdout=theirs, stderr=theirs, cwd=cwd, env={**clean, "TERM": "xterm-256color", **env}
    ) as running:
        os.close(theirs)
        shown = b""
        while True:
            try:
                some = os.read(ours, 65_536)
            except OSError:  # the other end was closed
                break
            if not some:
                break
            shown += some
    os.close(ours)
    return running.returncode, shown.decode("utf-8", "replace")


def test_the_way_is_drawn_again_while_the_robot_goes(root: Path, short: Path, hurried: Path) -> None:
    command = [sys.executable, "-m", "intent_engine.cli", "run", "--realtime", "--live", "--no-reflex"]
    command += ["--grammar", str(hurried), str(short)]
    code, text = on_a_terminal(command, cwd=root, OPENBLAS_NUM_THREADS="1", COLUMNS="100", LINES="40")
    assert code == 0
    assert text.count("o start") > 4
    assert "done" in text


def test_in_a_file_nothing_is_drawn(intent_engine, short: Path, hurried: Path) -> None:
    done = intent_engine("run", "--realtime", "--live", "--no-reflex", "--grammar", hurried, short)
    assert done.returncode == 0
    assert "o start" not in done.stdout


@pytest.mark.slow
def test_colours_that_are_forced_into_a_file_bring_nothing_that_moves(
    intent_engine, short: Path, hurried: Path
) -> None:
    options = ("--realtime", "--live", "--no-reflex", "--grammar", hurried)
    done = intent_engine("run", *options, short, FORCE_COLOR="1")
    assert done.returncode == 0
    assert "o start" not in done.stdout
    assert "\x1b[?25l" not in done.stdout, "the cursor stays"


BAR = """
from intent_engine.cli.terminal import progress, say
with progress("hearing", 2) as step:
    step()
say("done", "green")
"""
COLOUR = re.compile(r"\x1b\[(?:\d+;)*(?:3|4|9|10)\d")


@pytest.mark.parametrize(
    ("env", "bar", "colours"),
    [({}, True, True), ({"NO_COLOR": "1"}, True, False), ({"TERM": "dumb"}, False, False)],
    ids=["a terminal", "without colours", "one that cannot move its cursor"],
)
def test_bars_and_colours(root: Path, env: dict[str, str], bar: bool, colours: bool) -> None:
    _, shown = on_a_terminal([sys.executable, "-c", BAR], cwd=root, **env)
    assert ("1/2" in shown, COLOUR.search(shown) is not None) == (bar, colours)
    assert "done" in shown


def test_no_bar_where_standard_error_is_no_terminal(root: Path) -> None:
    env = {**os.environ, "FORCE_COLOR": "1", "TERM": "xterm-256color"}
    done = subprocess.run([sys.executable, "-c", BAR], cwd=root, env=env, capture_output=True, check=True)
    assert done.stderr == b""


def test_it_needs_time(in_process, short: Path) -> None:
    done = in_process("run", "--live", short)
    assert done.returncode == 2
    assert "--realtime" in done.stderr
