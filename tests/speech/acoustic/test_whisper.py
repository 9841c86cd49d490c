"""Free decoding: a CUDA device that is lost is replaced by the processor."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

from intent_engine.speech.acoustic.whisper import WhisperRecognizer


class _LostDevice:
    """A model on a device that has no memory left."""

    is_multilingual = False

    def encode(self, *_args: object, **_options: object) -> object:
        raise RuntimeError("CUDA failed with error out of memory")


@pytest.fixture
def recognizer() -> WhisperRecognizer:
    made = WhisperRecognizer("tiny.en", device="cpu")
    yield made
    made.close()


def test_a_lost_cuda_device_is_told_once_and_the_processor_goes_on(recognizer, go_forward) -> None:
    recognizer._model.model, recognizer.device = _LostDevice(), "cuda"
    with pytest.warns(RuntimeWarning, match="out of memory.*on the CPU from now on"):
        heard = recognizer.transcribe(go_forward)
    assert recognizer.device == "cpu"
    assert "forward" in heard.text.lower()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert "forward" in recognizer.transcribe(go_forward).text.lower()


def test_an_error_on_the_processor_is_an_error(recognizer) -> None:
    recognizer._model.model = _LostDevice()
    with pytest.raises(RuntimeError, match="out of memory"):
        recognizer.transcribe(np.zeros(16_000, np.float32))


def test_cuda_is_asked_for_and_not_there(go_forward) -> None:
    import ctranslate2

    if ctranslate2.get_cuda_device_count():
        pytest.skip("there is a CUDA device")
    with pytest.warns(RuntimeWarning, match="CUDA cannot be used"):
        made = WhisperRecognizer("tiny.en", device="cuda")
    assert made.device == "cpu"
    assert "forward" in made.transcribe(go_forward).text.lower()
