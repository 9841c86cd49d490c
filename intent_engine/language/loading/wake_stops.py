"""Wake words that would take away a stop: "stop, go on" would be a command to go on."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import Operators
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["wake_that_stops"]


def wake_that_stops(words: Sequence[str], operators: Operators) -> tuple[str, str] | None:
    """What is wrong with a wake word in which a robot is told to stop, and what to do; None: nothing.

    Args:
        words: of the wake word, normalised.
        operators: of the grammar that it wakes.
    """
    found = PhraseSet(operators.stop).find(words)
    if found is None:
        return None
    at, length = found
    said, stop = " ".join(words), " ".join(words[at : at + length])
    return f"the wake word {said!r} tells the robot to stop ({stop!r})", "give it a name that no command has: robot"
