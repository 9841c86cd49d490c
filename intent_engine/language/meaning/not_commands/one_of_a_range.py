"""Two numbers of which one is meant: "go forward two to four meters"."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from intent_engine.language.quantities import evaluate

__all__ = ["one_of_a_range"]

_MOST = 6
"""Words of a number."""


def one_of_a_range(
    words: Sequence[str], ranging: Collection[str], language: str, accepts: Callable[[list[str]], bool]
) -> str:
    """Why words are no command that would be one with the second number alone; empty: they would not.

    Args:
        words: what was said.
        ranging: what stands between two such numbers: "to", "or".
        language: two letters.
        accepts: whether words are a command.
    """
    for place in range(1, len(words) - 1):
        if words[place] not in ranging or not (end := _end_of_number(words, place + 1, language)):
            continue
        for start in range(place - 1, max(place - _MOST, 0) - 1, -1):
            if evaluate(words[start:place], "number", language) is None:
                break
            if accepts([*words[:start], *words[place + 1 :]]):
                return f"{' '.join(words[start:end])!r} leaves open which number is meant; say one"
    return ""


def _end_of_number(words: Sequence[str], start: int, language: str) -> int:
    """Where the number ends that begins at a place; 0: none does."""
    ends = range(min(len(words), start + _MOST), start, -1)
    return next((end for end in ends if evaluate(words[start:end], "number", language) is not None), 0)
