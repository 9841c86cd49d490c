"""``intent-engine doctor``: a verdict for each thing, what to do, and an exit code; and the same as JSON."""

from __future__ import annotations

import json
from pathlib import Path

import soundfile

ROOT = Path(__file__).resolve().parent.parent.parent
PLAYED = str(ROOT / "tests" / "speech" / "played_microphone")


def test_a_machine_that_has_everything(intent_engine, tmp_path):
    said, rate = soundfile.read(ROOT / "examples" / "demo.flac", start=20_000, stop=60_000, dtype="float32")
    soundfile.write(tmp_path / "said.wav", said, rate)
    done = intent_engine("doctor", "--json", PYTHONPATH=PLAYED, PLAYED=str(tmp_path / "said.wav"))
    assert done.returncode == 0, done.stdout + done.stderr
    report = json.loads(done.stdout)
    assert report["ok"] is True
    verdicts = {check["name"]: check["verdict"] for check in report["checks"]}
    assert list(verdicts) == [
        "Python", "packages", "PortAudio", "microphones", "level", "voice detector", "noise filter", "weights",
        "second model", "CUDA", "decode time",
    ]  # fmt: skip
    assert "missing" not in verdicts.values()
    assert verdicts["level"] == "ok"
    found = {check["name"]: check["found"] for check in report["checks"]}
    assert "in 2.0 s" in found["level"]
    assert "as published" in found["weights"]
    assert "'go forward 2 meters'" in found["decode time"].lower()


def test_a_machine_without_portaudio(intent_engine, tmp_path):
    (tmp_path / "sounddevice.py").write_text("raise OSError('PortAudio library not found')\n", "utf-8")
    done = intent_engine("doctor", PYTHONPATH=str(tmp_path))
    assert done.returncode == 1
    lines = done.stdout.splitlines()
    (at,) = (index for index, line in enumerate(lines) if line.startswith("missing  PortAudio"))
    assert lines[at + 1].strip().startswith("-> install it")
    assert lines[-1] == "missing: PortAudio"
    assert [line for line in lines if line.startswith("ok       weights")], "and it goes on with the rest"


def test_a_machine_that_only_plays_recordings(intent_engine, tmp_path):
    (tmp_path / "sounddevice.py").write_text("raise OSError('PortAudio library not found')\n", "utf-8")
    done = intent_engine("doctor", "--no-microphone", PYTHONPATH=str(tmp_path))
    assert done.returncode == 0, done.stdout
    assert "PortAudio" not in done.stdout
    assert done.stdout.splitlines()[-1] == "everything needed is there"


def test_a_model_that_is_not_there(intent_engine, tmp_path):
    done = intent_engine("doctor", "--no-microphone", "--json", "--model", tmp_path / "none")
    assert done.returncode == 1
    checks = {check["name"]: check for check in json.loads(done.stdout)["checks"]}
    assert checks["weights"]["verdict"] == "missing"
    assert "give a folder with model.bin" in checks["weights"]["advice"]
    assert "decode time" not in checks
