"""Two numbers that are written or said as one: "6.30", "6:30" and "630" for "six thirty", as recognisers write times,
"six oh five", "3 and 4", which figures join as those of "100 and 4", and the "3:00" of whoever says three."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from intent_engine.language.numbers.english_words import DIGITS, SMALL, ZERO
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.quantities import evaluate
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import may_hold
from intent_engine.language.utterance import Utterance

__all__ = ["are_apart", "are_hours", "figures_apart", "figures_joined", "hours_alone"]

_TOGETHER = re.compile(r"(\d{1,2})\.?(\d\d)")
_THREE_FIGURES = "100"
_FIGURES = re.compile(r"\d{1,2}")
_FULL_HOUR = "00"
_HOURS = 24


@dataclass(frozen=True, slots=True)
class _Two:
    """Words that may be two numbers."""

    place: int
    """Of the first of them."""
    said: tuple[str, ...]
    first: str
    """The last word of the first number,"""
    second: str
    """and the second one, in two figures."""


def figures_apart(said: Utterance, language: str) -> Utterance | None:
    """An utterance with such figures as two words; None: it has none."""
    words, breaks = list(said.words), list(said.breaks)
    for two in reversed(list(_twos(said, language))):
        end = two.place + len(two.said)
        words[two.place : end] = [two.first, two.second]
        breaks[two.place : end] = [said.breaks[two.place], False]
    return Utterance(words, breaks) if words != said.words else None


def figures_joined(said: Utterance, language: str) -> Utterance | None:
    """An utterance with the figures of two whole numbers around an "and" in words, in which they are two ("rows three
    and four") unless they are one number ("100 and 4"); None: it has none."""
    words, breaks = list(said.words), list(said.breaks)
    for place in range(len(words) - 2, 0, -1) if language == "en" else ():
        around = (words[place - 1], words[place + 1])
        if words[place] != "and" or not all(map(_is_whole, around)) or not any(map(str.isdigit, around)):
            continue
        if evaluate(words[place - 1 : place + 2], "number", language) is not None:
            continue
        for at in (place + 1, place - 1):
            spelled = in_words([words[at]])
            words[at : at + 1] = spelled
            breaks[at : at + 1] = [breaks[at], *[False] * (len(spelled) - 1)]
    return Utterance(words, breaks) if words != said.words else None


def hours_alone(said: Utterance, language: str) -> Utterance | None:
    """An utterance with its full hours without the minutes: "3:00" as "3"; None: it has none."""
    kept = [place for place in range(len(said)) if not _is_full(said, place)]
    if len(kept) == len(said):
        return None
    return Utterance([said.words[place] for place in kept], [said.breaks[place] for place in kept])


def are_hours(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    """Whether every number that was taken for a full hour is the value of a slot that takes no more than hours."""
    hours = {
        reading.words[slot.start]
        for reading in readings
        for slot in reading.slots
        if slot.end == slot.start + 1 and slot.slot.type == "number" and slot.slot.beyond(_HOURS + 1) is not None
    }
    return hours.issuperset(said.words[place - 1] for place in range(len(said)) if _is_full(said, place))


def _is_full(said: Utterance, place: int) -> bool:
    """Whether at a place stand the minutes of a full hour."""
    if said.words[place] != _FULL_HOUR or not place or said.breaks[place]:
        return False
    hour = said.words[place - 1]
    return _FIGURES.fullmatch(hour) is not None and int(hour) <= _HOURS


def _is_whole(word: str) -> bool:
    return word.isdigit() or word in SMALL


def are_apart(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    """Whether each such figure of an utterance is the values of two slots in a row, the first of which cannot hold it
    as it is written: else nobody knows that two numbers were meant. Nor where one of them takes three figures: of
    "page 1123 times" they may be 11 and 23, or 112 and 3."""
    found = {
        (reading.words[one.end - 1], " ".join(reading.words[other.start : other.end])): (one, other, reading.words)
        for reading in readings
        for one, other in pairwise(reading.slots)
        if one.end == other.start and one.slot.type == other.slot.type == "number"
    }
    for two in _twos(said, language):
        if (two.first, two.second) not in found:
            return False
        slot, other, words = found[two.first, two.second]
        if may_hold(slot, [*words[slot.start : slot.end - 1], *two.said], language):
            return False
        if any(may_hold(one, [_THREE_FIGURES], language) for one in (slot, other)):
            return False
    return True


def _twos(said: Utterance, language: str) -> Iterator[_Two]:
    words = said.words
    for place, word in enumerate(words):
        if (found := _TOGETHER.fullmatch(word)) is not None:
            yield _Two(place, (word,), found[1], found[2])
        elif language == "en" and (digit := _after_a_zero(said, place)):
            yield _Two(place, tuple(words[place : place + 3]), word, digit)


def _after_a_zero(said: Utterance, place: int) -> str:
    """The "05" of "six oh five", of which the first word stands at a place, in one breath; else nothing."""
    first, zero, digit = (*said.words[place : place + 3], "", "", "")[:3]
    if zero not in ZERO or any(said.breaks[place + 1 : place + 3]):
        return ""
    if first not in SMALL and _FIGURES.fullmatch(first) is None:
        return ""
    figure = str(DIGITS.get(digit, digit))
    return f"0{figure}" if len(figure) == 1 and figure.isdigit() else ""
