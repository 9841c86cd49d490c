"""Our own decoder of Whisper beside CTranslate2's, with real weights and real sound."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.speech.acoustic.whisper_decoder import WhisperDecoder
from intent_engine.speech.acoustic.whisper_graphs import whisper_shape
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.steered import SteeredWhisper
from intent_engine.speech.weights import find_weights


@pytest.fixture(scope="module")
def encoded(whisper, spoken):
    return whisper.encode(spoken)


@pytest.fixture(scope="module")
def decoder():
    return WhisperDecoder(find_weights("tiny.en").path)


@pytest.fixture(scope="module")
def precise(engine):
    """The same model in floats, decoded by CTranslate2."""
    recognizer = SteeredWhisper(engine, compute_type="float32")
    assert recognizer._decoder is None
    yield recognizer
    recognizer.close()


@pytest.mark.parametrize(
    "text", ["Go forward two meters.", "Go forward 10 meters.", "Never go to the kitchen.", "Thank you very much."]
)
def test_it_thinks_what_ctranslate2_thinks(precise, whisper, encoded, text):
    """It is as near to the model in floats as CTranslate2 with bytes is: 0.12 nats in the mean, and 0.14."""
    tokens = tuple(whisper.tokenizer("en").encode(" " + text))
    wanted = dict(precise.next_pieces(encoded, [tokens], 1, "en"))
    found = dict(whisper.next_pieces(encoded, [tokens], 1, "en"))
    for place in range(len(tokens)):  # of the whole CTranslate2 says nothing
        row, exact = found[tokens[:place]], wanted[tokens[:place]]
        likely = exact > -7
        assert np.abs(row - exact)[likely].mean() < 0.4
        assert np.abs(row - exact)[likely].max() < 1.2


@pytest.mark.parametrize(("begin", "end"), [(1.2, 3.6), (1.0, 3.0), (1.5, 3.6)])
def test_it_writes_what_ctranslate2_writes(precise, whisper, go_forward, begin, end):
    sound = go_forward[int(begin * SAMPLE_RATE) : int(end * SAMPLE_RATE)]
    text, score, looped = precise.greedy(precise.encode(sound), "en")
    found, own, _ = whisper.greedy(whisper.encode(sound), "en")
    assert found == text
    assert looped or own == pytest.approx(score, abs=0.15)


@given(st.integers(0, 2**32 - 1), st.booleans(), st.sampled_from([0.0, 20.0, 80.0]))
def test_what_is_never_written_leaves_its_chances_to_the_rest(decoder, seed, first, note):
    """Even where all but nothing is left, as in music."""
    row = np.random.default_rng(seed).normal(0.0, 3.0, len(decoder.small)).astype(np.float32)
    row[decoder.never[0]] += note
    row -= np.logaddexp.reduce(row)
    able = decoder.able(row, first=first)
    assert np.exp(able).sum() == pytest.approx(1.0, abs=1e-3)
    assert np.isneginf(able[decoder.never]).all()
    assert np.isneginf(able[decoder.never_first]).all() is np.bool_(first)
    possible = np.isfinite(able)
    np.testing.assert_allclose(np.diff(able[possible]), np.diff(row[possible]), atol=1e-3)


def test_other_variables_are_refused():
    with pytest.raises(ValueError, match="no decoder of Whisper: 'embeddings/weight'"):
        whisper_shape({})
    small = {"embeddings/weight": np.zeros((4, 2), np.int8), "position_encodings/encodings": np.zeros((3, 2))}
    with pytest.raises(ValueError, match="the weights are quantised"):
        whisper_shape({**small, "num_heads": np.array(1)})


def test_a_file_of_another_form_is_left_to_ctranslate2(engine, monkeypatch, encoded):
    """Weights in bytes, say, as others convert them."""

    def quantised(folder):
        raise ValueError("the weights are quantised")

    monkeypatch.setattr("intent_engine.speech.acoustic.whisper_decoder.WhisperDecoder", quantised)
    recognizer = SteeredWhisper(engine)
    assert recognizer._decoder is None
    said, other = recognizer.score(encoded, ["Go forward two meters", "Go to the kitchen"], "en")
    assert said > other
    recognizer.close()
