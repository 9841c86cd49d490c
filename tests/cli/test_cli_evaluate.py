"""``intent-engine evaluate`` with the real recogniser, on the ten commands of the demo."""

from __future__ import annotations

import csv
import json
import re
import signal
import subprocess
import sys
import weakref
from collections.abc import Callable
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest
import soundfile
from typer.testing import CliRunner, Result

from intent_engine.cli import app
from intent_engine.cli.evaluate import _share
from intent_engine.errors import AudioError
from intent_engine.evaluation.hearing import Hearing
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
        ([TEN, "--at-least", "nan"], 2, "--at-least: nan is no share\n    give a number from 0 to 100"),
        ([TEN, "--at-least", "0.8"], 2, "--at-least 0.8 is 0.8 % of the commands\n    for 80 %: --at-least 80"),
        ([TEN, "--no-clean"], 2, "--no-clean without --noise leaves nothing to hear\n    name a recording"),
        ([TEN, "--noise", "examples/demo.flac", "--snr", "6;12"], 2, "--snr: '6;12' is no signal-to-noise ratio"),
        ([TEN, "--noise", "nothing.wav"], 3, "nothing.wav: no such file"),
        ([TEN, "--model", "enormous.xy", "--limit", "1"], 5, "enormous.xy"),
        ([TEN, "--second-model", "/no/such/folder", "--limit", "1"], 5, "no model folder at /no/such/folder"),
        ([TEN, "--state", "flying"], 2, "flying"),
        ([TEN, "--limit", "0"], 2, "--limit"),
        ([TEN, "--csv", "."], 2, "--csv: . is a folder\n    give the name of a file"),
        ([TEN, "--csv", "/dev/full"], 2, "--csv: /dev/full cannot be written: No space left on device"),
        ([TEN, "--csv", "README.md/out.csv"], 2, "--csv: README.md/out.csv cannot be written: "),
        (
            [TEN, "--csv", "out/all.XLSX"],
            2,
            "all.XLSX is the name of a workbook, and CSV is written\n    any spreadsheet opens that: --csv out/all.csv",
        ),
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
def test_mistakes(in_process, arguments, code, said):
    done = in_process("evaluate", *arguments)
    assert done.returncode == code, done.stderr
    assert said in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""


def test_a_file_of_before_is_kept_until_there_is_another(in_process, tmp_path):
    (tmp_path / "out.csv").write_text("before")
    done = in_process("evaluate", "nowhere", "--csv", tmp_path / "out.csv", "--plot", tmp_path / "out.png")
    assert done.returncode == 2
    assert [path.name for path in tmp_path.iterdir()] == ["out.csv"]
    assert (tmp_path / "out.csv").read_text() == "before"


def test_a_sound_file_that_is_cut_off_is_told_with_its_line(in_process, tmp_path):
    soundfile.write(tmp_path / "good.wav", np.zeros(16_000), 16_000)
    whole = (tmp_path / "good.wav").read_bytes()
    (tmp_path / "cut.wav").write_bytes(whole[: len(whole) // 2])
    labels = [{"audio": name, "text": "stop"} for name in ("good.wav", "cut.wav")]
    (tmp_path / "labels.jsonl").write_text("\n".join(map(json.dumps, labels)))
    done = in_process("evaluate", tmp_path)
    assert done.returncode == 3
    assert f"{tmp_path / 'labels.jsonl'}:2: {tmp_path / 'cut.wav'}: is cut off" in done.stderr


@pytest.mark.skipif(sys.platform == "win32", reason="signals of Unix")
@pytest.mark.parametrize(
    ("number", "code", "word"), [(signal.SIGINT, 130, "interrupted"), (signal.SIGTERM, 143, "terminated")]
)
def test_a_signal_ends_it_with_what_was_measured(root, number, code, word):
    command = [sys.executable, "-u", "-m", "intent_engine.cli", "evaluate", str(TEN)]
    command += ["--json", "--second-model", "none"]
    with subprocess.Popen(command, cwd=root, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        heard = [process.stdout.readline() for _ in range(2)]
        process.send_signal(number)
        rest = process.stdout.read()
        error = process.stderr.read()
    assert process.returncode == code, error
    *heard, score, interrupted = [json.loads(line) for line in "".join([*heard, rest]).splitlines()]
    assert {one["event"] for one in heard} == {"recording"}
    assert (score["event"], score["recordings"], score["complete"]) == ("score", len(heard), False)
    assert interrupted == {"event": "interrupted", "heard": len(heard), "of": 10}
    assert error == f"error: {word} after {len(heard)} of 10 recordings\n"


@pytest.fixture
def heard_until_ctrl_c(monkeypatch, root) -> Callable[..., Result]:
    """``evaluate`` with a recogniser that hears nothing, and Ctrl-C after so many recordings."""

    class Deaf:
        def close(self) -> None:
            pass

    class Listener:
        left = 0
        ended_by: BaseException = KeyboardInterrupt()

        def hear(self, source: object) -> Hearing:
            if self.left == 0:
                raise self.ended_by
            self.left -= 1
            return Hearing()

    listener = Listener()

    def run(after: int, *options: object, models: int = 1, ended_by: BaseException | None = None) -> Result:
        listener.left, listener.ended_by = after, ended_by or KeyboardInterrupt()
        names = [f"model{number}" for number in range(models)]
        monkeypatch.chdir(root)
        monkeypatch.setattr("intent_engine.cli.evaluate._listener", lambda *_: listener)
        monkeypatch.setattr("intent_engine.cli.evaluate._recognizers", lambda *_: ((name, Deaf()) for name in names))
        chosen = [part for name in names for part in ("-m", name)]
        return CliRunner().invoke(app, ["evaluate", str(TEN), "--no-reflex", *chosen, *map(str, options)])

    return run


def test_what_was_measured_before_ctrl_c_in_a_table_a_spreadsheet_and_a_picture(heard_until_ctrl_c, tmp_path):
    files = ("--csv", tmp_path / "out.csv", "--plot", tmp_path / "out.svg")
    done = heard_until_ctrl_c(3, "--at-least", 0, *files)
    assert done.exit_code == 130
    assert done.stdout.startswith("incomplete: interrupted after 3 of 10 recordings")
    assert "(0/3)" in done.stdout
    assert "every recording that was heard is in" in done.stderr
    assert done.stderr.endswith("error: interrupted after 3 of 10 recordings\n")
    assert len((tmp_path / "out.csv").read_text().splitlines()) == 1 + 3
    assert "interrupted after 3 of 10" in (tmp_path / "out.svg").read_text()


def test_an_error_in_the_midst_loses_nothing_that_was_measured(heard_until_ctrl_c, tmp_path):
    """A file that went away meanwhile, or a disk that cannot be read any more."""
    gone = AudioError("four.wav: no such file\n    record it again")
    done = heard_until_ctrl_c(3, "--csv", tmp_path / "out.csv", ended_by=gone)
    assert done.exit_code == AudioError.exit_code
    assert done.stdout.startswith("incomplete: ended by an error after 3 of 10 recordings")
    assert done.stderr.endswith("error: four.wav: no such file\n    record it again\n")
    assert len((tmp_path / "out.csv").read_text().splitlines()) == 1 + 3
    done = heard_until_ctrl_c(0, ended_by=gone)
    assert (done.exit_code, done.stdout) == (AudioError.exit_code, "")
    assert done.stderr == "error: four.wav: no such file\n    record it again\n"


@pytest.mark.parametrize("missing", ["tiny.enn", "./no_folder"])
def test_a_model_that_is_not_there_is_told_before_another_has_heard_anything(monkeypatch, root, missing):
    monkeypatch.chdir(root)
    monkeypatch.setattr("intent_engine.evaluation.trial.Trial.hear", lambda *_: pytest.fail("it began to hear"))
    done = CliRunner().invoke(app, ["evaluate", str(TEN), "-m", "tiny.en", "-m", missing, "--json"])
    assert (done.exit_code, done.stdout) == (5, "")
    assert missing in done.stderr


@pytest.mark.parametrize("least", [0.9, 1.1, 58.0, 99.9])
def test_just_so_many_per_cent_are_at_least_so_many(least):
    assert Decimal(str(least)) / 100 == Decimal(str(_share(least)))
    assert _share(least) <= round(10 * least) / 1000


def test_which_conditions_are_whole_after_ctrl_c(heard_until_ctrl_c):
    done = heard_until_ctrl_c(14, "--json", models=2)
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    assert [(one["model"], one["complete"]) for one in lines if one["event"] == "score"] == [
        ("model0", True),
        ("model1", False),
    ]
    assert lines[-1] == {"event": "interrupted", "heard": 14, "of": 20}
    assert "interrupted after 14 of 20 hearings (10 recordings, 2 times each)" in done.stderr


def test_ctrl_c_before_anything_was_measured(heard_until_ctrl_c, tmp_path):
    done = heard_until_ctrl_c(0, "--csv", tmp_path / "out.csv")
    assert (done.exit_code, done.stdout) == (130, "")
    assert done.stderr == "error: interrupted before anything was measured\n"
    assert not (tmp_path / "out.csv").exists()


def test_what_was_heard_with_is_let_go_after_ctrl_c(monkeypatch, heard_until_ctrl_c):
    """The exception's traceback would hold it to the end of the process, where native code complains of it."""
    alive, held = [], []

    class Resampler: ...

    def hear(source: object) -> Hearing:
        resampler = Resampler()
        held.append(weakref.ref(resampler))
        raise KeyboardInterrupt

    monkeypatch.setattr("intent_engine.cli.evaluate._show", lambda *_, **__: alive.extend(one() for one in held))
    monkeypatch.setattr("intent_engine.evaluation.trial.Trial.hear", lambda *_: (hear(source) for source in (1, 2)))
    assert heard_until_ctrl_c(0).exit_code == 130
    assert alive == [None]


def test_a_run_to_the_end_says_so(heard_until_ctrl_c):
    done = heard_until_ctrl_c(10, "--json")
    assert done.exit_code == 0
    assert json.loads(done.stdout.splitlines()[-1])["complete"] is True


@pytest.mark.parametrize(("clean", "conditions"), [([], [None, 12, 6]), (["--no-clean"], [12, 6])])
def test_as_it_is_beside_the_noise_or_not(heard_until_ctrl_c, clean, conditions):
    noise = ("--noise", "examples/demo.flac", "--snr", "6,12")
    done = heard_until_ctrl_c(1000, "--json", "--limit", 1, *noise, *clean)
    assert done.exit_code == 0
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    assert [one["snr"] for one in lines if one["event"] == "recording"] == conditions
    assert len([one for one in lines if one["event"] == "score"]) == len(conditions)


def test_a_table_of_eighty_columns(heard_until_ctrl_c, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    done = heard_until_ctrl_c(10)
    assert done.exit_code == 0
    assert max(map(len, done.stdout.splitlines())) <= 80
    words = " ".join(done.stdout.split())
    assert "commands right" in words
    assert "word errors" in words
    assert "p50" not in words, "nothing was done, so it took no time"
    assert "what did not go right" in words
    assert re.search(r"demo.*, none, missed said go forward two meters heard expected move done nothing", words)


def test_without_what_counts_the_words(monkeypatch):
    monkeypatch.setitem(sys.modules, "jiwer", None)
    done = CliRunner().invoke(app, ["evaluate", str(TEN)])
    assert done.exit_code == 2
    assert done.stderr == (
        "error: evaluate needs jiwer, which is not installed\n    pip install 'intent-engine[evaluate]'\n"
    )


def test_two_models_in_folders_of_one_name_are_told_apart():
    from intent_engine.cli.evaluate import _names

    assert _names(["tiny.en", "a/whisper", "b/whisper", "tiny.en"]) == {
        "tiny.en": "tiny.en",
        "a/whisper": "a/whisper",
        "b/whisper": "b/whisper",
    }
    assert _names(["models/mine"]) == {"models/mine": "mine"}
