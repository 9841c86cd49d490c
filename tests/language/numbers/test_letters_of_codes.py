"""A letter beside a number is a part of a code."""

from __future__ import annotations

import pytest

from intent_engine.language.numbers.letters import is_letter_of_a_code


@pytest.mark.parametrize(
    ("text", "letters", "language"),
    [
        ("scan bay b five", "b", "en"),
        ("scan bay b 5", "b", "en"),
        ("room twelve a", "a", "en"),
        ("take a b c", "", "en"),
        ("room two o five", "", "en"),
        ("call me at five", "", "en"),
        ("hole kiste c drei", "c", "de"),
        ("geh zu a", "", "de"),
    ],
)
def test_letters_beside_numbers(text: str, letters: str, language: str) -> None:
    words = text.split()
    assert "".join(words[at] for at in range(len(words)) if is_letter_of_a_code(words, at, language)) == letters
