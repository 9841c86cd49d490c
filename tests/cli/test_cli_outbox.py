"""What a session tells is read late, or never; what it does is done in time."""

from __future__ import annotations

import functools
import json
import os
import signal
import subprocess
import sys
import threading
import time

import pytest
import soundfile
from hypothesis import given
from hypothesis import strategies as st
from test_cli_listen import ROOT

from intent_engine.cli import outbox
from intent_engine.cli.outbox import Outbox
from intent_engine.cli.streams import OutputError

RATE = 16_000


@given(st.lists(st.integers()))
def test_all_is_written_in_its_turn(numbers):
    written: list[int] = []
    with Outbox() as out:
        for number in numbers:
            out.put(functools.partial(written.append, number))
    assert written == numbers


def test_who_tells_waits_for_no_reader(monkeypatch, capsys):
    monkeypatch.setattr(outbox, "MOST", 3)
    read, written = threading.Event(), []
    taken = threading.Event()
    with Outbox() as out:
        out.put(lambda: (taken.set(), read.wait(30)))
        taken.wait(30)
        for number in range(5):
            out.put(functools.partial(written.append, number))
        assert written == []
        assert out.unread == 2, "no more lines wait than there is room for"
        read.set()
    assert written == [0, 1, 2]
    assert "2 lines of what happened found no reader" in capsys.readouterr().err


@pytest.mark.parametrize("error", [BrokenPipeError(), OutputError("it is full")])
def test_where_nothing_can_be_written_listening_ends_and_whoever_tells_next_hears_of_it(error):
    ended = threading.Event()

    def write() -> None:
        raise error

    def tell() -> None:
        with Outbox(ended.set) as out:
            out.put(write)
            assert ended.wait(30)
            out.put(lambda: None)

    with pytest.raises(type(error)):
        tell()


def test_so_does_whoever_waits_for_the_end():
    def write() -> None:
        raise BrokenPipeError

    def tell() -> None:
        with Outbox() as out:
            out.put(write)

    with pytest.raises(BrokenPipeError):
        tell()


def test_a_fault_of_the_program_ends_it_as_well_and_nobody_waits_for_ever():
    """A number that JSON has no word for, say: the lines after it would be written by nobody."""
    ended = threading.Event()

    def tell() -> None:
        with Outbox(ended.set) as out:
            out.put(lambda: json.dumps(float("nan"), allow_nan=False))
            assert ended.wait(10)
            out.settle(10)

    with pytest.raises(ValueError, match="not JSON compliant"):
        tell()


@pytest.fixture(scope="module")
def commands() -> bytes:
    """Five seconds, in which a hurried robot is told to drive two meters; it stands again after three."""
    samples, rate = soundfile.read(
        ROOT / "examples" / "demo.flac", start=int(1.2 * RATE), frames=5 * RATE, dtype="float32"
    )
    samples[2 * RATE :] = 0
    assert rate == RATE
    return (samples * 32_767).astype("<i2").tobytes()


@pytest.mark.skipif(
    sys.platform != "linux", reason="only Linux lets a program set how much a pipe holds; CI is Linux, and runs it"
)
@pytest.mark.parametrize(
    "options", [pytest.param(["--json"], id="json"), pytest.param([], id="text", marks=pytest.mark.slow)]
)
def test_a_reader_that_stands_still_holds_up_no_command(commands, tmp_path, hurried, options):
    import fcntl

    lines = tmp_path / "commands.jsonl"
    reads, writes = os.pipe()
    fcntl.fcntl(writes, fcntl.F_SETPIPE_SZ, 4096)
    os.write(writes, bytes(4096))  # nobody has read it, and nobody will
    command = [sys.executable, "-m", "intent_engine.cli", "listen", "--pcm", "-", "--drive", str(lines), "--no-reflex"]
    command += ["--grammar", str(hurried)]
    with subprocess.Popen(
        [*command, *options], cwd=ROOT, stdin=subprocess.PIPE, stdout=writes, stderr=subprocess.PIPE
    ) as process:
        os.close(writes)
        process.stdin.write(commands)
        process.stdin.close()
        late = time.monotonic() + 60
        while True:  # until it has driven, and stands
            written = [json.loads(line) for line in lines.read_text().splitlines()] if lines.exists() else []
            speeds = [one["velocity"]["linear"] for one in written if "velocity" in one]
            if any(speeds) and not speeds[-1]:
                break
            assert process.poll() is None
            if time.monotonic() > late:
                process.kill()
                pytest.fail("it did not drive")
            threading.Event().wait(0.05)
        process.send_signal(signal.SIGINT)
        error = process.stderr.read().decode()
        assert process.wait(60) == 130, error
    os.close(reads)
    assert "the robot is stopped" in error
    assert "Fatal" not in error
    assert "Traceback" not in error
