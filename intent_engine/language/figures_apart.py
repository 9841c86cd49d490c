"""Two numbers that are written as one: "6.30", "6:30" and "630" for "six thirty", as recognisers write times."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from intent_engine.language.adjacent_numbers import may_hold
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance

__all__ = ["are_apart", "figures_apart"]

_TOGETHER = re.compile(r"(\d{1,2})\.?(\d\d)")


def figures_apart(said: Utterance) -> Utterance | None:
    """An utterance with such figures as two words; None: it has none."""
    words: list[str] = []
    breaks: list[bool] = []
    for word, pause in zip(said.words, said.breaks, strict=True):
        parts = _parts(word)
        words += parts
        breaks += [pause, *[False] * (len(parts) - 1)]
    return Utterance(words, breaks) if len(words) > len(said.words) else None


def are_apart(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    """Whether each such figure of an utterance is the values of two slots in a row, the first of which cannot hold it
    as it is written: else nobody knows that two numbers were meant."""
    found = {
        (" ".join(reading.words[one.start : one.end]), " ".join(reading.words[other.start : other.end])): one
        for reading in readings
        for one, other in pairwise(reading.slots)
        if one.end == other.start and one.slot.type == other.slot.type == "number"
    }
    figures = [word for word in said.words if len(_parts(word)) > 1]
    slots = [found.get((first, second)) for first, second in map(_parts, figures)]
    return all(
        slot is not None and not may_hold(slot, [word], language) for word, slot in zip(figures, slots, strict=True)
    )


def _parts(word: str) -> list[str]:
    found = _TOGETHER.fullmatch(word)
    return [found[1], found[2]] if found is not None else [word]
