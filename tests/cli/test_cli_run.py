"""``intent-engine run``: sound files of every shape through the real recogniser to the simulated robot."""

from __future__ import annotations

import json
import math
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import soundfile
import soxr

ROOT = Path(__file__).resolve().parent.parent.parent
DEMO = ROOT / "examples" / "demo.flac"
RATE = 16_000


@pytest.fixture(scope="module")
def go_forward() -> np.ndarray:
    """ "go forward two meters", and a second of quiet."""
    samples, rate = soundfile.read(DEMO, stop=int(4.1 * RATE), dtype="float32")
    assert rate == RATE
    return samples


@pytest.mark.parametrize(
    ("name", "rate", "channels", "subtype"),
    [
        ("speech.wav", 8_000, 1, "PCM_16"),
        ("speech.flac", 44_100, 2, "PCM_24"),
        ("speech.wav", 96_000, 2, "FLOAT"),
    ],
)
def test_any_rate_and_number_of_channels(in_process, tmp_path, go_forward, name, rate, channels, subtype):
    samples = soxr.resample(go_forward, RATE, rate)
    soundfile.write(tmp_path / name, np.stack([samples] * channels, axis=1), rate, subtype=subtype)
    done = in_process("run", tmp_path / name)
    assert done.returncode == 0, done.stdout + done.stderr
    lines = done.stdout.splitlines()
    order = ["heard", "understood  move direction=forward distance=2", "doing       move forward 2.00 m", "done"]
    assert [next(i for i, line in enumerate(lines) if word in line) for word in order] == [0, 1, 2, 3]
    assert "x 2.00 m, y 0.00 m, facing 0°" in lines[3]
    assert done.stderr == ""


def test_json_lines(in_process, tmp_path, go_forward):
    soundfile.write(tmp_path / "speech.wav", go_forward, RATE)
    done = in_process("run", "--json", tmp_path / "speech.wav")
    assert done.returncode == 0, done.stderr
    events = [json.loads(line) for line in done.stdout.splitlines()]
    kinds = [event["event"] for event in events]
    assert kinds[0] == "speech"
    assert kinds.index("transcript") < kinds.index("interpretation") < kinds.index("goal")
    assert kinds[-1] == "end"
    found = next(event for event in events if event["event"] == "interpretation")["interpretation"]
    assert found["actions"] == [{"type": "move", "linear_velocity": 0.5, "distance": 2.0, "duration": 4.0}]
    goals = [event for event in events if event["event"] == "goal"]
    assert [event["state"] for event in goals][-2:] == ["executing", "succeeded"]
    assert goals[-1]["pose"]["x"] == pytest.approx(2.0)
    times = [event["time"] for event in events]
    assert times == sorted(times)


def test_talk_that_is_no_command_moves_nothing(in_process, tmp_path):
    labels = [json.loads(line) for line in (ROOT / "examples" / "demo.jsonl").read_text("utf-8").splitlines()]
    talk = next(label for label in labels if not label["action"])
    start, stop = int((talk["start"] - 0.5) * RATE), int((talk["end"] + 0.5) * RATE)
    samples, _ = soundfile.read(DEMO, start=start, stop=stop)
    soundfile.write(tmp_path / "talk.flac", samples, RATE)
    done = in_process("run", "--json", tmp_path / "talk.flac")
    assert done.returncode == 1
    events = [json.loads(line) for line in done.stdout.splitlines()]
    assert not [event for event in events if event["event"] == "goal"]
    assert (events[-1]["utterances"], events[-1]["accepted"]) == (1, 0)
    assert events[-1]["pose"] == {"x": 0.0, "y": 0.0, "yaw": 0.0, "frame": "map"}


def test_the_demo_is_understood_as_it_was_written(in_process):
    labels = [json.loads(line) for line in (ROOT / "examples" / "demo.jsonl").read_text("utf-8").splitlines()]
    done = in_process("run", "--json", DEMO)
    assert done.returncode == 0, done.stdout + done.stderr
    events = [json.loads(line) for line in done.stdout.splitlines()]
    said = [event["interpretation"] for event in events if event["event"] == "interpretation"]
    assert [[action["type"] for action in item["actions"]] for item in said] == [
        [label["action"]] if label["action"] else [] for label in labels
    ]
    # The last two: on its way to the bedroom the robot is told to stop, and stands there.
    pose = events[-1]["pose"]
    assert math.dist((pose["x"], pose["y"]), (2.0, 8.0)) > 0.5


@pytest.mark.data
@pytest.mark.parametrize("clip", ["pocketsphinx_goforward.flac"])
def test_a_person_drives_the_robot_ten_meters(intent_engine, clip):
    path = ROOT.parent / "shared" / "data" / "clips" / "audio" / clip
    if not path.exists():
        pytest.skip("needs the recordings of shared/data, which are not part of the repository")
    done = intent_engine("run", "--json", path)
    assert done.returncode == 0, done.stdout + done.stderr
    pose = json.loads(done.stdout.splitlines()[-1])["pose"]
    assert (pose["x"], pose["y"]) == (pytest.approx(10.0, abs=1e-6), pytest.approx(0.0, abs=1e-6))


@pytest.mark.skipif(sys.platform == "win32", reason="signals of Unix")
@pytest.mark.parametrize(
    ("numbers", "code", "word"),
    [
        ([signal.SIGINT], 130, "interrupted"),
        ([signal.SIGTERM], 143, "terminated"),
        ([signal.SIGINT] * 4, 130, "interrupted"),
        ([signal.SIGTERM, signal.SIGINT], None, None),
    ],
)
def test_a_signal_stops_the_robot(tmp_path, numbers, code, word):
    """While the robot drives, in real time: it is told as canceled, and nothing is driven after it.

    Whoever presses Ctrl-C twice does not interrupt what stops the robot. Which of two kinds of signals comes first is
    not told to a process that had no time between them.
    """
    samples, _ = soundfile.read(DEMO, start=int(1.2 * RATE), frames=8 * RATE)  # begins at once
    soundfile.write(tmp_path / "speech.wav", samples, RATE)
    command = [sys.executable, "-u", "-m", "intent_engine.cli", "run", "--realtime", "--json"]
    command.append(str(tmp_path / "speech.wav"))
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        for line in process.stdout:
            if json.loads(line).get("state") == "executing":
                for number in numbers:
                    process.send_signal(number)
                    time.sleep(0.01)
                break
        rest = [json.loads(line) for line in process.stdout]
        error = process.stderr.read()
    if code is None:
        code, word = (143, "terminated") if "terminated" in error else (130, "interrupted")
    assert process.returncode == code, error
    assert error.startswith(f"error: {word}; the robot is stopped")
    assert "Traceback" not in error
    ends = [event for event in rest if event["event"] == "goal"]
    assert [event["state"] for event in ends][-1] == "canceled"
    assert ends[-1]["pose"]["x"] < 2.0


def test_a_reader_that_goes_away(intent_engine):
    command = f"{sys.executable} -m intent_engine.cli run --json {DEMO} | head -n 1; echo ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", command], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "141"
    assert "Traceback" not in done.stderr


def test_states_that_the_robot_is_in(intent_engine, tmp_path, go_forward):
    grammar = tmp_path / "dock.yaml"
    grammar.write_text(
        "language: en\nintents:\n  go: {action: {type: move, direction: forward}, excludes: [docked], "
        "sentences: [go forward two meters]}\n"
    )
    soundfile.write(tmp_path / "speech.wav", go_forward, RATE)
    options = ("run", "--grammar", grammar, "--state")
    docked = intent_engine(*options, "docked", tmp_path / "speech.wav")
    assert "go cannot be done while the robot is docked" in docked.stdout
    assert "doing" not in docked.stdout
    assert "did you mean 'docked'?" in intent_engine(*options, "dokced", tmp_path / "speech.wav").stderr


def test_the_form_of_raw_samples_changes_no_recording_that_has_a_header(intent_engine, tmp_path, go_forward):
    path = tmp_path / "speech.wav"
    soundfile.write(path, go_forward, RATE)
    done = intent_engine("run", path, "--rate", 8_000)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stderr.startswith(f"--rate, --format and --channels are of raw samples; {path} says how its own lie")
