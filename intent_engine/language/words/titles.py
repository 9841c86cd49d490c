"""Titles before names, as a grammar and its map have them: "Dr. Müller" as "Doktor Müller", or the other way."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from intent_engine.language.normalize import TITLES
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Titles"]


class Titles:
    """Reads titles as they are known.

    Args:
        known: the words of the grammar and its map.
        language: of the grammar. English titles are written in full wherever they stand.
    """

    def __init__(self, known: Collection[str], language: str) -> None:
        titles = thing_words(language).titles if language != "en" else {}
        self._meant = _meant(titles, known) if titles else {}
        self._begin = frozenset(words[0] for words in self._meant)

    def read(self, said: Utterance) -> Utterance:
        """The utterance with titles as they are known; the same one if there are none."""
        if self._begin.isdisjoint(said.words):
            return said
        words: list[str] = []
        breaks: list[bool | None] = []
        at = 0
        while at < len(said):
            lengths = (length for length in (2, 1) if tuple(said.words[at : at + length]) in self._meant)
            length = next(lengths, 0)
            if not length or at + length == len(said):  # behind which no name comes
                words.append(said.words[at])
                breaks.append(said.breaks[at])
                at += 1
                continue
            meant = self._meant[tuple(said.words[at : at + length])]
            words += meant
            breaks += (said.breaks[at], *[False] * (len(meant) - 1))
            at += length
        return said if words == said.words else replace(said, words=words, breaks=breaks)


def _meant(titles: Mapping[str, str], known: Collection[str]) -> dict[tuple[str, ...], tuple[str, ...]]:
    """Ways to write a title that is not known so -> the one that is. Titles that are spelled like English ones were
    written in full before."""
    known = frozenset(known)
    found: dict[tuple[str, ...], tuple[str, ...]] = {}
    for full in dict.fromkeys(titles.values()):
        ways = [tuple(short.split()) for short, meant in titles.items() if meant == full]
        read = {way: TITLES.get(way[0], way) if len(way) == 1 else way for way in ways}
        had = {meant for way, meant in read.items() if known.issuperset(way) or known.issuperset(meant)}
        if full in known:
            had.add((full,))
        if len(had) == 1:  # of several nobody knows
            (one,) = had
            found |= {way: one for way in ((full,), *ways, *read.values()) if way != one}
        else:  # "Sig.ra" is no "Sig.", whatever is behind that
            found |= {way: way for way in ways if len(way) > 1}
    return found
