"""How Whisper writes what the grammar knows as plain words: "that's", not "thats". A sentence is only as likely as it
looks, so it is asked about in the model's own writing."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.numbers.spelled import in_digits

__all__ = ["spellings", "written"]

_WRITTEN = {
    "i": "I",
    "id": "I'd",
    "im": "I'm",
    "ive": "I've",
    "lets": "let's",
    "thats": "that's",
    "its": "it's",
    "whats": "what's",
    "wheres": "where's",
    "theres": "there's",
    "youre": "you're",
    "youll": "you'll",
    "oclock": "o'clock",
}
"""English words that lose a sign when they are normalised."""


def written(words: Sequence[str], language: str | None, *, sentence: bool = True) -> str:
    """Words as one text, with the signs and capitals of a sentence.

    Args:
        words: normalised.
        language: of the words.
        sentence: whether they begin one.
    """
    text = " ".join(_WRITTEN.get(word, word) for word in words) if language in (None, "en") else " ".join(words)
    return text[:1].upper() + text[1:] if sentence else text


def spellings(words: Sequence[str], language: str | None) -> list[tuple[str, ...]]:
    """Words as they may be spelled: with numbers in words, and in digits."""
    numbers = (tuple(words), in_digits(words)) if language in (None, "en") else (tuple(words),)
    return list(dict.fromkeys(numbers))
