"""``--live``: the way of the robot, drawn while it goes, on a real terminal."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
import soundfile

pty = pytest.importorskip("pty", reason="needs a pseudo terminal")


@pytest.fixture
def short(root: Path, tmp_path: Path) -> Path:
    """ "go forward two meters", 5 s."""
    samples, rate = soundfile.read(root / "examples" / "demo.flac", dtype="float32")
    soundfile.write(tmp_path / "short.wav", samples[: 5 * rate], rate)
    return tmp_path / "short.wav"


def test_the_way_is_drawn_again_while_the_robot_goes(root: Path, short: Path) -> None:
    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "intent_engine.cli", "run", "--realtime", "--live", "--no-reflex", str(short)]
    env = {**os.environ, "TERM": "xterm", "OPENBLAS_NUM_THREADS": "1", "COLUMNS": "100", "LINES": "40"}
    with subprocess.Popen(command, stdout=theirs, stderr=subprocess.DEVNULL, cwd=root, env=env) as running:
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
    text = shown.decode("utf-8", "replace")
    assert running.returncode == 0
    assert text.count("o start") > 4
    assert "done" in text


def test_in_a_file_nothing_is_drawn(intent_engine, short: Path) -> None:
    done = intent_engine("run", "--realtime", "--live", "--no-reflex", short)
    assert done.returncode == 0
    assert "o start" not in done.stdout


def test_it_needs_time(intent_engine, short: Path) -> None:
    done = intent_engine("run", "--live", short)
    assert done.returncode == 2
    assert "--realtime" in done.stderr
