"""Free decoding: loops folded, and a CUDA device that is lost replaced by the processor."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.speech.whisper import LONG_SENTENCE, WhisperRecognizer, fold_loop

words = st.sampled_from(["go", "stop", "left", "two", "meters", "the", "kitchen"])


@pytest.mark.parametrize(
    ("written", "once"),
    [
        ("Go to the kitchen. Go to the kitchen. Go to the kitchen.", "Go to the kitchen."),
        ("grasp the bottle now, grasp the bottle now, gr", "grasp the bottle now,"),
        ("stop stop stop st", "stop"),
        (
            "Give me a large latte with milk and sugar. Give me a large latte wi",
            "Give me a large latte with milk and sugar.",
        ),
        ("Go forward two meters slowly. Go forward two", "Go forward two meters slowly. Go forward two"),
        ("Right. Right.", "Right."),
        ("Turn left. Turn left.", "Turn left."),
        ("turn left, turn left", "turn left, turn left"),
        ("go to the lab and go to the dock", "go to the lab and go to the dock"),
        ("", ""),
    ],
)
def test_a_loop_is_what_was_said_once(written: str, once: str) -> None:
    assert fold_loop(written) == once


@given(st.lists(words, min_size=LONG_SENTENCE, max_size=7), st.integers(3, 6), st.data())
def test_however_often_it_went_round_and_wherever_it_was_cut(said: list[str], times: int, data: st.DataObject) -> None:
    whole = " ".join([" ".join(said)] * times)
    cut = data.draw(st.integers(0, len(" ".join(said)) - 1))
    folded = fold_loop((whole + " " + " ".join(said)[:cut]).strip())
    # "go go go go" is a shorter loop than the sentence it was drawn as.
    assert whole.startswith(folded)
    assert len(folded.split()) <= len(said)


@given(st.lists(words, max_size=12))
def test_folding_again_changes_nothing_and_adds_no_word(said: list[str]) -> None:
    once = fold_loop(" ".join(said))
    assert " ".join(said).startswith(once)
    assert fold_loop(once) in (once, fold_loop(fold_loop(once)))


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
