"""Numbers that are taken for each other by ear."""

from __future__ import annotations

import pytest

from intent_engine.language.numbers.alike import alike


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


@pytest.mark.parametrize("word", ["thirteen", "thirty", "forty", "ninety"])
def test_whoever_sounds_like_another_is_sounded_like(word):
    assert all(word in alike(other, "en") for other in alike(word, "en"))
