"""One other way to put what was said."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance

__all__ = ["Rewording", "of_things_listed"]


def of_things_listed(reading: Reading) -> bool:
    """Whether a command is about things that a grammar knows: any other words may be said of anything ("could I have a
    word")."""
    return not reading.free_words


def _any_reading(reading: Reading) -> bool:
    return True


@dataclass(frozen=True, slots=True)
class Rewording:
    """Other words, and whether what a grammar reads them as is what was said."""

    said: Utterance
    is_meant: Callable[[Reading], bool] = _any_reading
    """Of the reading of the command."""

    def then(self, other: Rewording) -> Rewording:
        """These words put otherwise once more."""
        first, second = self.is_meant, other.is_meant
        return Rewording(other.said, lambda reading: first(reading) and second(reading))
