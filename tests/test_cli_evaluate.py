"""``intent-engine evaluate`` with the real recogniser, on the ten commands of the demo."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest
import soundfile

from intent_engine.speech.models import installed_second

TEN = Path("examples") / "ten_commands"


def test_ten_commands_for_a_program(intent_engine):
    done = intent_engine("evaluate", TEN, "--json", "--at-least", "80")
    assert done.returncode == 0, done.stderr
    *heard, found = (json.loads(line) for line in done.stdout.splitlines())
    assert [one["event"] for one in heard] == ["recording"] * 10
    assert {one["verdict"] for one in heard} <= {"right", "wrong", "missed", "quiet", "false accept"}
    assert found["event"] == "score"
    assert (found["commands"], found["others"]) == (9, 1)
    assert (found["right"], found["wrong"], found["false_accepts"]) == (9, 0, 0)
    assert found["accuracy"] == 1.0
    assert 0.5 < found["accuracy_low"] < 1.0
    assert 0 < found["latency_p50"] <= found["latency_p90"] <= found["latency_max"]
    assert found["word_error_rate"] < 0.3
    assert done.stderr == ""


@pytest.mark.slow
def test_models_and_noise_in_a_table_a_spreadsheet_and_a_picture(intent_engine, tmp_path):
    noise = np.random.default_rng(1).normal(0, 0.1, 32_000)
    soundfile.write(tmp_path / "noise.flac", noise, 16_000)
    done = intent_engine(
        *("evaluate", TEN, "--limit", 2, "--free", "--noise", tmp_path / "noise.flac", "--snr", "-30,20"),
        *("--csv", tmp_path / "new" / "out.csv", "--plot", tmp_path / "out.png", "--at-least", "90"),
    )
    assert done.returncode == 1, "nobody understands speech at -30 dB"
    lines = [line.split() for line in done.stdout.splitlines()[2:8]]
    assert [line[0] for line in lines] == [f"tiny.en+{installed_second()}"] * 3 + ["tiny.en"] * 3
    assert [line[1] for line in lines] == ["none", "20", "-30", "free", "free", "free"]
    assert "what did not go right" in done.stdout
    assert (tmp_path / "out.png").read_bytes().startswith(b"\x89PNG")
    with (tmp_path / "new" / "out.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 2 * 2 * 3
    assert {row["snr"] for row in rows} == {"", "20.0", "-30.0"}
    assert {row["verdict"] for row in rows if row["snr"] == ""} == {"right"}
    assert "move linear_velocity=0.5 distance=2 duration=4" in {row["actions"] for row in rows}


def test_a_model_alone(intent_engine):
    done = intent_engine("evaluate", TEN, "--limit", 1, "--second-model", "none", "--json")
    assert done.returncode == 0, done.stderr
    assert {json.loads(line)["model"] for line in done.stdout.splitlines()} == {"tiny.en"}


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        (["nowhere"], 2, "nowhere: no such folder"),
        (["examples"], 2, "examples: the folder has no labels.jsonl\n    give the file itself"),
        (["examples/demo.jsonl"], 2, "examples/demo.jsonl:1: 'audio' is missing"),
        ([TEN, "--snr", "6"], 2, "--snr without --noise"),
        ([TEN, "--noise", "examples/demo.flac", "--snr", "6;12"], 2, "--snr: '6;12' is no signal-to-noise ratio"),
        ([TEN, "--noise", "nothing.wav"], 3, "nothing.wav: no such file"),
        ([TEN, "--model", "enormous.xy", "--limit", "1"], 5, "enormous.xy"),
        ([TEN, "--second-model", "/no/such/folder", "--limit", "1"], 5, "no model folder at /no/such/folder"),
        ([TEN, "--limit", "0"], 2, "--limit"),
        ([TEN, "--csv", "."], 2, "--csv: . is a folder\n    give the name of a file"),
        ([TEN, "--csv", "/dev/full"], 2, "--csv: /dev/full cannot be written: No space left on device"),
        ([TEN, "--csv", "README.md/out.csv"], 2, "--csv: README.md/out.csv cannot be written: "),
        (
            [TEN, "--plot", "x.bmpp"],
            2,
            "--plot: x.bmpp cannot be drawn: '.bmpp' is no kind of picture\n    end its name",
        ),
        ([TEN, "--plot", "x"], 2, "--plot: x cannot be drawn: the name has no ending"),
        (
            [TEN, "--plot", "/proc/x.png"],
            2,
            "/proc/x.png cannot be written: No such file or directory\n    give a file",
        ),
    ],
)
def test_mistakes(intent_engine, arguments, code, said):
    done = intent_engine("evaluate", *arguments)
    assert done.returncode == code, done.stderr
    assert said in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""


def test_a_file_of_before_is_kept_until_there_is_another(intent_engine, tmp_path):
    (tmp_path / "out.csv").write_text("before")
    done = intent_engine("evaluate", "nowhere", "--csv", tmp_path / "out.csv", "--plot", tmp_path / "out.png")
    assert done.returncode == 2
    assert [path.name for path in tmp_path.iterdir()] == ["out.csv"]
    assert (tmp_path / "out.csv").read_text() == "before"


def test_a_sound_file_that_is_cut_off_is_told_with_its_line(intent_engine, tmp_path):
    soundfile.write(tmp_path / "good.wav", np.zeros(16_000), 16_000)
    whole = (tmp_path / "good.wav").read_bytes()
    (tmp_path / "cut.wav").write_bytes(whole[: len(whole) // 2])
    labels = [{"audio": name, "text": "stop"} for name in ("good.wav", "cut.wav")]
    (tmp_path / "labels.jsonl").write_text("\n".join(map(json.dumps, labels)))
    done = intent_engine("evaluate", tmp_path)
    assert done.returncode == 3
    assert f"{tmp_path / 'labels.jsonl'}:2: {tmp_path / 'cut.wav'}: is cut off" in done.stderr


def test_two_models_in_folders_of_one_name_are_told_apart():
    from intent_engine.cli.evaluate import _names

    assert _names(["tiny.en", "a/whisper", "b/whisper", "tiny.en"]) == {
        "tiny.en": "tiny.en",
        "a/whisper": "a/whisper",
        "b/whisper": "b/whisper",
    }
    assert _names(["models/mine"]) == {"models/mine": "mine"}
