"""How many words fit into a sound."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.hypotheses.pace import too_few, too_many

LOOP = "turn right for forty five degrees and " * 5


def sound(seconds: float) -> np.ndarray:
    return np.zeros(round(seconds * SAMPLE_RATE), np.float32)


@pytest.mark.parametrize(
    ("said", "seconds", "few", "many"),
    [
        ("right", 1.95, True, False),
        ("drive ahead fifty feet", 1.95, False, False),
        ("stop", 0.9, False, False),
        ("go", 1.2, False, False),
        ("go back to the living room", 1.5, False, False),
        ("turn left ninety degrees", 4.5, True, False),
        (LOOP, 2.66, False, True),
    ],
)
def test_words_and_their_time(said, seconds, few, many):
    assert too_few(said.split(), sound(seconds)) is few
    assert too_many(said.split(), sound(seconds)) is many


@given(st.lists(st.text("abc", min_size=1, max_size=9), max_size=30), st.floats(0.0, 20.0))
def test_no_words_are_both(words, seconds):
    assert not (too_few(words, sound(seconds)) and too_many(words, sound(seconds)))


@given(st.lists(st.text("abc", min_size=1, max_size=9), max_size=30), st.floats(0.0, 20.0), st.text("abc", max_size=9))
def test_a_word_more_is_never_fewer(words, seconds, more):
    assert too_many([*words, more], sound(seconds)) or not too_many(words, sound(seconds))
    assert too_few(words, sound(seconds)) or not too_few([*words, more], sound(seconds))
