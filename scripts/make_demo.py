"""Make the spoken session that `make demo` plays: examples/demo.flac and its text, examples/demo.jsonl.

The voice is synthetic: Flite's `slt` (CMU Arctic), so that no person's recording is in the repository. Playing the
session needs no synthesiser; making it again needs `flite` (on Debian: `apt-get install flite`) and this package.

    python scripts/make_demo.py
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import soundfile
import soxr

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
RATE = 16_000
"""Hz, what the recogniser takes."""
NOISE = 0.5 / 32768
"""Standard deviation of the noise under the speech: half a step of 16 bits, less than a quiet microphone has. More
would only make the file larger."""

SESSION: list[tuple[str, float, str]] = [
    # What is said, seconds of quiet after it (time for the robot to do it), and the action that it shall give.
    ("go forward two meters", 5.0, "move"),
    ("turn left ninety degrees", 4.5, "turn"),
    ("go to the kitchen", 13.0, "navigate"),
    ("pick up the box", 3.0, "pick"),
    ("I was going to go to the bedroom", 2.0, ""),  # talk, not an order: nothing may happen
    ("go to the living room", 12.0, "navigate"),
    ("put the box on the table", 3.0, "place"),
    ("drive backward one meter", 5.0, "move"),
    ("go to the bedroom", 4.0, "navigate"),
    ("stop please", 2.0, "stop"),  # on the way: the robot stays where it is
]


def say(text: str) -> np.ndarray:
    """The text spoken, mono, at :data:`RATE`, as float32."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "speech.wav"
        subprocess.run(["flite", "-voice", "slt", "--setf", "duration_stretch=1.1", "-t", text, "-o", path], check=True)
        samples, rate = soundfile.read(path, dtype="float32")
    return 0.4 * soxr.resample(samples, rate, RATE)


def main() -> None:
    pieces = [np.zeros(RATE, dtype=np.float32)]
    labels = []
    at = len(pieces[0])
    for text, quiet, action in SESSION:
        speech = say(text)
        labels.append(
            {"text": text, "start": round(at / RATE, 2), "end": round((at + len(speech)) / RATE, 2), "action": action}
        )
        pieces += [speech, np.zeros(int(quiet * RATE), dtype=np.float32)]
        at += len(speech) + len(pieces[-1])
    audio = np.concatenate(pieces)
    audio += NOISE * np.random.default_rng(1).standard_normal(len(audio)).astype(np.float32)
    EXAMPLES.mkdir(exist_ok=True)
    soundfile.write(EXAMPLES / "demo.flac", audio, RATE, subtype="PCM_16", compression_level=1.0)
    lines = [json.dumps(label) for label in labels]
    (EXAMPLES / "demo.jsonl").write_text("\n".join(lines) + "\n", "utf-8")
    size = (EXAMPLES / "demo.flac").stat().st_size
    print(f"examples/demo.flac: {len(audio) / RATE:.1f} s, {size / 1000:.0f} kB, {len(SESSION)} sentences")


if __name__ == "__main__":
    sys.exit(main())
