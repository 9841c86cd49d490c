"""Fillers that are the name of something: a list or a map may have an "ER", or a "well"."""

from __future__ import annotations

from intent_engine.language.matcher import Matcher
from intent_engine.language.templates.spellings import spellings

__all__ = ["CalledSo"]

_MOST_SPELLINGS = 200
"""Ways to say one value that are looked at."""


class CalledSo:
    """Tells what the lists and the map of a grammar call something."""

    def __init__(self, matcher: Matcher) -> None:
        self._grammar, self._locations = matcher.grammar, matcher.locations
        types = {slot.type for slot in self._grammar.slots.values()}
        self._places = "location" in types and self._locations is not None

    def __call__(self, words: tuple[str, ...]) -> bool:
        """Whether words are such a name, and all of it. It looks at all of them, so it is not to be asked often."""
        for slot in self._grammar.slots.values():
            nodes = [node for _, node in slot.values] if slot.type == "choice" else []
            if any(words in spellings(node, self._grammar.phrases, _MOST_SPELLINGS) for node in nodes):
                return True
        return (
            self._places and self._locations is not None and any(words == name for name, _ in self._locations.names())
        )
