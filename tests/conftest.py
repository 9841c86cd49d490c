"""What tests of every room may use."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import settings

# Before anything loads NumPy: its threads fight the recogniser's for the cores.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

# Tests in the background (`make test &`, nohup, some CI) inherit that Ctrl-C and a closed terminal are ignored,
# and so would the programs that are started here and then interrupted.
signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP"):
    signal.signal(signal.SIGHUP, signal.SIG_DFL)

# The same examples every time, so that a change that passes here passes everywhere. To look for new ones:
# HYPOTHESIS_PROFILE=explore python -m pytest
settings.register_profile("same", derandomize=True, deadline=None)
settings.register_profile("explore", deadline=None, max_examples=1000)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "same"))

ROOT = Path(__file__).resolve().parent.parent


@pytest.fixture(scope="session")
def root() -> Path:
    """The repository."""
    return ROOT


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
