"""The drill finds what it is there to find."""

from __future__ import annotations

import json

from intent_engine.execution import drill as drill_module
from intent_engine.execution.drill import DrillReport, Trial
from intent_engine.execution.executor import Executor
from intent_engine.execution.robots.robot_file import RobotFile

FILE = RobotFile("test", "")


def test_trials_in_one_process_pass_here():
    for trial in (
        drill_module._flood(FILE, 100),
        drill_module._robot_raises(FILE, 2),
        drill_module._robot_hangs(FILE, 1),
        drill_module._late_writes(FILE, 20),
    ):
        # Times are the machine's business; what must hold anywhere is that nothing else was found.
        assert trial.passed or "took" in trial.detail, trial


def test_an_executor_that_does_not_stop_is_found(monkeypatch):
    monkeypatch.setattr(Executor, "_stop", lambda self, reason, kind: None)
    trial = drill_module._stop_under_load(FILE, 1)
    assert not trial.passed
    assert "the goal ended as executing" in trial.detail


def test_a_report_is_json_and_fails_with_one_of_its_trials():
    good = Trial("a", "b", 0.1, 0.05, 0.04, 3, True)
    bad = Trial("c", "d", 0.1, 0.2, 0.2, 3, False, "too slow")
    report = DrillReport("r", (good, bad), real_time=False)
    assert not report.passed
    assert json.loads(json.dumps(report.to_json()))["trials"][1]["detail"] == "too slow"
    assert DrillReport("r", (good,), real_time=True).passed
