"""A decode is bounded by the length of the sound."""

from __future__ import annotations

import numpy as np
import pytest

from intent_engine.errors import WeightsError
from intent_engine.speech.acoustic.whisper import TOKENS_PER_SECOND, WhisperRecognizer


@pytest.fixture(scope="module")
def recognizer() -> WhisperRecognizer:
    try:
        return WhisperRecognizer("tiny.en")
    except WeightsError as error:
        pytest.skip(str(error))


def test_nobody_speaks_faster_than_this(recognizer):
    seconds = 1.0
    for seed in range(3):
        noise = np.random.default_rng(seed).normal(0, 0.05, int(seconds * 16_000)).astype(np.float32)
        tokens, _ = recognizer.greedy_tokens(recognizer.encode(noise))
        assert len(tokens) <= TOKENS_PER_SECOND * seconds + 10
