"""``intent-engine drill`` through the command line; the trials themselves are tested in execution/."""

from __future__ import annotations

import json
import sys

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


def test_a_robot_file_that_is_not_there(intent_engine):
    done = intent_engine("drill", "--robot", "marvin")
    assert done.returncode == 2
    assert done.stderr.startswith("error: no file marvin.yaml in robots/\n    there is ")
