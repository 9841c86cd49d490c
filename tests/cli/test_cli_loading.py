"""A Ctrl-C while the command line is being loaded, before there is anything to stop."""

from __future__ import annotations

import os
import signal
import subprocess
import sys

import pytest

INTERRUPTED = "import os, signal\nos.kill(os.getpid(), signal.SIGINT)\nraise SystemExit(5)\n"
"""In the place of what is loaded first: somebody presses the keys meanwhile."""


@pytest.mark.parametrize(
    ("ignored", "code"),
    [(False, -signal.SIGINT), (True, 5)],  # behind an "&" nothing interrupts it
)
def test_an_interrupt_while_it_is_loaded_shows_no_traceback(tmp_path, root, ignored, code):
    (tmp_path / "typer.py").write_text(INTERRUPTED, "utf-8")
    begun = "import os, signal, sys; signal.signal(signal.SIGINT, signal.SIG_IGN); " if ignored else "import os, sys; "
    begun += "os.execv(sys.executable, [sys.executable, '-m', 'intent_engine', 'parse', 'stop'])"
    path = os.pathsep.join([str(tmp_path), str(root)])
    environment = {**os.environ, "PYTHONPATH": path}
    done = subprocess.run(
        [sys.executable, "-c", begun], env=environment, capture_output=True, text=True, timeout=60, check=False
    )
    assert (done.returncode, done.stderr) == (code, "")
