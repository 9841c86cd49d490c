"""How numbers may be written otherwise than a grammar has them: "1 2" as "12", "every minute" as "every one minute"."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

from intent_engine.language.reading import Reading
from intent_engine.language.slots.called_by_number import is_called_so, without_number
from intent_engine.language.slots.counted_of_which import are_of_which, without_of_which
from intent_engine.language.slots.counted_with_of import is_counted_with_of, without_of
from intent_engine.language.slots.every_unit import every_one, is_every_one
from intent_engine.language.slots.half_behind import half_before, is_half_of_it
from intent_engine.language.slots.written_shares import are_shares, shares_in_words
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.figures_apart import (
    are_apart,
    are_hours,
    figures_apart,
    figures_joined,
    hours_alone,
)

__all__ = ["NUMBERS", "NumbersRule"]

_Otherwise = Callable[[Utterance, str], Utterance | None]
_IsMeant = Callable[[Utterance, Sequence[Reading], str], bool]


def _always(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    return True


NumbersRule: TypeAlias = tuple[_Otherwise, _IsMeant]
"""How numbers may be written, and whether that is what its readings took them for."""

NUMBERS: tuple[NumbersRule, ...] = (
    (figures_apart, are_apart),
    (figures_joined, _always),
    (hours_alone, are_hours),
    (every_one, is_every_one),
    (without_number, is_called_so),
    (without_of, is_counted_with_of),
    (without_of_which, are_of_which),
    (half_before, is_half_of_it),
    (shares_in_words, are_shares),
)
"""How numbers may be written otherwise, each with whether that is what its readings took them for."""
