"""Files that a verb writes: none is lost by it, and none is written where nobody looks."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import soundfile

from intent_engine.cli.outputs import check_apart, check_file
from intent_engine.errors import ConfigError


@pytest.fixture
def folder(tmp_path):
    soundfile.write(tmp_path / "a.wav", np.zeros(16_000), 16_000)
    (tmp_path / "labels.jsonl").write_text(json.dumps({"audio": "a.wav", "text": "stop"}), "utf-8")
    sentences = "language: en\nintents:\n  wave: {action: {type: custom}, sentences: [wave]}\n"
    (tmp_path / "my.yaml").write_text(sentences, "utf-8")
    (tmp_path / "map.yaml").write_text("locations:\n  kitchen: {x: 1, y: 2, yaw: 0}\n", "utf-8")
    (tmp_path / "robot.yaml").write_text("name: rover\n", "utf-8")
    return tmp_path


@pytest.mark.parametrize(
    "command",
    [
        "run a.wav --journal a.wav",
        "run a.wav --journal ./a.wav",
        "run a.wav -g my.yaml --journal my.yaml",
        "run a.wav -l map.yaml --journal map.yaml",
        "run a.wav -r robot.yaml --journal robot.yaml",
        "listen --pcm a.wav --drive a.wav",
        "evaluate . --csv labels.jsonl",
        "evaluate . --csv a.wav",
        "evaluate . -r robot.yaml --csv robot.yaml",
    ],
)
def test_what_is_read_is_not_written_over(in_process, root, folder, command):
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    done = in_process(*command.split(), cwd=folder, PYTHONPATH=str(root))
    *_, option, name = command.split()
    assert done.returncode == 2, done.stdout + done.stderr
    says = f"error: {option}: {Path(name)} is read by the same command, and would be lost\n    give another name\n"
    assert done.stderr == says
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


@pytest.mark.parametrize("command", ["run a.wav --journal -", "listen --pcm a.wav --drive -", "evaluate . --csv -"])
def test_a_stream_is_no_file_of_that_name(in_process, root, folder, command):
    done = in_process(*command.split(), cwd=folder, PYTHONPATH=str(root))
    assert done.returncode == 2, done.stdout + done.stderr
    assert f"{command.split()[-2]}: - is no file, and standard output is not written to\n    give the n" in done.stderr
    assert not (folder / "-").exists()


def test_one_file_for_two_options(tmp_path):
    with pytest.raises(ConfigError, match=r"--plot: .*all\.png is what --csv writes, and would be lost"):
        check_apart({"--csv": tmp_path / "all.png", "--plot": tmp_path / "all.png"}, [])


def test_what_is_no_file_may_be_read_and_written():
    check_apart({"--csv": Path("/dev/null"), "--plot": None}, [Path("/dev/null")])


def test_a_journal_that_cannot_be_written_is_told_before_a_model_is_loaded(in_process, tmp_path):
    done = in_process("run", "--model", "nope", "--journal", tmp_path, "examples/demo.flac")
    assert done.returncode == 2
    assert f"error: --journal: {tmp_path} is a folder\n    give the name of a file in it\n" in done.stderr


def test_a_link_to_a_file_that_is_not_there_yet_stays(tmp_path):
    (tmp_path / "today").mkdir()
    link, file = tmp_path / "out.csv", tmp_path / "today" / "out.csv"
    try:
        link.symlink_to(file)
    except OSError:
        pytest.skip("no links here")
    check_file(link, "--csv")
    assert link.is_symlink()
    assert not file.exists(), "nothing is written before the end"
