"""``intent-engine drill`` through the command line; the trials themselves are tested in execution/."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

import pytest
from typer.testing import CliRunner

from intent_engine.cli import app
from intent_engine.cli.guard import Terminated
from intent_engine.execution.drill import Trial


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="kills and freezes processes by signals")
def test_every_promise_has_a_verdict(intent_engine):
    done = intent_engine("drill", "--quick", "--json", "--robot", "turtlebot3", timeout=300)
    (line,) = done.stdout.splitlines()
    report = json.loads(line)
    assert report["robot"] == "turtlebot3"
    assert report["passed"] == all(trial["passed"] for trial in report["trials"])
    assert done.returncode == (0 if report["passed"] else 1)
    assert len(report["trials"]) >= 6
    assert done.stderr == ""


def computing(pid: str) -> bool:
    """It is not only starting any more: it has had 0.1 s of a processor."""
    user_ticks = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[11]
    return int(user_ticks) > 0.1 * os.sysconf("SC_CLK_TCK")


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="asks Linux for the children")
def test_ctrl_c_is_answered_by_one_message(root):
    """It reaches every process that the terminal runs."""
    command = [sys.executable, "-m", "intent_engine.cli", "drill", "--quick"]
    with subprocess.Popen(command, cwd=root, stderr=subprocess.PIPE, text=True, start_new_session=True) as process:
        children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
        assert process.stderr.readline().startswith("trying ")
        while process.poll() is None and not any(map(computing, children.read_text().split())):
            pass
        os.killpg(process.pid, signal.SIGINT)
        error = process.stderr.read()
    assert process.returncode == 130
    assert error == "error: interrupted\n"


def test_a_robot_file_that_is_not_there(intent_engine):
    done = intent_engine("drill", "--robot", "marvin")
    assert done.returncode == 2
    assert done.stderr.startswith("error: no file marvin.yaml in robots/\n    there is ")


@pytest.mark.parametrize(
    ("ending", "code", "word"), [(KeyboardInterrupt, 130, "interrupted"), (Terminated, 143, "terminated")]
)
@pytest.mark.parametrize("passed", [True, False])
def test_a_signal_ends_it_with_what_was_tried(monkeypatch, ending, code, word, passed):
    def ended(file: object, *, quick: bool, on_trial: Callable[[Trial], object]) -> NoReturn:
        on_trial(Trial("stop", "soon", 0.1, 0.01, 0.01, 5, passed=passed))
        raise ending

    monkeypatch.setattr("intent_engine.execution.drill.drill", ended)
    done = CliRunner().invoke(app, ["drill"])
    assert done.exit_code == code
    assert done.stdout.startswith("drill of simulated, not all of it ")
    assert "every promise was kept" not in done.stdout
    assert ("a promise was broken" in done.stdout) == (not passed)
    assert done.stderr.endswith(f"error: {word}\n")
    report = json.loads(CliRunner().invoke(app, ["drill", "--json"]).stdout)
    assert (report["complete"], report["passed"], len(report["trials"])) == (False, False, 1)
