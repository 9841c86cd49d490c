"""Words before what tells whose something is, or of what."""

from __future__ import annotations

from functools import cache

from intent_engine.language.numbers.units import units
from intent_engine.language.words.thing_words import thing_words

__all__ = ["of_words"]


@cache
def of_words(language: str) -> frozenset[str]:
    """Those of a language, also where they are one with an article: "de", "du"."""
    table, contracted = units(language), thing_words(language).contracted
    own = frozenset(table.words.get("of", ()) if table is not None else ())
    return own.union(one for one, (of, _) in contracted.items() if of in own)
