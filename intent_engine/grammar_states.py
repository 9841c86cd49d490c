"""States of a robot: those that somebody named, beside those of the grammar, and what words mean in any of them."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import TYPE_CHECKING

from intent_engine.errors import Problem
from intent_engine.hints import did_you_mean
from intent_engine.interpretation import Interpretation, Status

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = ["meant_in_some_state", "unknown_states"]

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


def meant_in_some_state(
    engine: IntentEngine, text: str, language: str | None = None, *, spoken: bool = False
) -> Interpretation:
    """What a text means to a robot in a state in which it means something, if there is one; else in none.

    For who asks what may have been said, and not what is done: a sentence sounds the same in every state. What only a
    robot that moves takes for a stop is none here. The arguments are those of ``IntentEngine.parse``; it was heard.
    """
    found = engine.parse(text, language=language, spoken=spoken, heard=True)
    if found.status is Status.ACCEPTED:
        return found
    required = {intent.requires for grammar in engine.grammars for intent in grammar.intents.values()} - {frozenset()}
    # All of them at once for several commands in one sentence.
    for state in sorted(required, key=sorted) + ([frozenset().union(*required)] if len(required) > 1 else []):
        other = engine.parse(text, state=state, language=language, spoken=spoken, heard=True)
        if other.status is Status.ACCEPTED and not other.stops:
            return other
    return found
