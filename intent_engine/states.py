"""States of a robot that somebody named, beside those that the grammar asks for."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from intent_engine.errors import Problem
from intent_engine.hints import did_you_mean

__all__ = ["unknown_states"]

_SHOWN = 100
"""Characters of a name that are shown."""


def unknown_states(names: Iterable[str], known: Collection[str], named_by: str) -> list[Problem]:
    """A problem for each name that changes nothing: it is misspelled, or of another grammar.

    Args:
        names: as somebody wrote them.
        known: those of the grammar, as ``IntentEngine.states`` has them.
        named_by: what they were given with, as that person knows it: ``--state``.
    """
    there = sorted(known)
    return [
        Problem(
            f"{named_by}: no intent of the grammar asks for a state {name[:_SHOWN]!r}",
            hint=did_you_mean(name[:_SHOWN], there) or f"there is {', '.join(there)}",
        )
        for name in dict.fromkeys(names)
        if name not in known
    ]
