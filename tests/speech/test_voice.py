"""Silero's real weights: speech is speech, and nothing else is; whatever it is given, it goes on."""

from __future__ import annotations

import numpy as np
import pytest
from speech_stage import framed

from intent_engine.speech import voice
from intent_engine.speech.audio import FRAME_SAMPLES, SAMPLE_RATE, clean
from intent_engine.speech.voice import SileroVoice


@pytest.fixture(scope="module")
def silero():
    return SileroVoice()


def probabilities(detector: SileroVoice, sound: np.ndarray) -> np.ndarray:
    detector.reset()
    return np.array([detector.probability(frame.samples) for frame in framed(clean(sound))])


def test_speech_is_heard_and_the_quiet_around_it_is_not(silero, go_forward):
    found = probabilities(silero, go_forward)
    speech = found > 0.5
    assert 0.8 < speech.sum() * 0.032 < 2.5, "three words and a number"
    first, last = np.flatnonzero(speech)[[0, -1]]
    assert (found[: first - 3] < 0.35).all()
    assert (found[last + 4 :] < 0.35).all()


@pytest.mark.parametrize("gain", [0.05, 0.3, 3.0, 30.0])
def test_loud_and_soft_voices(silero, go_forward, gain):
    assert (probabilities(silero, gain * go_forward) > 0.5).sum() * 0.032 > 0.6


RNG = np.random.default_rng(7)
MOMENTS = np.arange(4 * SAMPLE_RATE) / SAMPLE_RATE
NO_SPEECH = {
    "silence": np.zeros(4 * SAMPLE_RATE),
    "direct current": np.full(4 * SAMPLE_RATE, 0.7),
    "white noise": RNG.normal(0, 0.1, 4 * SAMPLE_RATE),
    "hum": 0.4 * np.sin(2 * np.pi * 50 * MOMENTS),
    "tone": 0.4 * np.sin(2 * np.pi * 440 * MOMENTS),
    "clicks": (np.arange(4 * SAMPLE_RATE) % 4_000 == 0).astype(float),
    "square wave": np.sign(np.sin(2 * np.pi * 200 * MOMENTS)),
}


@pytest.mark.parametrize("name", NO_SPEECH)
def test_what_is_no_speech(silero, name):
    found = probabilities(silero, NO_SPEECH[name])
    assert np.isfinite(found).all()
    assert (found > 0.5).mean() < 0.05


def test_the_same_sound_gives_the_same_answer_after_a_reset(silero, go_forward):
    first = probabilities(silero, go_forward)
    assert probabilities(silero, go_forward).tolist() == first.tolist()


@pytest.mark.parametrize("broken", [np.nan, np.inf, -np.inf, 1e38])
def test_samples_that_are_no_numbers_do_not_deafen_it(silero, go_forward, broken):
    silero.reset()
    for _ in range(10):
        found = silero.probability(np.full(FRAME_SAMPLES, broken, np.float32))
        assert 0 <= found <= 1
    after = [silero.probability(frame.samples) for frame in framed(go_forward)]
    assert np.isfinite(after).all()
    assert (np.array(after) > 0.5).sum() * 0.032 > 0.6


@pytest.mark.parametrize("shape", [(0,), (511,), (513,), (512, 2), (1, 512)])
def test_a_frame_has_512_samples(silero, shape):
    with pytest.raises(ValueError, match="512 samples"):
        silero.probability(np.zeros(shape, np.float32))


def test_without_its_weights(monkeypatch):
    from intent_engine.errors import WeightsError

    monkeypatch.setattr(voice.importlib.util, "find_spec", lambda name: None)
    with pytest.raises(WeightsError, match="pip install --force-reinstall faster-whisper"):
        SileroVoice()
