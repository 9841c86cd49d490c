"""Frames: whatever comes in, 512 finite samples at 16 kHz come out, in time."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from intent_engine.speech.audio import (
    FRAME_SAMPLES,
    FRAME_SECONDS,
    SAMPLE_RATE,
    Resampler,
    clean,
    in_silence,
    to_float,
)

RATES = (8_000, 11_025, 16_000, 22_050, 32_000, 44_100, 48_000, 96_000, 192_000)
ANY_SOUND = arrays.arrays(
    st.sampled_from([np.float32, np.float64]),
    arrays.array_shapes(min_dims=1, max_dims=2, max_side=64),
    elements={"allow_nan": True, "allow_infinity": True},
)


@given(ANY_SOUND)
@pytest.mark.filterwarnings("error")
def test_what_is_cleaned_is_finite_mono_and_within_bounds(samples):
    sound = clean(samples)
    assert sound.dtype == np.float32
    assert sound.shape == samples.shape[:1]
    assert np.isfinite(sound).all()
    assert (np.abs(sound) <= 1).all()


@pytest.mark.parametrize("dtype", [np.int8, np.int16, np.int32, np.uint8, np.uint16, np.float32, np.float64])
def test_every_number_type_has_the_same_loudness(dtype):
    wanted = np.array([-1.0, -0.5, 0.0, 0.5])
    if np.issubdtype(dtype, np.floating):
        given_samples = wanted.astype(dtype)
    else:
        half = (int(np.iinfo(dtype).max) - int(np.iinfo(dtype).min) + 1) / 2
        given_samples = (wanted * half + (half if np.issubdtype(dtype, np.unsignedinteger) else 0)).astype(dtype)
    assert to_float(given_samples) == pytest.approx(wanted)


@pytest.mark.parametrize("samples", [np.array(["go"]), np.array([1j]), np.array([True]), np.array([object()])])
def test_what_is_no_sound_is_refused(samples):
    with pytest.raises(TypeError, match="must be numbers"):
        to_float(samples)


@given(st.integers(0, 3_000), st.floats(0.0, 0.15), st.floats(0.0, 0.1))
def test_a_short_sound_is_whole_within_its_silence(size, seconds, around):
    sound = np.ones(size, np.float32)
    found = in_silence(sound, seconds, around)
    assert found.size <= max(size, round(seconds * SAMPLE_RATE))
    assert found.dtype == np.float32
    said = np.flatnonzero(found)
    assert said.size == size, "nothing is lost or said twice"
    if size:
        before, after = int(said[0]), found.size - 1 - int(said[-1])
        assert after <= before <= round(around * SAMPLE_RATE)
        assert said[-1] - said[0] + 1 == size


@settings(deadline=None, max_examples=60)
@given(st.sampled_from(RATES), st.lists(st.integers(0, 5_000), max_size=12))
def test_frames_hold_all_the_sound_however_it_is_cut(rate, lengths):
    resampler = Resampler(rate)
    frames = [frame for length in lengths for frame in resampler.push(np.zeros(length, np.float32))]
    frames += resampler.push(np.zeros(0, np.float32), last=True)
    seconds = sum(lengths) / rate
    assert all(frame.samples.shape == (FRAME_SAMPLES,) for frame in frames)
    assert [frame.time for frame in frames] == pytest.approx([FRAME_SECONDS * (n + 1) for n in range(len(frames))])
    assert seconds - 0.001 <= len(frames) * FRAME_SECONDS <= seconds + 2 * FRAME_SECONDS


@settings(deadline=None, max_examples=20)
@given(st.sampled_from(RATES), st.lists(st.integers(1, 9_000), min_size=1, max_size=8))
def test_how_a_stream_is_cut_changes_no_sample(rate, cuts):
    sound = np.random.default_rng(1).normal(0, 0.1, sum(cuts)).astype(np.float32)
    whole, parts = Resampler(rate), Resampler(rate)
    at_once = [frame.samples for frame in whole.push(sound, last=True)]
    bit_by_bit = []
    for part in np.split(sound, np.cumsum(cuts)[:-1]):
        bit_by_bit += [frame.samples for frame in parts.push(part)]
    bit_by_bit += [frame.samples for frame in parts.push(np.zeros(0, np.float32), last=True)]
    assert len(at_once) == len(bit_by_bit)
    if at_once:
        assert np.concatenate(at_once) == pytest.approx(np.concatenate(bit_by_bit), abs=1e-5)


@pytest.mark.parametrize("rate", RATES)
def test_a_tone_keeps_its_pitch(rate):
    moments = np.arange(rate * 2) / rate
    frames = Resampler(rate).push((0.5 * np.sin(2 * np.pi * 440 * moments)).astype(np.float32), last=True)
    sound = np.concatenate([frame.samples for frame in frames])[:SAMPLE_RATE]
    peak = np.argmax(np.abs(np.fft.rfft(sound)))
    assert peak * SAMPLE_RATE / sound.size == pytest.approx(440, abs=1)


def test_a_gap_moves_all_later_frames():
    resampler = Resampler(SAMPLE_RATE)
    (before,) = resampler.push(np.zeros(FRAME_SAMPLES, np.float32))
    resampler.shift(5.0)
    (after,) = resampler.push(np.zeros(FRAME_SAMPLES, np.float32))
    assert after.time - before.time == pytest.approx(5.0 + FRAME_SECONDS)
    assert resampler.time == after.time
