"""What a person probably meant who wrote something unknown."""

from __future__ import annotations

from collections.abc import Iterable

__all__ = ["did_you_mean"]


def did_you_mean(word: str, known: Iterable[str], alike: float = 60) -> str | None:
    """A hint naming the known word that is nearest, or None if none is near: ``alike`` percent of its letters."""
    from rapidfuzz import fuzz, process

    names = list(known)
    cased = {name.lower(): name for name in reversed(names)}
    if word.lower() in cased:
        return f"did you mean {cased[word.lower()]!r}?"
    found = process.extractOne(word, names, scorer=fuzz.ratio, score_cutoff=alike)
    return f"did you mean {found[0]!r}?" if found else None
