"""Many regular expressions, asked at once which of them fit a text: what that costs does not grow with their number."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any

__all__ = ["RegexSet"]

_ALWAYS = "(?s:.*)"
"""Fits everything. RE2 gives a set up, and says that none of it fits, where that takes more memory than it may have;
then this one is not among what fits either."""


class RegexSet:
    """Regular expressions that were compiled, in their order.

    Args:
        patterns: as ``re2.compile`` gives them.
    """

    def __init__(self, patterns: Sequence[Any]) -> None:
        self._patterns = tuple(patterns)

    def fitting(self, text: str) -> Iterable[int]:
        """The places of at least those that fit all of a text, in order. Where that cannot be told at once it is all of
        them: ask each."""
        places = range(len(self._patterns))
        if self._set is None:
            return places
        found: list[int] = self._set.Match(text) or []
        return sorted(found)[:-1] if len(places) in found else places

    @cached_property
    def _set(self) -> Any:
        """RE2's own, made when somebody first asks; None: of so few it is not worth it, or they are too much for it."""
        import re2

        if len(self._patterns) < 2:
            return None
        options = re2.Options()
        options.log_errors = False
        found = re2.Set.FullMatchSet(options)
        try:
            for pattern in self._patterns:
                found.Add(pattern.pattern)
            found.Add(_ALWAYS)
            found.Compile()
        except re2.error:
            return None
        return found
