"""Articles that begin an amount: "*a* quarter turn", "*a* meter"."""

from __future__ import annotations

from intent_engine.language.numbers.units import units
from intent_engine.language.slots.adjacent_numbers import is_number

__all__ = ["counts_one"]


def counts_one(article: str, after: str, language: str) -> bool:
    """Whether an article with the word after it begins an amount."""
    table = units(language)
    if table is None or article not in table.words["one"]:
        return False
    return after in table.parts_of_one or (after,) in table.names or is_number(after, language)
