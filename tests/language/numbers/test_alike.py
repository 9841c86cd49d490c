"""Numbers that are taken for each other by ear."""

from __future__ import annotations

import pytest

from intent_engine.language.numbers.alike import alike
from intent_engine.language.numbers.english_words import TEENS, TENS


@pytest.mark.parametrize(
    ("word", "language", "others"),
    [
        ("fifteen", "en", ("fifty",)),
        ("fifty", None, ("fifteen",)),
        ("one", "en", ()),
        ("kitchen", "en", ()),
        ("zwei", "de", ("drei",)),
        ("drei", "de", ("zwei", "dreißig")),
        ("fifteen", "de", ()),
        ("fifteen", "xx", ()),
    ],
)
def test_what_sounds_like_a_number_of_a_language(word, language, others):
    assert sorted(alike(word, language)) == sorted(others)


@pytest.mark.parametrize(("teen", "value"), TEENS.items())
def test_a_teen_and_its_tens_sound_alike(teen, value):
    tens = [word for word, other in TENS.items() if other == (value - 10) * 10 and alike(word)]
    assert list(alike(teen)) == tens
    assert all(alike(word) == (teen,) for word in tens)
    assert bool(tens) == (value >= 13)
