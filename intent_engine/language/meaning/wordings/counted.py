"""Where amounts stand among words, so that none is taken apart: "two and a half hours", "a couple of degrees"."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from intent_engine.language.numbers.units import LONGEST, Units, units
from intent_engine.language.slots.adjacent_numbers import is_number

__all__ = ["amounts", "counts_one", "in_an_amount"]


def counts_one(article: str, after: str, language: str) -> bool:
    """Whether an article with the word after it begins an amount: "*a* quarter turn", "*a* meter", "*a* couple of"."""
    table = units(language)
    if table is None or article not in table.words["one"]:
        return False
    return after in _parts(language) or (after,) in table.names or is_number(after, language)


def amounts(words: Sequence[str], language: str) -> list[range]:
    """The places of the words of each number with its unit, if it has one, as far as it can be told without what is
    counted."""
    table = units(language)
    found: list[range] = []
    at = 0
    while at < len(words):
        end = _number_end(words, at, language)
        if table is not None and (end > at or _has_a_part(words, at, table)):
            end = _unit_end(words, end, table)
        if end > at:
            found.append(range(at, end))
        at = max(end, at + 1)
    return found


def in_an_amount(words: Sequence[str], language: str) -> set[int]:
    """The places of words that stand within an amount, and do not begin it: "one *and a half*"."""
    return {at for amount in amounts(words, language) for at in amount[1:]}


def _number_end(words: Sequence[str], at: int, language: str) -> int:
    """Where the number ends that begins at a place; there, if none does."""
    end, joins, parts = at, _joining(language), _parts(language)
    while end < len(words):
        after, next_after, *_ = (*words[end + 1 : end + 3], "", "")
        goes_on = end == at or words[end - 1] in joins or words[end - 1] in parts  # "lift three a meter" has two
        counted = _counts(words[end], language) or (goes_on and counts_one(words[end], after, language))
        joined = not counted and end > at and words[end] in joins
        if not (counted or (joined and (_counts(after, language) or counts_one(after, next_after, language)))):
            break
        end += 1
    return end


def _counts(word: str, language: str) -> bool:
    if word in _parts(language):
        return True
    table = units(language)
    article = table is not None and word in table.words["one"]  # "ein" is a number, too
    return not article and is_number(word, language)


@cache
def _parts(language: str) -> frozenset[str]:
    """Words that count behind an article: "half", "couple"."""
    table = units(language)
    return table.parts_of_one | table.words.get("two", frozenset()) if table is not None else frozenset()


@cache
def _joining(language: str) -> frozenset[str]:
    """Words within a number: "two *and* a half", "two *point* five"."""
    table = units(language)
    return table.words["and"] | table.words.get("point", frozenset()) if table is not None else frozenset()


def _has_a_part(words: Sequence[str], at: int, table: Units) -> bool:
    """Whether one unit, of which no number is said, and a part of one stand at a place: "hora y media"."""
    joined, *after = (*words[at + 1 : at + 4], "")
    return (words[at],) in table.names and joined in table.words["and"] and not table.parts_of_one.isdisjoint(after[:2])


def _unit_end(words: Sequence[str], at: int, table: Units) -> int:
    """Where the unit ends that stands behind a number, with a part of one behind that: "an hour and a half"."""
    at += at < len(words) - 1 and words[at] in table.words["of"]  # "a couple of degrees"
    most = min(LONGEST, len(words) - at)
    length = next((some for some in range(most, 0, -1) if tuple(words[at : at + some]) in table.names), 0)
    end = at + length
    per, time = (*words[end : end + 2], "", "")[:2]
    if length and per in table.words["per"] and (time,) in table.names:
        return end + 2  # "a meter per second"
    joined, one, part = (*words[end : end + 3], "", "", "")[:3]
    if not length or joined not in table.words["and"]:
        return end
    if one in table.parts_of_one and part not in table.words["one"]:
        return end + 2  # "hora y media", but not of "meters and half a meter"
    return end + 3 if one in table.words["one"] and part in table.parts_of_one else end
