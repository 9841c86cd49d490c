"""Amounts that say no number: "a few feet". What they would be nobody knows, so they are nothing but asked about."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from intent_engine.language.phrase_set import PhraseSet
from intent_engine.language.utterance import Utterance

__all__ = ["said_exactly", "vague_length"]

_ANY_NUMBER = "3"


def _phrases(*phrases: str) -> PhraseSet:
    return PhraseSet(phrase.split() for phrase in phrases)


_VAGUE: Mapping[str, PhraseSet] = {
    "en": _phrases(
        *("few", "a few", "quite a few", "the few", "several", "many", "some", "multiple", "lots of", "a lot of"),
        *("a number of", "a bunch of", "a handful of"),
    ),
    "de": _phrases("ein paar", "paar", "einige", "einigen", "mehrere", "mehreren", "viele", "vielen", "etliche"),
    "fr": _phrases("quelques", "plusieurs", "beaucoup de", "un peu de"),
    "es": _phrases("unos", "unas", "algunos", "algunas", "varios", "varias", "muchos", "muchas", "unos cuantos"),
    "it": _phrases("alcuni", "alcune", "qualche", "diversi", "diverse", "parecchi", "molti", "molte", "un paio di"),
}


def vague_length(words: Sequence[str], at: int, language: str) -> int:
    """Words of such an amount that begins at a place; 0: none does."""
    phrases = _VAGUE.get(language)
    return phrases.at(words, at) if phrases is not None else 0


def said_exactly(said: Utterance, language: str) -> tuple[str, Utterance] | None:
    """The first such amount in an utterance, and the utterance with a number for each; None: there is none."""
    phrases = _VAGUE.get(language)
    if phrases is None or not phrases.may_stand_in(said.words):
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
