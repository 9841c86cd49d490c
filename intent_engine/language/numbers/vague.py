"""Amounts that say no number: "a few feet". What they would be nobody knows, so they are nothing but asked about."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache

from intent_engine.interpretation import Status
from intent_engine.language.numbers.units import units
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["lacks_a_number", "vague_length"]

_ANY_NUMBER = "3"


@cache
def _phrases(language: str) -> PhraseSet:
    table = units(language)
    return PhraseSet(phrase.split() for phrase in (table.words.get("vague", ()) if table is not None else ()))


def vague_length(words: Sequence[str], at: int, language: str) -> int:
    """Words of such an amount that begins at a place; 0: none does."""
    return _phrases(language).at(words, at)


def _said_exactly(said: Utterance, language: str) -> tuple[str, Utterance] | None:
    """The first such amount in an utterance, and the utterance with a number for each; None: there is none."""
    phrases = _phrases(language)
    if not phrases.may_stand_in(said.words):
        return None
    words: list[str] = []
    breaks: list[bool | None] = []
    first = ""
    position = 0
    while position < len(said):
        length = phrases.at(said.words, position)
        first = first or " ".join(said.words[position : position + length])
        words.append(_ANY_NUMBER if length else said.words[position])
        breaks.append(said.breaks[position])
        position += length or 1
    return (first, Utterance(words, breaks)) if first else None


def lacks_a_number(said: Utterance, language: str, meaning: Callable[[Utterance], Status]) -> str:
    """Why an utterance is no command that would be one if it said how many: "go forward a few feet". Empty: it would be
    none either. ``meaning`` tells how an utterance is understood."""
    exactly = _said_exactly(said, language)
    if exactly is None or meaning(exactly[1]) is not Status.ACCEPTED:
        return ""
    return f"{exactly[0]!r} may be any number; say how many"
