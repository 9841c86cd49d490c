"""What a robot is told to stop doing: the verb of "stop stirring the soup", as a command would have it."""

from __future__ import annotations

from collections.abc import Iterator

__all__ = ["verbs"]

_ENDING = "ing"
_VOWELS = "aeiouy"


def verbs(word: str, language: str) -> Iterator[str]:
    """The verbs of which a word may be the form that stands behind "stop": "stirring" is of "stir", "driving" of
    "drive", "tying" of "tie". Some of them are none; other languages than English have no such form here."""
    stem = word.removesuffix(_ENDING)
    if language != "en" or stem == word or len(stem) < 2 or not any(letter in _VOWELS for letter in stem):
        return
    yield stem
    yield stem + "e"
    if len(stem) > 2 and stem[-1] == stem[-2]:
        yield stem[:-1]
    if stem.endswith("y"):
        yield stem[:-1] + "ie"
