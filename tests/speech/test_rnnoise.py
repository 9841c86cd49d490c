"""RNNoise as the runtime uses it, on a person's voice."""

from __future__ import annotations

import numpy as np
import pytest
import soundfile
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from intent_engine import IntentEngine
from intent_engine.errors import ConfigError
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.executor import Executor
from intent_engine.execution.robots.simulated import SimulatedRobot
from intent_engine.runtime import Runtime
from intent_engine.speech import rnnoise
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.rnnoise import RNNoise, installed_filter
from intent_engine.speech.sources.file import FileSource

pytest.importorskip("pyrnnoise", reason="needs the extra intent-engine[noise]")

FRAME = 512
PRE_ROLL = 16


def frames(samples: np.ndarray) -> list[np.ndarray]:
    return [samples[at : at + FRAME] for at in range(0, samples.size - FRAME + 1, FRAME)]


def filtered(samples: np.ndarray, share: float = rnnoise.TAKEN_OUT) -> np.ndarray:
    cut = frames(samples)
    speech = RNNoise(share).begin(cut[:PRE_ROLL])
    for frame in cut[PRE_ROLL:]:
        speech.add(frame)
    return speech.sound()


def noise(size: int, level: float) -> np.ndarray:
    return np.random.default_rng(1).normal(0.0, level, size).astype(np.float32)


@pytest.fixture
def voice(go_forward) -> np.ndarray:
    return go_forward[: go_forward.size // FRAME * FRAME]


def apart(one: np.ndarray, other: np.ndarray) -> float:
    return float(np.sqrt(np.mean(np.square(one - other))))


@pytest.mark.parametrize("share", [0.2, 0.5, 0.8])
def test_it_takes_noise_out_and_leaves_the_voice_where_it_is(voice, share):
    noisy = voice + noise(voice.size, 0.02)
    less = filtered(noisy, share)
    assert less.size == noisy.size
    assert less.dtype == np.float32
    assert apart(less, voice) < (1.0 - 0.5 * share) * apart(noisy, voice)


def test_where_it_is_quiet_nothing_is_touched(voice):
    assert np.array_equal(filtered(voice + noise(voice.size, 1e-4)), voice + noise(voice.size, 1e-4))


def test_no_share_of_it_is_no_filter(voice):
    noisy = voice + noise(voice.size, 0.02)
    assert np.array_equal(filtered(noisy, 0.0), noisy)


def test_to_look_at_it_in_between_changes_nothing(voice):
    noisy = voice + noise(voice.size, 0.02)
    cut = frames(noisy)
    speech = RNNoise().begin(cut[:PRE_ROLL])
    sizes = []
    for frame in cut[PRE_ROLL:]:
        speech.add(frame)
        sizes.append(speech.sound().size)
    assert sizes == [FRAME * (PRE_ROLL + 1 + number) for number in range(len(sizes))]
    assert np.allclose(speech.sound(), filtered(noisy), atol=1e-6)


@settings(max_examples=40, deadline=None)
@given(
    sound=arrays(
        np.float32,
        st.integers(0, 12).map(lambda count: count * FRAME),
        elements=st.floats(width=32) | st.sampled_from([0.0, 1.0, -1.0]),
    )
)
def test_whatever_comes_what_was_taken_has_its_length(sound):
    with np.errstate(invalid="ignore"):  # infinity less infinity, which no source gives
        less = filtered(sound)
    assert less.size == sound.size
    assert np.isfinite(less[np.isfinite(sound)]).all()


@pytest.mark.parametrize("share", [-0.1, 1.1, float("nan")])
def test_a_share_that_is_none(share):
    with pytest.raises(ConfigError, match="0 to 1"):
        RNNoise(share)


def test_what_a_signal_broke_off_lets_go_of_nothing(capsys):
    """Python calls it whatever became of what was begun, and would tell of its error in the middle of a report."""
    rnnoise._Speech.__new__(rnnoise._Speech).__del__()
    assert capsys.readouterr().err == ""


def test_where_it_is_not_installed(monkeypatch):
    monkeypatch.setattr(rnnoise, "find_spec", lambda name: None)
    rnnoise._library.cache_clear()
    try:
        with pytest.raises(ConfigError, match=r"intent-engine\[noise\]"):
            RNNoise()
        assert installed_filter() is None
    finally:
        rnnoise._library.cache_clear()


class Notes:
    """A recogniser that keeps what it was given."""

    def __init__(self) -> None:
        self.given: list[np.ndarray] = []

    def transcribe(self, samples, *, final=True):
        self.given.append(samples)
        return Transcript("")

    def close(self) -> None:
        pass


def test_the_recogniser_hears_less_noise_unless_told_otherwise(voice, tmp_path):
    engine = IntentEngine.from_files("grammars/en.yaml", locations="locations/home.yaml")
    noisy = voice + noise(voice.size, 0.01)
    soundfile.write(tmp_path / "noisy.wav", noisy, SAMPLE_RATE, subtype="FLOAT")
    given = {}
    for name, choice in {"auto": "auto", "none": None}.items():
        clock = VirtualClock()
        notes = Notes()
        with Executor(SimulatedRobot(clock), clock=clock, handle_sigterm=False) as executor:
            Runtime(engine, executor, notes, noise_filter=choice).run(FileSource(tmp_path / "noisy.wav"))
        given[name] = notes.given[-1]
    assert given["auto"].size == given["none"].size
    at = next(at for at in range(noisy.size) if np.array_equal(noisy[at : at + FRAME], given["none"][:FRAME]))
    clean = voice[at : at + given["none"].size]
    assert apart(given["auto"], clean) < 0.97 * apart(given["none"][: clean.size], clean)
