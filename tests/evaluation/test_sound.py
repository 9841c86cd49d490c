"""Noise at an SNR, pieces of files, and where speech ends."""

from __future__ import annotations

import os

import numpy as np
import pytest
import soundfile
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.errors import AudioError
from intent_engine.evaluation.labels import Expected, Row
from intent_engine.evaluation.sound import (
    ENERGY_FRAME,
    Noise,
    SamplesSource,
    check,
    end_of_speech,
    load,
    mix,
    read_whole,
)
from intent_engine.speech.sources.file import FileSource

RATE = 16_000


def tone(seconds: float, level: float = 0.1) -> np.ndarray:
    return (level * np.sin(2 * np.pi * 440 * np.arange(int(seconds * RATE)) / RATE)).astype(np.float32)


def loudest(samples: np.ndarray) -> float:
    whole = samples.size // ENERGY_FRAME
    return float((samples[: whole * ENERGY_FRAME].reshape(whole, -1).astype(float) ** 2).sum(axis=1).max())


@given(
    snr=st.floats(-20, 40),
    speech_level=st.floats(0.001, 1.0),
    noise_level=st.floats(0.001, 1.0),
    seed=st.integers(0, 2**32 - 1),
)
def test_the_noise_has_the_snr_that_was_asked_for_and_nothing_clips(snr, speech_level, noise_level, seed):
    chance = np.random.default_rng(seed)
    speech = tone(0.6, speech_level)
    noise = (noise_level * chance.uniform(-1, 1, speech.size)).astype(np.float32)
    mixed = mix(speech, noise, snr)
    assert np.abs(mixed).max() <= 1.0 + 1e-6
    # What is left after the speech, at its scale, is the noise.
    scale = np.linalg.lstsq(np.stack([speech, noise], axis=1).astype(float), mixed.astype(float), rcond=None)[0]
    ratio = 10 * np.log10(loudest(scale[0] * speech) / loudest(scale[1] * noise))
    assert ratio == pytest.approx(snr, abs=0.05)


def test_silence_stays_what_it_is():
    speech, silence = tone(0.5), np.zeros(RATE // 2, np.float32)
    assert mix(speech, silence, 6) is speech
    assert mix(silence, speech, 6) is silence


def test_a_row_gets_the_same_noise_whatever_else_is_heard():
    ramps = tuple(np.linspace(-1, 1, size, dtype=np.float32) for size in (RATE, 3 * RATE))
    noise = Noise(ramps, ("short", "long"))
    pieces = [noise.piece(f"row {index}", RATE // 2) for index in range(20)]
    assert all(np.array_equal(noise.piece(f"row {index}", RATE // 2), piece) for index, piece in enumerate(pieces))
    assert len({piece.tobytes() for piece in pieces}) == 20
    assert noise.piece("long", 10 * RATE).shape == (10 * RATE,)


def test_a_file_is_heard_as_run_hears_it(tmp_path):
    path = tmp_path / "a.flac"
    soundfile.write(path, tone(0.7), 22_050)
    heard = np.concatenate([frame.samples for frame in FileSource(path).frames()])
    again = np.concatenate([frame.samples for frame in SamplesSource(read_whole(path)).frames()])
    assert np.array_equal(heard, again)


def test_a_part_of_a_file(tmp_path):
    path = tmp_path / "a.wav"
    soundfile.write(path, np.concatenate([tone(1.0), 0.5 * np.ones(RATE, np.float32)]), RATE, subtype="FLOAT")
    part = load(Row("a", 1, path, Expected(), start=1.25, end=1.5))
    assert np.allclose(part[: RATE // 4], 0.5)
    assert not np.any(part[RATE // 4 :])
    assert part.size > RATE // 4 + RATE // 2


def test_a_file_of_many_parts_is_decoded_once_unless_it_changes(tmp_path, monkeypatch):
    read = []

    class Counted(FileSource):
        def frames(self):
            read.append(self.path)
            return super().frames()

    monkeypatch.setattr("intent_engine.evaluation.sound.FileSource", Counted)
    path = tmp_path / "many.wav"
    soundfile.write(path, np.linspace(0, 0.9, 3 * RATE), RATE)
    parts = [load(Row("a", 1, path, Expected(), start=start, end=start + 0.5)) for start in (0.5, 1.0, 2.0)]
    assert [part[0] for part in parts] == pytest.approx([0.15, 0.3, 0.6], abs=1e-3)
    assert len(read) == 1
    soundfile.write(path, np.full(3 * RATE, 0.25), RATE)
    os.utime(path, ns=(0, 0))
    assert load(Row("a", 1, path, Expected(), start=1.0, end=1.5))[0] == pytest.approx(0.25, abs=1e-3)
    path.unlink()
    with pytest.raises(AudioError, match="no such file"):
        load(Row("a", 1, path, Expected(), start=1.0, end=1.5))


def test_every_sound_that_cannot_be_used_is_told_before_the_first_is_heard(tmp_path):
    soundfile.write(tmp_path / "good.wav", tone(1.0), RATE)
    (tmp_path / "empty.wav").touch()
    (tmp_path / "text.wav").write_text("no sound")
    rows = [Row(name, line, tmp_path / name, Expected()) for line, name in enumerate(["good.wav", "empty.wav"], 1)]
    rows += [
        Row("text", 3, tmp_path / "text.wav", Expected()),
        Row("late", 4, tmp_path / "good.wav", Expected(), start=2.0),
    ]
    with pytest.raises(AudioError) as caught:
        check(rows, tmp_path / "labels.jsonl")
    text = str(caught.value)
    assert "labels.jsonl:1" not in text
    assert all(f"labels.jsonl:{line}: " in text for line in (2, 3, 4))
    check(rows[:1], tmp_path / "labels.jsonl")


@pytest.mark.parametrize(("end", "speech_end"), [(None, 2.0), (1.5, 1.8), (1.5, 0.9)])
def test_a_word_that_ends_after_its_sound_is_told(tmp_path, end, speech_end):
    """Counted from the beginning of the file, say: times to the action would be too short, or below zero."""
    soundfile.write(tmp_path / "a.wav", tone(2.0), RATE)
    rows = [Row("a", 7, tmp_path / "a.wav", Expected(), start=1.0, end=end, speech_end=speech_end)]
    if speech_end < 1.0:
        check(rows, tmp_path / "labels.jsonl")
        return
    with pytest.raises(AudioError, match=rf"labels.jsonl:7: 'speech_end' is {speech_end:g} s, and the sound lasts "):
        check(rows, tmp_path / "labels.jsonl")


def test_noise_that_is_none(tmp_path):
    soundfile.write(tmp_path / "silent.wav", np.zeros(RATE), RATE)
    with pytest.raises(AudioError, match="is silent"):
        Noise.read([tmp_path / "silent.wav"])


@given(start=st.floats(0, 1), length=st.floats(0.1, 1), tail=st.floats(0, 1), level=st.floats(0.01, 1))
def test_speech_ends_where_the_sound_does(start, length, tail, level):
    quiet = [np.zeros(int(seconds * RATE), np.float32) for seconds in (start, tail)]
    sound = np.concatenate([quiet[0], tone(length, level), quiet[1]])
    end = (quiet[0].size + int(length * RATE)) / RATE
    assert end_of_speech(sound) == pytest.approx(end, abs=0.011)
    assert end_of_speech(quiet[0]) == 0.0
