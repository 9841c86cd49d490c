"""``intent-engine drill`` through the command line; the trials themselves are tested in execution/."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest


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
