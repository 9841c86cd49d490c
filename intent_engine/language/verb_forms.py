"""Verbs as they tell of something: "opens", "activated", "pausing". A command says "open"."""

from __future__ import annotations

from collections.abc import Iterator

__all__ = ["told_forms_of"]

ENDINGS = (("s", ""), ("es", ""), ("ies", "y"), ("d", ""), ("ed", ""), ("ied", "y"), ("ing", ""), ("ing", "e"))
"""How English verbs end that tell of something, and how the verb itself ends there."""
LEAST_LETTERS = 2


def told_forms_of(word: str, language: str) -> Iterator[str]:
    """The verbs of which a word may be such a form: of "stopped" these are "stopp", which is none, and "stop". None in
    other languages than English."""
    for ending, own in ENDINGS if language == "en" else ():
        stem = word.removesuffix(ending)
        if stem == word or len(stem) < LEAST_LETTERS:
            continue
        yield stem + own
        if ending in ("ed", "ing") and not own and stem[-1] == stem[-2]:
            yield stem[:-1]
