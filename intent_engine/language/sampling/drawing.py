"""What a sampler draws, and where its decisions come from."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

from intent_engine.language.grammar import Slot

__all__ = ["Choices", "Piece", "RandomChoices", "one", "pick"]

T = TypeVar("T")


class Choices(Protocol):
    """Where a sampler's decisions come from."""

    def below(self, count: int) -> int:
        """A whole number from 0 to ``count - 1``; 0 is the shortest way to go on."""
        ...


class RandomChoices:
    """Decisions of a seeded generator: the same seed gives the same sentences."""

    def __init__(self, seed: int) -> None:
        self._random = random.Random(seed)

    def below(self, count: int) -> int:
        return self._random.randrange(count)


@dataclass(frozen=True, slots=True)
class Piece:
    """Words that belong together: one word of a template, or all that was said for a slot."""

    text: str
    label: str | None = None
    """Name under which the slot's value is given; None for words of the template."""
    slot: Slot | None = None
    value: Any = None
    """Of the slot: SI number, :class:`Relative`, name, text or boolean."""


def one(choices: Choices, count: int) -> int:
    """A decision, where there is one."""
    return choices.below(count) if count > 1 else 0


def pick(choices: Choices, items: Sequence[T]) -> T:
    """One of some items."""
    return items[one(choices, len(items))]
