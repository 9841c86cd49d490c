"""What kind of file was given in the place of another: a grammar, a map, a robot file and tests are all YAML."""

from __future__ import annotations

from typing import Any

from intent_engine.errors import Problem

__all__ = ["given_for"]

_MARKS = {
    "test file": (frozenset({"tests"}), "intent-engine test runs it, if its name ends in .intents.yaml"),
    "grammar": (frozenset({"intents"}), "give it as grammar"),
    "map": (frozenset({"locations", "waypoints"}), "give it as locations"),
    "robot file": (frozenset({"limits", "rates", "capabilities", "simulation", "footprint"}), "give it as robot"),
}
"""Kind -> keys that no later kind has, and where such a file belongs."""
_OF_OTHERS = {
    "context of Rhino": frozenset({"context"}),
    "file of Rasa": frozenset({"nlu", "stories"}),
}
"""What other engines write in YAML -> keys that a grammar has not."""


def given_for(kind: str, data: Any, file: str) -> Problem | None:
    """The problem of a file that is of another kind; None: it has a key of its own, or of none.

    Args:
        kind: what it was given as: ``grammar``, ``map`` or ``robot file``.
        data: what stands in it.
        file: its name.
    """
    if not isinstance(data, dict) or not _MARKS[kind][0].isdisjoint(data):
        return None
    for other, (marks, hint) in _MARKS.items():
        if not marks.isdisjoint(data):
            return Problem(f"is a {other}, not a {kind}", file, hint=hint)
    for other, marks in _OF_OTHERS.items():
        if kind == "grammar" and not marks.isdisjoint(data):
            return Problem(f"is a {other}, not a grammar", file, hint="docs/migrating.md shows what its parts are here")
    return None
