"""Words that were said twice, as people do who begin again: "go to the, to the kitchen"."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from intent_engine.language.utterance import Utterance

__all__ = ["said_once"]

MOST = 3
"""Words that are begun again at once."""


def said_once(said: Utterance, may_be: Callable[[int, int], bool]) -> Utterance | None:
    """An utterance with what was said twice in it said once; None: there is nothing, or it was said more than twice.

    Args:
        said: the utterance.
        may_be: whether the words from a place to another may be said twice by who means them once.
    """
    words = said.words
    kept = list(range(len(words)))
    place = 0
    while place < len(words):
        length = next((count for count in range(MOST, 0, -1) if _again(words, place, count)), 0)
        if not length:
            place += 1
            continue
        if _again(words, place + length, length) or not may_be(place, place + length):
            return None
        kept = [at for at in kept if not place <= at < place + length]
        place += 2 * length
    if len(kept) == len(words):
        return None
    return Utterance([words[at] for at in kept], [said.breaks[at] for at in kept])


def _again(words: Sequence[str], place: int, count: int) -> bool:
    """Whether so many words at a place are said again right after."""
    after = words[place + count : place + 2 * count]
    return len(after) == count and list(words[place : place + count]) == list(after)
