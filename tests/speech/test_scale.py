"""Sound at a wrong scale is told, and no sound at its own scale is."""

from __future__ import annotations

import numpy as np
import pytest
import soxr
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.errors import AudioError
from intent_engine.speech.scale import check_scale, faint, holds_16_bits

RATE = 16_000


def speechlike(peak: float, silence: float, seed: int) -> np.ndarray:
    """A second that is loud and quiet by turns as speech is, with a part of silence at its beginning."""
    chance = np.random.default_rng(seed)
    sound = chance.laplace(size=RATE) * np.abs(np.sin(np.arange(RATE) / 1_300))
    sound[: int(silence * RATE)] = 0.0
    return sound * peak / np.abs(sound).max()


@settings(deadline=None, max_examples=60)
@given(
    st.floats(300, 32_767),
    st.floats(0, 0.6),
    st.integers(0, 99),
    st.sampled_from([8_000, 16_000, 44_100]),
    st.sampled_from([np.float32, np.float64]),
)
def test_integers_are_told_however_they_became_floats(peak, silence, seed, rate, dtype):
    sound = soxr.resample(np.round(speechlike(peak, silence, seed)), RATE, rate).astype(dtype)
    with pytest.raises(AudioError, match=r"it holds floats .*, where sound is from -1 to 1\n    divide"):
        check_scale(sound, "it holds", "divide")


@settings(deadline=None, max_examples=60)
@given(st.floats(0, 31), st.floats(0, 0.6), st.integers(0, 99), st.sampled_from([np.float32, np.float64]))
def test_sound_is_not_even_if_it_is_much_too_loud(peak, silence, seed, dtype):
    check_scale(speechlike(peak, silence, seed).astype(dtype), "it holds", "divide")


@given(st.integers(0, 700), st.floats(allow_nan=True, allow_infinity=True, width=32))
def test_nor_what_a_broken_driver_sends_between_good_samples(count, garbage):
    sound = speechlike(0.5, 0.1, 1).astype(np.float32)
    sound[:count] = garbage
    check_scale(sound, "it holds", "divide")


@settings(deadline=None, max_examples=60)
@given(st.floats(1_024, 32_767), st.floats(0, 0.6), st.integers(0, 99))
def test_integers_of_16_bits_in_32_are_told_and_those_of_32_are_not(peak, silence, seed):
    sound = np.round(speechlike(peak, silence, seed)).astype(np.int32)
    assert faint(sound)
    assert holds_16_bits(sound)
    assert not holds_16_bits(sound << 16)
    assert not holds_16_bits(sound // 256 * 256), "24 bits, however quiet"
    assert not faint(sound << 16)
    assert not faint(sound.astype(np.int16))


@pytest.mark.parametrize(
    "silence", [np.zeros(99, np.int32), np.tile([-512, 511], 99).astype(np.int32), np.zeros(0, "i4")]
)
def test_silence_and_its_dither_are_no_integers_of_16_bits(silence):
    assert faint(silence)
    assert not holds_16_bits(silence)
