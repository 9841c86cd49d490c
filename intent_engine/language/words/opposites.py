"""Words of which one means the opposite of the other: whoever hears "off" does nothing that says "on".

They often sound alike ("on" and "off", "clockwise" and "counterclockwise"), stand at the same place of a sentence, and
of no other words does it matter as much which of them was said.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from functools import cache

from intent_engine.language.loading.language_words import default_opposites

__all__ = ["opposed"]


@cache
def _opposites(language: str) -> Mapping[str, Collection[str]]:
    table: dict[str, set[str]] = {}
    for one, other in default_opposites(language):
        table.setdefault(one, set()).add(other)
        table.setdefault(other, set()).add(one)
    return table


def opposed(word: str, language: str | None = None) -> Collection[str]:
    """The words that mean the opposite of a word; none, where that is not known.

    Args:
        word: as texts are compared.
        language: two letters; None: English.
    """
    return _opposites(language or "en").get(word, ())
