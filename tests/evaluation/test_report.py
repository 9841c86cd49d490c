"""Outcomes for people, spreadsheets and programs: what was expected stands beside what was done."""

from __future__ import annotations

import csv
from dataclasses import replace
from pathlib import Path

import pytest

from intent_engine.actions import Move, Turn
from intent_engine.errors import ConfigError
from intent_engine.evaluation.labels import Expected, Row, Step
from intent_engine.evaluation.report import (
    MISS_COLUMNS,
    expected_text,
    miss_cells,
    miss_table,
    outcome_json,
    write_csv,
)
from intent_engine.evaluation.scoring import Condition, Outcome, Verdict
from intent_engine.speech.recognizer import Transcript

MOVED = Move(0.5, 2.0, 4.0)
TURN = Turn(1.5708, 0.5, 3.1416)
MOVE_TEXT = "move linear_velocity=0.5 distance=2 duration=4"
STEP = Step("turn", {"side": "left", "angle": 1.5708})


def outcome(expected: Expected, *, text: str | None = None) -> Outcome:
    row = Row("one", 1, Path("a.wav"), expected, text)
    done = (Step("move", {"distance": 2.0}),)
    return Outcome(row, Condition("m"), Verdict.WRONG, "go", "go", ("move",), (MOVED,), steps=done)


@pytest.mark.parametrize(
    ("expected", "said", "done", "data"),
    [
        (
            Expected((STEP,)),
            "turn side=left angle=1.571",
            "move distance=2",
            {"steps": [{"intent": "turn", "slots": {"side": "left", "angle": 1.5708}}], "actions": None},
        ),
        (Expected(types=("move", "turn")), "move; turn", MOVE_TEXT, {"steps": [], "actions": ["move", "turn"]}),
        (
            Expected((STEP,), actions=(TURN,), by_text=True),
            "turn angle=1.571 angular_velocity=0.5 duration=3.142",
            MOVE_TEXT,
            {
                "steps": [{"intent": "turn", "slots": {"side": "left", "angle": 1.5708}}],
                "actions": [{"type": "turn", "angle": 1.5708, "angular_velocity": 0.5, "duration": 3.1416}],
            },
        ),
        (
            Expected((Step("turn"),), types=("turn",)),
            "turn and turn",
            MOVE_TEXT,
            {"steps": [{"intent": "turn", "slots": {}}], "actions": ["turn"]},
        ),
        (Expected(), "nothing", MOVE_TEXT, {"steps": [], "actions": []}),
        (Expected(actions=()), "nothing", MOVE_TEXT, {"steps": [], "actions": []}),
    ],
)
def test_what_was_expected_stands_beside_what_was_done(tmp_path, expected, said, done, data):
    one = outcome(expected)
    assert expected_text(expected) == said
    cells = dict(zip(MISS_COLUMNS, miss_cells(one), strict=True))
    assert (cells["expected"], cells["done"]) == (said, done)
    assert outcome_json(one)["expected"] == data
    write_csv(tmp_path / "all.csv", [one])
    with (tmp_path / "all.csv").open(newline="") as file:
        (row,) = csv.DictReader(file)
    assert (row["expected"], row["actions"]) == (said, MOVE_TEXT)


def test_what_went_wrong_names_the_model_where_there_are_several():
    one = outcome(Expected((STEP,)))
    other = replace(one, condition=Condition("n", 6.0))
    heads, rows, keys = miss_table([one], [one, one])
    assert (heads, [row[:keys] for row in rows]) == (list(MISS_COLUMNS), [["one", "none", "wrong"]])
    heads, rows, keys = miss_table([other], [one, other])
    assert heads[:keys] == ["recording", "model", "noise", "what came of it"]
    assert [row[:keys] for row in rows] == [["one", "n", "6 dB", "wrong"]]


def test_other_readings_stand_beside_what_was_heard(tmp_path):
    heard = (
        Transcript("go", alternatives=("stop", "go back"), behind=(0.5, 2.0)),
        Transcript("on", alternatives=("=off",)),
    )
    one = replace(outcome(Expected()), transcripts=heard)
    assert outcome_json(one)["alternatives"] == [
        {"text": "stop", "behind": 0.5},
        {"text": "go back", "behind": 2.0},
        {"text": "=off", "behind": None},
    ]
    write_csv(tmp_path / "all.csv", [one])
    with (tmp_path / "all.csv").open(newline="") as file:
        (row,) = csv.DictReader(file)
    assert row["alternatives"] == "stop; go back; =off"


@pytest.mark.parametrize("said", ["=1+1", "+1", "-1", "@a", "\t=1+1", " =1+1", "\r\n=1+1"])
def test_no_cell_is_run_as_a_formula(tmp_path, said):
    write_csv(tmp_path / "all.csv", [replace(outcome(Expected()), heard=said)])
    with (tmp_path / "all.csv").open(newline="") as file:
        (row,) = csv.DictReader(file)
    assert row["heard"] == f"'{said}"


def test_a_spreadsheet_that_cannot_be_written():
    with pytest.raises(ConfigError, match=r"/proc/x\.csv: cannot be written: "):
        write_csv(Path("/proc/x.csv"), [outcome(Expected())])
