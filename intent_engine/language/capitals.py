"""The words that the author of a grammar or a map writes with a capital: names, and German nouns."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Any

__all__ = ["capitals", "texts_in"]

_WORD = re.compile(r"[^\W\d_]+")
_REFERENCE = re.compile(r"{[^{}]*}")
"""Phrase or slot in a template."""


def capitals(texts: Iterable[str], *, sentences: bool = False) -> dict[str, str]:
    """Words with a capital, by the same small.

    Args:
        texts: as they are written.
        sentences: whether the first word of a text may have one because it is the first.
    """
    found: dict[str, str] = {}
    for text in texts:
        for word in _WORD.finditer(_REFERENCE.sub(" ", text)):
            if word[0] != (small := word[0].lower()) and not (sentences and word.start() == 0):
                found.setdefault(small, word[0])
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
