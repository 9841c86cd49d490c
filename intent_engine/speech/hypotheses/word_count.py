"""For how many words a sentence counts, so that those of other lengths can be compared with it."""

from __future__ import annotations

import itertools
from functools import lru_cache

from intent_engine.language.numbers.english_words import NUMBER_WORDS

__all__ = ["WORD", "word_count"]

WORD = 2.0
"""nats that a word more may cost: without it "right" would be likelier than a "return to the starting point" of which
only half was heard well."""


@lru_cache(maxsize=4096)
def word_count(words: tuple[str, ...]) -> int:
    """Words, a number of several as one: "8120" is said in five, "a hundred" in as many as "eight hundred"."""
    number = [False] * (len(words) + 1)
    for place in reversed(range(len(words))):
        joins = words[place] == "a" or (words[place] == "and" and place > 0 and words[place - 1] in NUMBER_WORDS)
        number[place] = words[place] in NUMBER_WORDS or (joins and number[place + 1])
    return sum(1 for before, here in itertools.pairwise([False, *number[:-1]]) if not (before and here))
