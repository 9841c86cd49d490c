"""The filters of Whisper's spectrogram: the same numbers, and no threads of OpenBLAS."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np
import pytest
from faster_whisper.feature_extractor import FeatureExtractor
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from intent_engine.speech.acoustic.mel import MelFilters
from intent_engine.speech.audio import SAMPLE_RATE


@pytest.mark.parametrize("bands", [80, 128], ids=["tiny to large-v2", "large-v3"])
@pytest.mark.parametrize("seconds", [0.1, 2.5, 28.0])
def test_a_spectrogram_is_what_faster_whisper_computes(bands, seconds, demo):
    sound = demo[: int(seconds * SAMPLE_RATE)]
    theirs = FeatureExtractor(feature_size=bands)
    ours = FeatureExtractor(feature_size=bands)
    ours.mel_filters = MelFilters(ours.mel_filters)
    np.testing.assert_allclose(ours(sound), theirs(sound), atol=1e-5)


@given(
    arrays.arrays(np.float32, st.tuples(st.integers(1, 6), st.integers(1, 8)), elements=st.floats(0, 1, width=16)),
    st.integers(1, 5),
    st.integers(0, 99),
)
def test_it_is_a_product_of_matrices(weights, frames, seed):
    """Whatever each band hears: nothing, all, or frequencies far from each other."""
    magnitudes = np.random.default_rng(seed).random((weights.shape[1], frames), np.float32)
    expected = np.einsum("ij,jk->ik", weights.astype(np.float64), magnitudes)
    np.testing.assert_allclose(MelFilters(weights) @ magnitudes, expected, rtol=1e-5, atol=1e-5)


SHARE_OF_OTHERS = """
import time
import numpy as np
from intent_engine.speech.acoustic.whisper import WhisperRecognizer

(np.ones((400, 400), np.float32) @ np.ones((400, 400), np.float32))  # OpenBLAS makes its threads
spectrogram = WhisperRecognizer()._model.feature_extractor
sound = np.zeros(40_000, np.float32)
for _ in range(30):  # for as long as they spin after the product above
    spectrogram(sound)
all_threads, this_one = time.process_time(), time.thread_time()
for _ in range(300):
    spectrogram(sound)
all_threads, this_one = time.process_time() - all_threads, time.thread_time() - this_one
print((all_threads - this_one) / all_threads)
"""
"""Of the processor's time that spectrograms take."""


def test_one_thread_works_and_none_waits_for_it_by_spinning():
    """NumPy was loaded before the recogniser here, as in any program that embeds it."""
    environment = {name: value for name, value in os.environ.items() if name != "OPENBLAS_NUM_THREADS"}
    done = subprocess.run(
        [sys.executable, "-c", SHARE_OF_OTHERS], env=environment, capture_output=True, text=True, check=True
    )
    assert float(done.stdout) < 0.2
