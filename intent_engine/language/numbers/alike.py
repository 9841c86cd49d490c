"""Numbers that are taken for each other by ear: "fifteen" and "fifty", "zwei" and "drei"."""

from __future__ import annotations

from intent_engine.language.numbers.units import units

__all__ = ["alike"]


def alike(word: str, language: str | None = None) -> tuple[str, ...]:
    """The numbers that sound like one; none, where the word is no such number.

    Args:
        word: as texts are compared.
        language: two letters; None: English.
    """
    table = units(language or "en")
    return table.alike.get(word, ()) if table is not None else ()
