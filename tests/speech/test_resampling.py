"""Sound at another rate: all of it, in its place, and at once."""

from __future__ import annotations

import numpy as np
import pytest
import soxr
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.speech.audio import MAX_RATE
from intent_engine.speech.resampling import TAPS, StreamResampler

TO = 16_000
RATES = st.one_of(st.sampled_from([8_000, 11_025, 22_050, 44_100, 48_000, 96_000]), st.integers(1_000, MAX_RATE))


def noise(size: int, seed: int = 0) -> np.ndarray:
    return np.random.default_rng(seed).normal(0, 0.1, size).astype(np.float32)


def run(rate: int, parts: list[np.ndarray]) -> np.ndarray:
    stream = StreamResampler(rate, TO)
    return np.concatenate([*(stream.push(part) for part in parts), stream.push(np.zeros(0, np.float32), last=True)])


@settings(deadline=None, max_examples=40)
@given(RATES, st.lists(st.integers(1, 4_000), min_size=1, max_size=20))
def test_little_more_than_half_a_filter_is_held_back(rate, sizes):
    """2 ms at 16 kHz and above; soxr's stream holds back 20 to 60, and up to 120."""
    stream = StreamResampler(rate, TO)
    pushed = given_back = 0
    for size in sizes:
        given_back += stream.push(noise(size)).size
        pushed += size
        lag = pushed / rate - given_back / TO
        taps = lag * min(rate, TO)
        assert taps <= (TAPS // 2 + 2 if pushed * min(rate, TO) / rate > TAPS + 1 else TAPS + 1)


@settings(deadline=None, max_examples=40)
@given(RATES, st.lists(st.integers(0, 4_000), max_size=8))
def test_all_of_the_sound_comes_out_however_it_is_cut(rate, sizes):
    sound = noise(sum(sizes))
    whole = run(rate, [sound])
    assert whole.size == -(-sound.size * TO // rate)
    np.testing.assert_allclose(run(rate, np.split(sound, np.cumsum(sizes))), whole, atol=1e-6)


@pytest.mark.parametrize("rate", [8_000, 11_025, 22_050, 44_100, 48_000, 96_000])
def test_what_can_be_heard_is_as_soxr_gives_it(rate):
    """Of a whole signal, with a filter of some hundred taps; up to 7 kHz, or to what a lower rate has."""
    moments = np.arange(rate) / rate
    tones = [tone for tone in (100, 440, 1_000, 3_000, 5_000, 7_000) if tone < 0.4375 * rate]
    sound = sum(0.1 * np.sin(2 * np.pi * tone * moments) for tone in tones).astype(np.float32)
    ours, theirs = run(rate, [sound]), soxr.resample(sound, rate, TO)
    inner = slice(1_000, 15_000)
    np.testing.assert_allclose(ours[inner], theirs[inner], atol=0.002)


@pytest.mark.parametrize("tone", [9_000, 10_000, 15_000])
def test_what_is_too_high_for_the_lower_rate_does_not_come_back_as_something_else(tone):
    moments = np.arange(48_000) / 48_000
    sound = run(48_000, [(0.5 * np.sin(2 * np.pi * tone * moments)).astype(np.float32)])
    assert np.abs(sound[1_000:15_000]).max() < 0.5e-4, "80 dB less"
