"""How alike two words are, in spelling and in sound, and whether one may be taken for the other.

The sound is Metaphone (L. Philips, "Hanging on the Metaphone", Computer Language 7(12), 1990), which keeps consonants
only. The limits were chosen on misheard and absent names: docs/decisions/language-names.md.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import jellyfish
from rapidfuzz import fuzz

from intent_engine.language.slots.name_words import is_identifier
from intent_engine.language.words.homophones import homophones

__all__ = ["Likeness", "compare", "likeness", "sound"]

SPELLING_WEIGHT = 0.6
"""Share of spelling in the score; the rest is sound."""
SAME_SOUND = 0.65
"""Least spelling of a word with the same consonants, in a name of several words: "duck" for "dock", "bae" for "bay"."""
SAME_SOUND_ALONE = 0.82
"""The same for a name of one word, which has no other words to vouch for it: "coach" is not "couch"."""
OTHER_SOUND = 0.9
"""Least spelling of a word whose consonants differ: "parking" is not "packing", "changing" not "charging"."""
OTHER_SOUND_LETTERS = 8
"""Least length of such a word: "closest" is not "closet"."""
ALONE_LETTERS = 4
"""Least length of a name of one word that may be misheard at all: "beer" is not "bar"."""
IDENTIFIER_WEIGHT = 2
"""Letters that an identifier counts for: "bae three" is "bay 3" because the three is right."""
JOINED = 0.02
"""Taken from the score of words that were split or joined otherwise."""


class Likeness(NamedTuple):
    """How alike two words or names are."""

    score: float
    """0 to 1."""
    passes: bool
    """Whether one may be taken for the other."""


_SAME = Likeness(1.0, True)
_NOT = Likeness(0.0, False)


@lru_cache(maxsize=65536)
def sound(word: str) -> str:
    """A phonetic key; the word itself if it has none. All vowels that begin a word are one ("isle", "aisle")."""
    key: str = jellyfish.metaphone(word) or word
    return "A" + key[1:] if key[0] in "AEIOU" else key


@lru_cache(maxsize=65536)
def likeness(said: str, known: str, alone: bool = False) -> Likeness:
    """How alike two words are.

    Args:
        said: the word heard.
        known: the word of the name.
        alone: whether it is the whole name.
    """
    if said == known:
        return _SAME
    if is_identifier(said) or is_identifier(known):
        return _NOT
    if known in homophones("en").get(said, ()):
        return _SAME
    spelling = fuzz.ratio(said, known) / 100
    key, known_key = sound(said), sound(known)
    if key[0] != known_key[0] and said[0] != known[0]:
        # A first sound is seldom misheard: "fridge" is not "bridge".
        score = SPELLING_WEIGHT * spelling + (1 - SPELLING_WEIGHT) * fuzz.ratio(key, known_key) / 200
        return Likeness(score, False)
    score = SPELLING_WEIGHT * spelling + (1 - SPELLING_WEIGHT) * fuzz.ratio(key, known_key) / 100
    if alone and len(known) < ALONE_LETTERS:
        return Likeness(score, False)
    if said in (known + "s", known + "es") or known in (said + "s", said + "es"):
        return Likeness(max(score, 0.95), True)
    if key == known_key:
        return Likeness(score, spelling >= (SAME_SOUND_ALONE if alone else SAME_SOUND))
    shorter = min(len(said), len(known))
    return Likeness(score, spelling >= OTHER_SOUND and shorter >= OTHER_SOUND_LETTERS)


def compare(said: Sequence[str], known: Sequence[str]) -> Likeness:
    """How alike two names are whose identifiers are the same, in the same order.

    The words between the identifiers are compared one by one, or joined where their number differs ("bed room").
    """
    total = weight = float(IDENTIFIER_WEIGHT * sum(map(is_identifier, known)))
    passes = True
    alone = len(known) == 1
    for mine, theirs in zip(_segments(said), _segments(known), strict=False):
        if len(mine) == len(theirs):
            pairs = list(zip(mine, theirs, strict=True))
            lost = 0.0
        else:
            pairs = [("".join(mine), "".join(theirs))]
            lost = JOINED
        for one, other in pairs:
            if not one or not other:
                return _NOT
            # Words put together can only vouch for each other if they are spelled nearly the same.
            found = likeness(one, other, alone or lost > 0)
            size = max(len(other), 2)
            total += (found.score - lost) * size
            weight += size
            passes = passes and found.passes
    return Likeness(total / weight, passes) if weight else _NOT


def _segments(words: Sequence[str]) -> list[list[str]]:
    segments: list[list[str]] = [[]]
    for word in words:
        if is_identifier(word):
            segments.append([])
        else:
            segments[-1].append(word)
    return segments
