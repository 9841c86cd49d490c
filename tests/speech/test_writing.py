"""Words as Whisper writes them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.utterance import Utterance
from intent_engine.speech.writing import _WRITTEN, written


@pytest.mark.parametrize(
    ("words", "language", "text"),
    [
        ("thats enough", "en", "That's enough"),
        ("id like you to go", "en", "I'd like you to go"),
        ("can i stop", None, "Can I stop"),
        ("fahre in die kueche", "de", "Fahre in die kueche"),
        ("das ist im flur", "de", "Das ist im flur"),
    ],
)
def test_signs_and_capitals(words, language, text):
    assert written(words.split(), language) == text


def test_within_a_sentence():
    assert written(["stop"], "en", sentence=False) == "stop"
    assert written(["i"], "en", sentence=False) == "I"


@given(st.lists(st.sampled_from([*_WRITTEN, "go", "left", "kitchen", "two"]), min_size=1))
def test_it_is_read_as_the_same_words(words):
    assert Utterance.of(written(words, "en"), "en").words == words
