"""Keys while something else goes on, on a terminal of its own; and push-to-talk with them."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest
import soundfile

from intent_engine.cli import listening
from intent_engine.cli.keys import keys
from intent_engine.errors import ConfigError

pty = pytest.importorskip("pty", reason="terminals of Unix")
ROOT = Path(__file__).resolve().parent.parent.parent
RATE = 16_000


@pytest.fixture
def terminal(monkeypatch):
    """A terminal: what is written to the descriptor is typed."""
    typed, screen = pty.openpty()
    with os.fdopen(screen, "r+b", buffering=0) as file:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(file))
        yield typed
    os.close(typed)


def test_each_key_is_told_without_enter(terminal):
    import termios

    before = termios.tcgetattr(sys.stdin.fileno())
    pressed: list[str] = []
    enough = threading.Event()

    def on_key(key: str) -> None:
        pressed.append(key)
        if len(pressed) == 3:
            enough.set()

    with keys(on_key):
        os.write(terminal, " sü".encode())
        assert enough.wait(10)
    assert pressed == [" ", "s", "ü"]
    assert termios.tcgetattr(sys.stdin.fileno()) == before, "the terminal is as it was"


@pytest.mark.parametrize("typed", [[b"\x1bOQ", b"x"], [b"\x1b[A\x1b[1;5Qx"], [b"\x1b", b"OQ", b"x"], [b"\x1b", b"x"]])
def test_a_key_without_a_character_is_an_escape_and_none_of_the_letters_that_stand_for_it(terminal, typed):
    """F2 is sent as an escape, O and Q: it does not end the session as a q does."""
    pressed: list[str] = []
    told = threading.Event()

    def on_key(key: str) -> None:
        pressed.append(key)
        told.set()

    with keys(on_key):
        for part in typed:
            told.clear()
            os.write(terminal, part)
            if part[:1] in b"\x1bx":
                assert told.wait(10)
    assert pressed == ["\x1b"] * b"".join(typed).count(b"\x1b") + ["x"]


def test_the_terminal_is_as_it_was_after_an_error(terminal):
    import termios

    before = termios.tcgetattr(sys.stdin.fileno())
    with pytest.raises(ZeroDivisionError), keys(print):
        raise ZeroDivisionError
    assert termios.tcgetattr(sys.stdin.fileno()) == before


def still_open() -> int:
    """How many descriptors this process has open, where Linux tells."""
    return len(list(Path("/proc/self/fd").glob("*")))


def test_a_terminal_that_lets_nobody_set_it_is_none(terminal, monkeypatch):
    import termios
    import tty

    def refuse(descriptor: int) -> None:
        raise termios.error(5, "Input/output error")  # a job in the background whose shell is gone

    monkeypatch.setattr(tty, "setcbreak", refuse)
    before = still_open()
    with pytest.raises(ConfigError, match="needs a terminal"), keys(print):
        pass
    assert still_open() == before


def test_a_terminal_that_goes_away_is_told_once_and_ends_in_peace(monkeypatch):
    typed, screen = pty.openpty()
    told: list[bool] = []
    gone = threading.Event()

    def on_gone() -> None:
        told.append(True)
        gone.set()

    with os.fdopen(screen, "r+b", buffering=0) as file:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(file))
        with keys(print, on_gone):
            os.close(typed)
            assert gone.wait(10)
    assert told == [True]


def test_nobody_stays_at_a_robot_whose_keys_are_gone(monkeypatch):
    """While the key is up nothing is heard, and nobody could press it, nor the one that stops the robot."""
    typed, screen = pty.openpty()
    closed = threading.Event()

    class Listening:
        def push_to_talk(self) -> None: ...

        def close(self) -> None:
            closed.set()

    with os.fdopen(screen, "r+b", buffering=0) as file:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(file))
        with listening._controls("a microphone", True, None, Listening(), None):
            os.close(typed)
            assert closed.wait(10)


def test_without_a_terminal(monkeypatch):
    monkeypatch.setattr(sys, "stdin", io.StringIO())
    monkeypatch.setattr(os, "open", lambda *_: (_ for _ in ()).throw(OSError("no such device")))
    with pytest.raises(ConfigError, match=r"needs a terminal(.|\n)*Runtime\.talk"), keys(print):
        pass


def test_push_to_talk(tmp_path):
    """A whole process on a terminal: nothing is heard until the key is pressed, and q ends it."""
    samples, _ = soundfile.read(
        ROOT / "examples" / "demo.flac", start=int(1.2 * RATE), stop=int(3.6 * RATE), dtype="float32"
    )
    soundfile.write(tmp_path / "said.wav", np.concatenate((np.zeros(RATE * 3 // 5), samples)), RATE)
    typed, screen = pty.openpty()
    played = {"PYTHONPATH": str(ROOT / "tests" / "speech" / "played_microphone"), "PLAYED": str(tmp_path / "said.wav")}
    command = [sys.executable, "-u", "-m", "intent_engine.cli", "listen", "--push-to-talk", "--json", "--no-reflex"]
    with subprocess.Popen(
        command,
        cwd=ROOT,
        env={**os.environ, **played},
        stdin=screen,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        os.close(screen)
        assert process.stdout is not None
        assert process.stderr is not None
        assert "space: begin and end talking to microphone 'played'" in process.stderr.readline()
        os.write(typed, b" ")
        assert process.stderr.readline().strip() == "listening"
        states = []
        for line in process.stdout:
            event = json.loads(line)
            if event["event"] == "goal":
                states.append(event["state"])
            if event.get("state") == "executing":
                os.write(typed, b"s")
            if event.get("state") == "canceled":
                os.write(typed, b"q")
        error = process.stderr.read()
    os.close(typed)
    assert process.returncode == 0, error
    assert states[-1] == "canceled"
