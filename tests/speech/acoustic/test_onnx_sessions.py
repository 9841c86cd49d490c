"""ONNX Runtime keeps to itself what it does."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from speech_stage import ROOT


def left_by(code: str, home: Path, **environment: str) -> list[Path]:
    """The files that a program leaves in an empty home."""
    kept = {name: value for name, value in os.environ.items() if name not in ("CI", "ORT_DISABLE_TELEMETRY")}
    there = {"HOME": str(home), "XDG_CACHE_HOME": str(home / "cache"), **environment}
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, env={**kept, **there}, check=True)
    return [path for path in home.rglob("*") if path.is_file()]


@pytest.mark.parametrize(
    "code",
    [
        "from intent_engine.speech.voice import SileroVoice; SileroVoice()",
        "from intent_engine.speech.acoustic.onnx_sessions import onnx_runtime; onnx_runtime().SessionOptions()",
    ],
    ids=["the voice detector", "by itself"],
)
def test_nothing_is_written_down_about_who_uses_it(tmp_path, code):
    assert left_by(code, tmp_path) == []


def test_whoever_wants_it_to_tell_may(tmp_path):
    code = "from intent_engine.speech.acoustic.onnx_sessions import onnx_runtime; onnx_runtime()"
    code += "; import os; assert os.environ['ORT_DISABLE_TELEMETRY'] == '0'"
    left_by(code, tmp_path, ORT_DISABLE_TELEMETRY="0")


def test_it_is_imported_in_one_place():
    imports = re.compile(r"^\s*(import onnxruntime|from onnxruntime import)\b", re.MULTILINE)
    found = [path.name for path in (ROOT / "intent_engine").rglob("*.py") if imports.search(path.read_text("utf-8"))]
    assert found == ["onnx_sessions.py"]
