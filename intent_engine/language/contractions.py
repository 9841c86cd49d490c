"""English words that are mostly said as one: "what is" and "what's", "I would" and "I'd".

Without its apostrophe, as all words are here. None that denies is among them: "don't" is for
:mod:`~intent_engine.language.meaning.negation`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

__all__ = ["apart", "together"]

_PRONOUNS = frozenset(
    ("i", "you", "he", "she", "it", "we", "they", "that", "there", "this", "who", "what", "where", "when", "how")
)
_ENDINGS: Mapping[str, tuple[str, frozenset[str] | None]] = {
    "is": ("s", None),
    "am": ("m", frozenset(("i",))),
    "are": ("re", _PRONOUNS - {"i", "it"}),
    "have": ("ve", _PRONOUNS),
    "will": ("ll", _PRONOUNS),
    "would": ("d", _PRONOUNS),
}
"""What is left of the second word, and the words after which it is so; None: any ("the music's too loud")."""
_OTHERS = frozenset(("hell", "shed", "shell", "wed", "well", "were"))
"""Other words, which are said as often."""


def together(first: str, second: str) -> str | None:
    """Two normalised words as the one that is said for them: "whats"; None: there is none."""
    ending, after = _ENDINGS.get(second, ("", frozenset()))
    whole = first + ending
    return whole if ending and (after is None or first in after) and whole not in _OTHERS else None


def apart(word: str) -> Iterator[tuple[str, str]]:
    """The two words for which a normalised one may be said: "what", "is" of "whats"."""
    for second, (ending, _) in _ENDINGS.items():
        first = word.removesuffix(ending)
        if together(first, second) == word:
            yield first, second
