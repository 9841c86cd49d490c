"""A part of the whole in figures: "dim to 1/2", where a slot that holds a percentage has "half"."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from intent_engine.language.numbers.english_words import ORDINAL_UNITS
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance

__all__ = ["are_shares", "shares_in_words"]

_WRITTEN = re.compile(r"([1-9])/([2-9]|1[0-9])")
_PARTS: dict[int, str] = {bottom: part for part, bottom in ORDINAL_UNITS.items()} | {4: "quarter"}


def shares_in_words(said: Utterance, language: str) -> Utterance | None:
    """An English utterance with such parts in words; None: it has none."""
    other = said
    for place, words in reversed(list(_shares(said, language))):
        other = other.with_other(place, place + 1, Utterance.in_one_breath(words))
    return other if other.words != said.words else None


def are_shares(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    """Whether each is a percentage, and all that is said of it: "1/2 percent" is no half."""
    held = [
        reading.words[slot.start : slot.end]
        for reading in readings
        for slot in reading.slots
        if slot.slot.type == "percent"
    ]
    return all(tuple(words) in held for _, words in _shares(said, language))


def _shares(said: Utterance, language: str) -> Iterator[tuple[int, list[str]]]:
    for place, word in enumerate(said.words if language == "en" else ()):
        written = _WRITTEN.fullmatch(word)
        top, bottom = map(int, written.groups()) if written is not None else (1, 1)
        if top >= bottom:
            continue
        if bottom == 2:
            yield place, ["half"]
        elif bottom in _PARTS:
            yield place, ["a", _PARTS[bottom]] if top == 1 else [*in_words([str(top)]), f"{_PARTS[bottom]}s"]
