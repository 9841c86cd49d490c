"""Verdicts on microphones that are not as they should be, and on other machines' Pythons and weights."""

from __future__ import annotations

import sys

import numpy as np
import pytest
from fake_portaudio import FakePortAudio, FakeTime, Plug, PortAudioError, tone

from intent_engine.errors import DeviceError
from intent_engine.speech import doctor
from intent_engine.speech.doctor import Verdict, examine
from intent_engine.speech.sources import live
from intent_engine.speech.sources.microphone import Microphone


@pytest.fixture
def machine(monkeypatch):
    """What the doctor says of a machine with these microphones."""

    def look(*plugs: Plug) -> dict[str, doctor.Check]:
        time = FakeTime()
        monkeypatch.setitem(sys.modules, "sounddevice", FakePortAudio(time, *plugs))
        monkeypatch.setattr(live, "MonotonicClock", lambda: time)
        monkeypatch.setattr(doctor.time, "monotonic", time.now)
        for later in ("_voice", "_noise_filter", "_cuda"):
            monkeypatch.setattr(doctor, later, lambda: doctor.Check("", Verdict.OK, ""))
        for later in ("_second_model", "_weights"):
            monkeypatch.setattr(doctor, later, lambda _: doctor.Check("weights", Verdict.MISSING, ""))
        return {check.name: check for check in examine()}

    return look


def noise(level: float):
    return lambda moments: level * np.random.default_rng(1).standard_normal(moments.size)


@pytest.mark.parametrize(
    ("sound", "verdict", "says", "advice"),
    [
        (tone(), Verdict.OK, "peak -6 dBFS", ""),
        (noise(0.02), Verdict.OK, "dBFS in 2.0 s", ""),
        (noise(1e-5), Verdict.WARNING, "very quiet", "turn the microphone up"),
        (lambda moments: np.sign(np.sin(440 * moments)), Verdict.WARNING, "too loud", "turn the microphone down"),
        (np.zeros_like, Verdict.MISSING, "nothing but zeros", "Switch it on"),
    ],
    ids=["tone", "room", "quiet", "loud", "muted"],
)
def test_levels(machine, sound, verdict, says, advice):
    check = machine(Plug("headset", sound=sound))["level"]
    assert check.verdict is verdict, check
    assert says in check.found
    assert check.advice.startswith(advice)
    assert bool(check.advice) is bool(advice)


def test_no_microphone(machine):
    found = machine()
    assert found["microphones"].verdict is Verdict.MISSING
    assert "plug one in" in found["microphones"].advice
    assert "level" not in found


def test_microphones_that_cannot_be_listed_are_told_and_the_rest_is_looked_at(machine, monkeypatch):
    def refuse(self: FakePortAudio) -> None:
        raise PortAudioError("Internal PortAudio error [PaErrorCode -9986]")

    monkeypatch.setattr(FakePortAudio, "query_devices", refuse)
    found = machine(Plug("headset"))
    assert found["microphones"].verdict is Verdict.MISSING
    assert "cannot be listed: Internal PortAudio error" in found["microphones"].found
    assert list(found)[-1] == "weights"
    with pytest.raises(DeviceError, match="cannot be listed"):
        Microphone()


def test_a_microphone_that_another_program_holds(machine):
    check = machine(Plug("headset", busy=True))["level"]
    assert check.verdict is Verdict.MISSING
    assert "cannot be opened: Device unavailable" in check.found
    assert check.advice


def test_a_microphone_that_is_unplugged_meanwhile(machine):
    headset = Plug("headset")

    def unplug(moments: np.ndarray) -> np.ndarray:
        headset.plugged = moments[-1] < 0.5
        return tone()(moments)

    headset.sound = unplug
    check = machine(headset)["level"]
    assert check.verdict is Verdict.MISSING
    assert "headset gives no sound" in check.found


def test_sound_that_gets_lost(machine):
    headset = Plug("headset")
    headset.overflows = 3
    check = machine(headset)["level"]
    assert check.verdict is Verdict.WARNING
    assert "were lost" in check.found


@pytest.mark.parametrize(
    ("version", "verdict"),
    [((3, 10, 9), Verdict.MISSING), ((3, 11, 0), Verdict.OK), ((3, 13, 2), Verdict.OK), ((3, 14, 0), Verdict.MISSING)],
)
def test_pythons(monkeypatch, version, verdict):
    monkeypatch.setattr(sys, "version_info", version)
    check = next(examine(microphone=False))
    assert check.verdict is verdict
    assert bool(check.advice) is (verdict is Verdict.MISSING)


def test_without_a_noise_filter_speech_works_but_not_as_well(monkeypatch):
    from intent_engine.speech import rnnoise

    monkeypatch.setattr(rnnoise, "find_spec", lambda name: None)
    rnnoise._library.cache_clear()
    try:
        (check,) = (check for check in examine(microphone=False) if check.name == "noise filter")
    finally:
        rnnoise._library.cache_clear()
    assert check.verdict is Verdict.WARNING
    assert check.advice == "pip install 'intent-engine[noise]'"


def test_weights_that_were_changed(monkeypatch, tmp_path):
    from intent_engine.speech import weights

    monkeypatch.setattr(weights, "sha256", lambda path: "0" * 64)
    checks = [check for check in examine(microphone=False) if check.name == "weights"]
    assert checks[0].verdict is Verdict.MISSING
    assert "is not the published one" in checks[0].found
    assert "pip install --force-reinstall" in checks[0].advice
