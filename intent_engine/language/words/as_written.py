"""The words that the author of a grammar or a map does not write small and plain: names, "Peter's", German nouns."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Any

from intent_engine.language.normalize import ELISION

__all__ = ["as_written", "texts_in"]

_WORD = re.compile(r"[^\W\d_]+(?:['’][^\W\d_]+)*")
_APOSTROPHES = frozenset("'’")
_REFERENCE = re.compile(r"{[^{}]*}")
"""Phrase or slot in a template."""


def as_written(texts: Iterable[str], *, sentences: bool = False) -> dict[str, str]:
    """Words with a capital or an apostrophe, by the same small and plain.

    Args:
        texts: as they are written.
        sentences: whether the first word of a text may have a capital because it is the first.
    """
    found: dict[str, str] = {}
    for text in texts:
        if text.islower() and _APOSTROPHES.isdisjoint(text):
            continue  # as most are
        for match in _WORD.finditer(ELISION.sub(" ", _REFERENCE.sub(" ", text))):
            word = match[0].replace("’", "'")
            if sentences and match.start() == 0:
                word = word.lower()
            plain = word.lower().replace("'", "")
            if word != plain:
                found.setdefault(plain, word)
    return found


def texts_in(value: Any) -> Iterator[str]:
    """Every text in what was read of a file."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for key, item in value.items():
            yield from (*texts_in(key), *texts_in(item))
    elif isinstance(value, list):
        for item in value:
            yield from texts_in(item)
