"""The real PortAudio, with a microphone of ALSA's that reads a file: no hardware, but nothing is made up.

It gives sound as fast as it is taken, so it is also the fastest microphone that there is.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="ALSA is Linux's")

ALSA = """
pcm.filed {{ type file slave.pcm {{ type null }} file "/dev/null" infile "{file}" format "raw"
             hint {{ show on description "a file" }} }}
pcm.!default filed
"""

LISTEN = """
import json, resource, sys, time
from intent_engine.errors import DeviceError
try:
    from intent_engine.speech.sources.devices import list_devices
    names = [one.name for one in list_devices()]
    from intent_engine.speech.sources.microphone import Microphone
    reports = []
    microphone = Microphone("filed", on_report=reports.append)
except DeviceError as error:
    sys.exit(f"skip: {error}")
count = lost = loud = deaf = 0
began = time.monotonic()
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
for frame in microphone.frames():
    count, lost, deaf = count + 1, lost + frame.lost, deaf + frame.deaf
    loud = max(loud, float(abs(frame.samples).max()))
    if time.monotonic() - began > 1.0:
        microphone.close()
print(json.dumps({"names": names, "count": count, "lost": lost, "loud": loud, "deaf": deaf, "time": frame.time,
                  "kinds": [report.kind.value for report in reports],
                  "grown": (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1000}))
"""


def test_a_microphone_that_floods(tmp_path: Path):
    tone = (0.25 * np.sin(2 * np.pi * 440 * np.arange(16_000) / 16_000)).astype(np.float32)
    (tmp_path / "tone.raw").write_bytes(tone.tobytes())
    (tmp_path / "asound.conf").write_text(ALSA.format(file=tmp_path / "tone.raw"), "utf-8")
    done = subprocess.run(
        [sys.executable, "-c", LISTEN],
        env={**os.environ, "ALSA_CONFIG_PATH": str(tmp_path / "asound.conf")},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    if done.returncode and done.stderr.startswith("skip: "):
        pytest.skip(f"needs PortAudio with ALSA: {done.stderr.splitlines()[0][6:]}")
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert "filed" in found["names"]
    assert found["count"] > 100
    assert found["loud"] == pytest.approx(0.25, abs=0.01), "its sound is heard"
    assert found["lost"] > 10, "most of it could not be taken in time"
    assert "lost" in found["kinds"]
    assert found["time"] < 10, "and it is dropped, not piled up"
    assert found["grown"] < 60, "MB"
