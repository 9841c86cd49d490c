"""Sound that sends the model round in circles costs no more than other sound."""

from __future__ import annotations

import numpy as np
import pytest

from intent_engine.speech.acoustic.whisper import TOKENS_PER_SECOND


@pytest.fixture(scope="module")
def clipped(spoken):
    """So loud that the model may say the same words over and over."""
    return np.clip(20 * spoken, -1, 1).astype(np.float32)


def test_no_more_tokens_than_anybody_speaks(whisper, clipped):
    encoded = whisper.encode(clipped)
    tokens, _ = whisper.greedy_tokens(encoded, "en")
    assert len(tokens) <= TOKENS_PER_SECOND * encoded.seconds + 10


def test_a_loop_is_not_scored(whisper, clipped, monkeypatch):
    scored: list[str] = []
    score = whisper.score

    def counted(encoded, texts, language=None):
        scored.extend(texts)
        return score(encoded, texts, language)

    monkeypatch.setattr(whisper, "score", counted)
    whisper.transcribe(clipped)
    assert max((len(text.split()) for text in scored), default=0) <= 12, "the command has four words"
