"""What tests of every room may use."""

from __future__ import annotations

import contextlib
import gc
import logging
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from functools import lru_cache
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

import numpy as np
import pytest
from hypothesis import settings

if TYPE_CHECKING:
    from intent_engine import IntentEngine

# Before anything loads NumPy: its threads fight the recogniser's for the cores.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

# Tests in the background (`make test &`, nohup, some CI) inherit that Ctrl-C and a closed terminal are ignored,
# and so would the programs that are started here and then interrupted.
signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP"):
    signal.signal(signal.SIGHUP, signal.SIG_DFL)

# Programs are started here hundreds of times, and each would compile the whole package anew where the environment says
# that nothing compiled is kept, as in many containers.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False

# The same examples every time, so that a change that passes here passes everywhere. To look for new ones:
# HYPOTHESIS_PROFILE=explore python -m pytest
settings.register_profile("same", derandomize=True, deadline=None)
settings.register_profile("explore", deadline=None, max_examples=1000)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "same"))

ROOT = Path(__file__).resolve().parent.parent

SELDOM = 10_000
"""Objects made before Python looks for cycles among them; engines are many that stay, and to look takes as long."""


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Iterator[None]:
    """All that is collected stays until the end: no search for cycles goes through it, neither now nor later."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(SELDOM)
        gc.enable()


@pytest.fixture(scope="session")
def root() -> Path:
    """The repository."""
    return ROOT


@pytest.fixture(scope="session")
def engine() -> IntentEngine:
    """The shipped English grammar with the shipped home. Tests of another grammar have an engine of their own."""
    from meanings import shipped

    return shipped()


@pytest.fixture(scope="session")
def engine_of(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., IntentEngine]:
    """The engine of a grammar that a test has written down; options as those of ``from_files``. Rows of one table that
    write down the same grammar share its engine, which no parse changes."""

    def made(grammar: str, **options: Any) -> IntentEngine:
        from intent_engine import IntentEngine

        file = tmp_path_factory.mktemp("grammar") / "own.yaml"
        file.write_text(grammar, "utf-8")
        return IntentEngine.from_files(file, **options)

    shared = lru_cache(maxsize=8)(made)
    return lambda grammar, **options: made(grammar, **options) if options else shared(grammar)


@pytest.fixture
def intent_engine(tmp_path: Path) -> Callable[..., subprocess.CompletedProcess[str]]:
    """Run the real command line in a process of its own, in the repository unless told otherwise."""

    def run(
        *args: object, stdin: bytes = b"", cwd: Path = ROOT, timeout: float = 120, **env: str
    ) -> subprocess.CompletedProcess[str]:
        done = subprocess.run(
            [sys.executable, "-m", "intent_engine.cli", *map(str, args)],
            input=stdin,
            capture_output=True,
            cwd=cwd,
            timeout=timeout,
            env={**os.environ, "OPENBLAS_NUM_THREADS": "1", **env},
            check=False,
        )
        return subprocess.CompletedProcess(
            done.args, done.returncode, done.stdout.decode("utf-8", "replace"), done.stderr.decode("utf-8", "replace")
        )

    return run


@pytest.fixture
def in_process(monkeypatch: pytest.MonkeyPatch) -> Callable[..., subprocess.CompletedProcess[str]]:
    """The same command line within this process, many times as quick: for what it says, where neither its start and end
    nor its streams are what is tested. It reads nothing. Raises what would have been a traceback."""

    def run(*args: object, cwd: Path = ROOT, **env: str) -> subprocess.CompletedProcess[str]:
        from typer.testing import CliRunner

        from intent_engine.cli import app

        monkeypatch.chdir(cwd)
        log = logging.getLogger("intent_engine")
        handlers = [*log.handlers]
        try:
            done = CliRunner().invoke(app, [*map(str, args)], env=env)
        finally:
            log.handlers[:] = handlers
        if done.exception is not None and not isinstance(done.exception, SystemExit):
            raise done.exception
        return subprocess.CompletedProcess([*map(str, args)], done.exit_code, done.stdout, done.stderr)

    return run


@pytest.fixture(scope="session")
def hurried(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A grammar of a robot that has driven two meters in a second: for tests that must wait until it has."""
    file = tmp_path_factory.mktemp("grammar") / "hurried.yaml"
    file.write_text(
        "language: en\nslots: {distance: {type: distance}}\nintents:\n"
        "  go: {action: {type: move, direction: forward, speed: 2}, sentences: ['go forward {distance}']}\n"
    )
    return file


QUIET = 0.6
"""s before something is said into a pipe; what begins within half a second may be the rest of something else."""


@pytest.fixture(scope="session")
def speak() -> Callable[[IO[bytes], np.ndarray], None]:
    """Write sound at 16 kHz into a pipe while it is heard at its other end, after a moment of quiet: what comes at once
    was not said there and then."""

    def write(pipe: IO[bytes], samples: np.ndarray) -> None:
        sound = np.concatenate((np.zeros(int(QUIET * 16_000)), samples))
        try:
            for start in range(0, sound.size, 1_600):
                pipe.write((sound[start : start + 1_600] * 32_767).astype("<i2").tobytes())
                pipe.flush()
                time.sleep(0.1)
        except BrokenPipeError:  # whoever listened has ended; what it did not take would be written once more
            with contextlib.suppress(BrokenPipeError):
                pipe.close()

    return write


@pytest.fixture
def spoken_to(speak: Callable[[IO[bytes], np.ndarray], None]) -> Callable[..., subprocess.CompletedProcess[str]]:
    """Run ``listen --pcm -`` in a process of its own, and say something once it listens."""

    def run(samples: np.ndarray, *args: object, before: np.ndarray | None = None) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "intent_engine.cli", "listen", "--pcm", "-", *map(str, args)]
        pipes = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
        with subprocess.Popen(command, cwd=ROOT, **pipes) as process:
            try:
                early = np.zeros(1_600) if before is None else before
                process.stdin.write((early * 32_767).astype("<i2").tobytes())
                process.stdin.flush()
                told = process.stderr.readline()
                if b"listening to" in told:
                    speak(process.stdin, samples)
                if process.stdin.closed:
                    process.stdin = None  # communicate() would flush it
                out, error = process.communicate(timeout=120)
            finally:
                process.kill()
        told += error
        return subprocess.CompletedProcess(
            command, process.returncode, out.decode("utf-8", "replace"), told.decode("utf-8", "replace")
        )

    return run
