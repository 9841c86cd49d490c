"""The drill finds what it is there to find."""

from __future__ import annotations

import json
import math
import signal
import subprocess
from pathlib import Path

import pytest

from intent_engine.execution.drill import DrillReport, Trial, busy
from intent_engine.execution.drill.report import result
from intent_engine.execution.drill.stops import flood, late_writes, robot_hangs, robot_raises, stop_under_load
from intent_engine.execution.executor import Executor
from intent_engine.execution.robots.robot_file import RobotFile

FILE = RobotFile("test", "")


def test_trials_in_one_process_pass_here():
    for trial in (
        flood(FILE, 100),
        robot_raises(FILE, 2),
        robot_hangs(FILE, 1),
        late_writes(FILE, 20),
    ):
        # Times are the machine's business; what must hold anywhere is that nothing else was found.
        assert trial.passed or "took" in trial.detail, trial


def test_an_executor_that_does_not_stop_is_found(monkeypatch):
    monkeypatch.setattr(Executor, "_stop", lambda self, *stop: None)
    trial = stop_under_load(FILE, 1)
    assert not trial.passed
    assert "the goal ended as executing" in trial.detail


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="asks Linux which signals a process hears")
def test_what_keeps_the_machine_busy_does_not_hear_ctrl_c(monkeypatch):
    """Whoever started it ends it; it would only print a traceback."""
    started: list[subprocess.Popen] = []
    popen = subprocess.Popen
    monkeypatch.setattr(subprocess, "Popen", lambda *args, **more: started.append(popen(*args, **more)) or started[-1])
    with busy(processes=1):
        status = Path(f"/proc/{started[0].pid}/status").read_text()
        (blocked,) = [line.split()[1] for line in status.splitlines() if line.startswith("SigBlk")]
        assert int(blocked, 16) >> (signal.SIGINT - 1) & 1
    assert started[0].returncode is not None
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, ())


def test_a_report_is_json_and_fails_with_one_of_its_trials():
    good = Trial("a", "b", 0.1, 0.05, 0.04, 3, True)
    bad = Trial("c", "d", 0.1, 0.2, 0.2, 3, False, "too slow")
    report = DrillReport("r", (good, bad), real_time=False)
    assert not report.passed
    assert json.loads(json.dumps(report.to_json()))["trials"][1]["detail"] == "too slow"
    assert DrillReport("r", (good,), real_time=True).passed
    assert not DrillReport("r", (good,), complete=False).passed, "what was not tried was not kept"


def test_a_zero_that_never_came_is_told_and_is_json():
    trial = result("a", "b", 0.1, [0.01, math.inf], [])
    assert not trial.passed
    assert "never" in trial.detail
    assert trial.runs == 2
    json.dumps(DrillReport("r", (trial,), real_time=True).to_json(), allow_nan=False)
