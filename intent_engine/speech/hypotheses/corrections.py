"""Sentences that take something back, like some words that were heard: "go to the lounge, no, the dark" may have been
"go to the lounge, no, the dock".

The automaton of a grammar has none of them, since a correction stands for whatever it can take the place of: a name, a
number, a direction, or the whole command. So what was heard after the "no" is put behind each beginning of the command
before it, and sentences of the grammar that are like that, and begin so too, say what may have been meant.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Protocol

from intent_engine.language.quantities import evaluate
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.speech.hypotheses.evidence import letters_apart

__all__ = ["Near", "as_meant", "corrected_like", "no_between"]

FIRST = 2
"""Commands at most that the words before the "no" are taken for,"""
UNLIKE = 0.34
"""share of their letters that may differ: other talk has a "rather" in it too;"""
EACH = 4
"""and sentences for each beginning of one, with what came after it."""
BROKEN_OFF = 3
"""Words at most with which what was broken off is corrected, before both go on: "the red" of "the blue, no, the red
line"."""
MOST = 8
"""Sentences at most in all."""


class Near(Protocol):
    """Sentences of a grammar that begin in a certain way, and go on like some words, the likest first."""

    def __call__(self, words: tuple[str, ...], begin: tuple[str, ...], /) -> Sequence[tuple[str, ...]]: ...


def as_meant(heard: Sequence[str], corrections: PhraseSet, alikes: Mapping[str, Sequence[str]]) -> list[str]:
    """Words, with those that a recogniser writes for a correction as that.

    Args:
        heard: the words.
        corrections: phrases that take back what was said: ``("no",)``, ``("i", "mean")``.
        alikes: words that a recogniser writes for others: ``{"know": ["no"]}``.
    """
    return [next((word for word in alikes.get(one, ()) if corrections.at([word], 0)), one) for one in heard]


def no_between(heard: Sequence[str], corrections: PhraseSet, language: str | None) -> list[str]:
    """English words with a "no" between two numbers that are not one: of "fifty, no, sixty" Whisper makes "50-060"."""
    if language not in (None, "en") or not corrections.at(["no"], 0):
        return list(heard)
    numbers = [is_number(word, "en") for word in heard]
    for begin, here in enumerate(numbers):
        if here and not (begin and numbers[begin - 1]):
            end = next((at for at in range(begin, len(heard)) if not numbers[at]), len(heard))
            place = _second_number(heard[begin:end])
            if place:
                return [*heard[: begin + place], "no", *heard[begin + place :]]
    return list(heard)


def _second_number(words: Sequence[str]) -> int:
    """Where a second number begins in words of numbers; 0: they are one, or end in none."""
    if evaluate(words, "number") is not None:  # "zero point two", though "zero point" is none
        return 0
    halves = ((at, evaluate(words[:at], "number"), evaluate(words[at:], "number")) for at in range(1, len(words)))
    return next((at for at, first, second in halves if first is not None and second is not None), 0)


def corrected_like(heard: Sequence[str], corrections: PhraseSet, near: Near) -> list[tuple[str, ...]]:
    """Commands with a correction that are like the words heard, the likest first; not all of them are understood.

    Args:
        heard: the words, corrections :func:`as_meant`.
        corrections: phrases that take back what was said.
        near: looks for the sentences of the grammar.
    """
    first = corrections.find(heard, 1)
    if first is None or sum(first) >= len(heard):
        return []
    at, length = first
    before, correction, after = tuple(heard[:at]), tuple(heard[at : at + length]), tuple(heard[at + length :])
    letters = sum(map(len, before))
    commands = [one for one in near(before, ())[:FIRST] if letters_apart(one, before) <= UNLIKE * letters]
    whole = [(command, instead) for command in commands for instead in _in_place(command, after, near)]
    meant = list(dict.fromkeys(instead for _, instead in whole))
    said = (*_broken_off(before, after, meant, near), *whole)
    found = dict.fromkeys((*begun, *correction, *instead) for begun, instead in said)
    return sorted(found, key=lambda words: letters_apart(words, heard))[:MOST]


def _broken_off(
    before: tuple[str, ...], after: tuple[str, ...], meant: Sequence[tuple[str, ...]], near: Near
) -> Iterator[tuple[tuple[str, ...], tuple[str, ...]]]:
    """What may have been broken off, and said after the correction, as it was heard or was ``meant``: two sentences
    that end alike, as "thirty" and "forty microliters"."""
    for count in range(1, min(BROKEN_OFF, len(after) - 1) + 1):
        end = after[count:]
        for sentence in near((*before, *end), ())[:FIRST]:
            begun, its_end = sentence[: -len(end)], sentence[-len(end) :]
            if begun and letters_apart(its_end, end) <= UNLIKE * sum(map(len, end)):
                yield begun, (*after[:count], *its_end)
                yield from ((begun, one) for one in meant if len(one) > len(end) and one[-len(end) :] == its_end)


def _in_place(command: tuple[str, ...], after: tuple[str, ...], near: Near) -> Iterator[tuple[str, ...]]:
    """What may have been said after the correction: as it was heard, and what would go on from a beginning of the
    command."""
    yield after
    for kept in range(len(command)):
        for sentence in near(after, command[:kept])[:EACH]:
            if len(sentence) > kept:
                yield sentence[kept:]
