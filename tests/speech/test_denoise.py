"""The filter before the recogniser: less noise, the same length, and never anything that is no sound."""

from __future__ import annotations

import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from noises import pink, white
from speech_stage import Says

from intent_engine.errors import ConfigError
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.recognizer import Transcript

pytest.importorskip("noisereduce", reason="needs the extra intent-engine[noise]")
from intent_engine.speech.denoise import DenoisedRecognizer, NoiseReduction


@pytest.fixture(scope="module")
def reduce() -> NoiseReduction:
    return NoiseReduction()


@pytest.mark.parametrize("noise", [white(4.1, 0.03), pink(4.1, 0.03)], ids=["white", "pink"])
def test_speech_stands_out_more(reduce, go_forward, noise):
    noise = noise[: go_forward.size].astype(np.float32)
    mixed = go_forward + noise
    heard = reduce(mixed)
    quiet = slice(0, int(1.0 * SAMPLE_RATE))
    loud = slice(int(1.6 * SAMPLE_RATE), int(3.0 * SAMPLE_RATE))

    def ratio(sound: np.ndarray) -> float:
        return float(np.std(sound[loud]) / np.std(sound[quiet]))

    assert ratio(heard) > 2 * ratio(mixed)
    assert np.std(heard[loud]) > 0.5 * np.std(mixed[loud]), "the voice is still there"


@settings(deadline=None, max_examples=25)
@given(st.integers(0, 20_000), st.sampled_from(["noise", "silence", "nan", "loud", "one"]))
def test_any_sound_keeps_its_length_and_stays_sound(reduce, size, kind):
    sound = {
        "noise": np.random.default_rng(size).normal(0, 0.1, size),
        "silence": np.zeros(size),
        "nan": np.full(size, np.nan),
        "loud": np.random.default_rng(size).normal(0, 100, size),
        "one": np.ones(size),
    }[kind].astype(np.float32)
    heard = reduce(sound)
    assert heard.shape == sound.shape
    assert heard.dtype == np.float32
    if kind != "nan":
        assert np.isfinite(heard).all()


@pytest.mark.parametrize("strength", [-0.1, 1.1, float("nan")])
def test_a_strength_that_is_none(strength):
    with pytest.raises(ConfigError, match="give 0 to 1"):
        NoiseReduction(strength)


def test_without_the_package(monkeypatch):
    monkeypatch.setitem(sys.modules, "noisereduce", None)
    with pytest.raises(ConfigError, match=r"pip install 'intent-engine\[noise\]'"):
        NoiseReduction()


def test_the_recogniser_hears_what_is_left(reduce):
    heard = []

    class Listening:
        closed = False

        def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
            heard.append((samples, final))
            return Transcript("go")

        def close(self) -> None:
            self.closed = True

    inner = Listening()
    denoised = DenoisedRecognizer(inner, reduce)
    sound = white(1.0, 0.1).astype(np.float32)
    assert denoised.transcribe(sound, final=False).text == "go"
    ((samples, final),) = heard
    assert final is False
    assert samples.std() < 0.6 * sound.std()
    denoised.close()
    assert inner.closed


def test_it_glances_and_is_left_as_the_recogniser_is(reduce, monkeypatch, whisper, go_forward):
    denoised = DenoisedRecognizer(whisper, reduce)
    sound = go_forward + white(4.1, 0.005)[: go_forward.size].astype(np.float32)
    glanced, expected = denoised.glance(sound), whisper.glance(reduce(sound))
    assert (glanced.text, glanced.score, glanced.draft) == (expected.text, expected.score, expected.draft)
    assert glanced.score != whisper.glance(sound).score
    left = []
    monkeypatch.setattr(whisper, "leave", lambda: left.append(True))
    denoised.leave()
    assert left == [True]


def test_where_the_recogniser_cannot_it_knows_nothing_at_a_glance_and_is_not_left(reduce):
    denoised = DenoisedRecognizer(Says("go forward two meters"), reduce)
    assert denoised.glance(white(1.0, 0.1).astype(np.float32)) == Transcript("", draft=True)
    denoised.leave()


def test_a_command_in_noise_is_still_a_command(listen, whisper, go_forward, reduce):
    noisy = go_forward + pink(4.1, 0.01)[: go_forward.size].astype(np.float32)
    found = listen(noisy, DenoisedRecognizer(whisper, reduce))
    assert found.robot.pose().x == pytest.approx(2.0), found.texts
