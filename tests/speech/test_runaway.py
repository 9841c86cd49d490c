"""Sound that sends the model round in circles costs no more than other sound."""

from __future__ import annotations

import numpy as np
import pytest

from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.whisper import TOKENS_PER_SECOND


@pytest.fixture(scope="module")
def clipped(go_forward):
    """So loud that a hinted model says the same words over and over."""
    return np.clip(20 * go_forward[int(1.2 * SAMPLE_RATE) : int(3.6 * SAMPLE_RATE)], -1, 1).astype(np.float32)


@pytest.mark.parametrize("hint", ["", "forward, two meters, left, right, kitchen", "forward, kitchen, " * 100])
def test_no_more_tokens_than_anybody_speaks(whisper, clipped, hint):
    encoded = whisper.encode(clipped)
    tokens, _ = whisper.greedy_tokens(encoded, "en", hint=hint)
    assert len(tokens) <= TOKENS_PER_SECOND * encoded.seconds + 10


def test_a_hint_leaves_room_for_a_whole_sentence(whisper, go_forward):
    words, _, _ = whisper.greedy(whisper.encode(go_forward), "en", hint="forward, kitchen, " * 100)
    assert words.lower().replace("two", "2").startswith("go forward 2 meters")


def test_a_looped_hint_is_not_scored(whisper, clipped, monkeypatch):
    scored: list[str] = []
    score = whisper.score

    def counted(encoded, texts, language=None):
        scored.extend(texts)
        return score(encoded, texts, language)

    monkeypatch.setattr(whisper, "score", counted)
    whisper.transcribe(clipped)
    assert max(len(text.split()) for text in scored) <= 12, "the command has four words"
