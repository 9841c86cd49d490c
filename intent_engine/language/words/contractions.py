"""Words that are shortened beside others: "what's" of "what is", "d'un mètre" of "de un mètre".

Without their apostrophe, as all words are here. None that denies is among them: "don't" is for
:mod:`~intent_engine.language.meaning.negations.negation`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

__all__ = ["OTHER_WORDS", "PRONOUNS", "apart", "begins_to_tell", "in_full", "shortened", "shortened_in", "together"]

PRONOUNS = frozenset(
    ("i", "you", "he", "she", "it", "we", "they", "that", "there", "this", "who", "what", "where", "when", "how")
)
"""Words that are shortened with what follows them wherever they stand: "that's"."""
_ENDINGS: Mapping[str, tuple[str, frozenset[str] | None]] = {
    "is": ("s", None),
    "am": ("m", frozenset(("i",))),
    "are": ("re", PRONOUNS - {"i", "it"}),
    "have": ("ve", PRONOUNS),
    "will": ("ll", PRONOUNS),
    "would": ("d", PRONOUNS),
}
"""What is left of the second word, and the words after which it is so; None: any ("the music's too loud")."""
OTHER_WORDS = frozenset(("hell", "shed", "shell", "wed", "well", "were"))
"""Other words, which are said as often. With its apostrophe "we'll" is no "well"."""
_SHORTENED = re.compile(r"\b([a-z]+)['’ʼ`](" + "|".join(ending for ending, _ in _ENDINGS.values()) + r")\b")
_NOUNS = frozenset(("id", "ill"))
"""Other words that may stand in the name of a thing: "the id card"."""

_ELIDED: Mapping[str, Mapping[str, tuple[str, ...]]] = {
    "fr": {
        "c": ("ce",), "d": ("de",), "j": ("je",), "jusqu": ("jusque",), "l": ("le", "la"), "m": ("me",), "qu": ("que",),
        "s": ("se",), "t": ("te",),
    },
    "it": {
        "all": ("allo", "alla"), "c": ("ci",), "d": ("di",), "dall": ("dallo", "dalla"), "dell": ("dello", "della"),
        "l": ("lo", "la"), "m": ("mi",), "nell": ("nello", "nella"), "quell": ("quello", "quella"),
        "sull": ("sullo", "sulla"), "t": ("ti",), "un": ("una",), "v": ("vi",),
    },
}  # fmt: skip
"""What is written before a vowel, and the words that it may be there."""


def in_full(word: str, language: str) -> tuple[str, ...]:
    """The words that a normalised one may be short for before a vowel: "le" and "la" of "l"."""
    return _ELIDED.get(language, {}).get(word, ())


def together(first: str, second: str) -> str | None:
    """Two normalised words as the one that is said for them: "whats"; None: there is none."""
    ending, after = _ENDINGS.get(second, ("", frozenset()))
    whole = first + ending
    return whole if ending and (after is None or first in after) and whole not in OTHER_WORDS else None


def apart(word: str) -> Iterator[tuple[str, str]]:
    """The two words for which a normalised one may be said: "what", "is" of "whats"."""
    for second, (ending, _) in _ENDINGS.items():
        first = word.removesuffix(ending)
        if together(first, second) == word:
            yield first, second


def shortened(pronouns: Iterable[str]) -> frozenset[str]:
    """What is said for one of these English pronouns and a verb, and for nothing else: "im", "hes", "its"."""
    both = (together(pronoun, verb) for pronoun in PRONOUNS.intersection(pronouns) for verb in _ENDINGS)
    return frozenset(word for word in both if word is not None) - _NOUNS


def shortened_in(text: str) -> dict[str, tuple[str, str]]:
    """The words of an English text that are short for two, and without their apostrophe others: "were" where "we're" is
    written, with "we" and "are"."""
    written = {"".join(match.groups()): match for match in _SHORTENED.finditer(text.lower())}
    endings = {ending: word for word, (ending, _) in _ENDINGS.items()}
    return {word: (match[1], endings[match[2]]) for word, match in written.items() if word in OTHER_WORDS}


def begins_to_tell(word: str) -> bool:
    """Whether a normalised English word may be a pronoun and its verb, with which a sentence begins: "its hot"."""
    return any(first in PRONOUNS for first, _ in apart(word))
