"""The journal holds what happened, and never stands in the way."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from intent_engine.actions import Move, Pick
from intent_engine.errors import ConfigError
from intent_engine.execution import journal as journal_module
from intent_engine.execution.journal import Journal

FORWARD = Move(0.5, 1.0, 2.0)


def test_a_line_for_each_end_and_each_stop(stage, tmp_path):
    path = tmp_path / "deep" / "journal.jsonl"
    s = stage(journal=Journal(path), objects={})
    s.clock.advance(3.0)
    s.executor.wait(s.executor.submit(FORWARD, spoken_at=2.5, text="go forward"))
    s.executor.wait(s.executor.submit(Pick("cup")))
    s.executor.submit(FORWARD)
    s.clock.advance(1.0)
    s.executor.stop()
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    assert [(line["event"], line.get("state"), line.get("reason")) for line in lines] == [
        ("goal", "succeeded", ""),
        ("goal", "aborted", "robot_error"),
        ("goal", "canceled", "stop"),
        ("stop", None, "stop"),
    ]
    first = lines[0]
    assert first["text"] == "go forward"
    assert first["action"] == {"type": "move", "linear_velocity": 0.5, "distance": 1.0, "duration": 2.0}
    assert first["times"] == {"spoken": 2.5, "submitted": 3.0, "accepted": 3.0, "started": 3.0, "ended": 5.0}
    assert first["at"].endswith("Z")
    assert "there is no cup" in lines[1]["detail"]
    assert lines[2]["travelled"] == pytest.approx(0.5)


def test_it_is_rotated(stage, tmp_path):
    path = tmp_path / "journal.jsonl"
    with Journal(path, max_bytes=2000, backups=2) as journal:
        for number in range(100):
            journal.write({"event": "note", "number": number})
    assert sorted(file.name for file in tmp_path.iterdir()) == ["journal.jsonl", "journal.jsonl.1", "journal.jsonl.2"]
    assert all(file.stat().st_size <= 2000 for file in tmp_path.iterdir())
    assert json.loads(path.read_text().splitlines()[-1])["number"] == 99


def test_a_path_that_cannot_be_written_is_told(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(ConfigError, match="journal cannot be written"):
        Journal(tmp_path / "file" / "journal.jsonl")


def test_a_journal_that_breaks_does_not_stop_the_robot(stage, tmp_path, caplog):
    journal = Journal(tmp_path / "journal.jsonl", max_bytes=10, backups=1)
    s = stage(journal=journal)
    for file in tmp_path.iterdir():
        file.unlink()
    tmp_path.rmdir()
    for _ in range(2):
        (goal,) = s.executor.submit(FORWARD)
        s.executor.wait(goal)
        assert goal.succeeded
    assert caplog.text.count("driving goes on") == 1


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full here")
def test_a_full_disk_is_told_once_and_closing_is_quiet(stage, caplog):
    with Journal("/dev/full") as journal:
        s = stage(journal=journal)
        for _ in range(3):
            assert s.executor.submit(Move(0.5, 0.1, 0.2))[0].result().succeeded
    assert caplog.text.count("driving goes on") == 1


def test_the_time_of_a_line_is_one_moment(tmp_path, monkeypatch):
    """Not the second of one look at the clock and the milliseconds of the next."""
    monkeypatch.setattr(journal_module.time, "time_ns", lambda: 5_007_000_000)
    with Journal(tmp_path / "journal.jsonl") as journal:
        journal.write({"event": "note"})
    assert json.loads((tmp_path / "journal.jsonl").read_text())["at"] == "1970-01-01T00:00:05.007Z"
