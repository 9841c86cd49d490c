"""One of several told by its number, where a grammar tells them in order: "lane 3" is "the third lane"."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from intent_engine.language.grammar import Grammar
from intent_engine.language.numbers.english_words import DIGITS, TEENS, TENS
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.ordinals_spelled import in_figures
from intent_engine.language.numbers.units import units
from intent_engine.language.quantities import evaluate
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import vocabulary
from intent_engine.language.words.thing_words import thing_words

__all__ = ["ByNumber"]

_MOST = 99
_MOST_NOUNS = 2
"""With numbers, of which one is tried."""
_NUMBERED = frozenset(("number",))
"""What may stand between a noun and its number: "preset *number* 3"."""


def _begins_anew(words: Sequence[str], at: int) -> bool:
    """Whether a number begins that is none with the word before it: "four *ninety*", "4 *90*"; not "twenty five"."""
    if is_numeral(words[at]):
        return is_numeral(words[at - 1])
    return words[at] in TENS | TEENS and words[at - 1] in DIGITS | TEENS


class ByNumber:
    """Reads such a number as an ordinal before its noun, with an article. English alone writes "3rd".

    Args:
        grammar: whose nouns and ordinals they are.
    """

    def __init__(self, grammar: Grammar) -> None:
        ordinals = any(slot.type == "ordinal" for slot in grammar.slots.values())
        self._own = vocabulary(grammar) if ordinals and grammar.language == "en" else frozenset[str]()
        known = thing_words(grammar.language)
        self._articles, self._definite = known.articles, sorted(known.definite)
        self._no_noun = known.joining | known.articles | known.alone
        table = units(grammar.language)
        self._measures = table.names if table is not None else {}
        self.rules = [(partial(self._told, which=at), partial(self._is_meant, which=at)) for at in range(_MOST_NOUNS)]
        """It as some of those in which numbers are written otherwise."""

    def _told(self, said: Utterance, language: str, *, which: int) -> Utterance | None:
        """The utterance with each number of one noun in order, behind an article; None: it has none, or a larger one.
        "Bay 3" may be told so beside it: "rotate joint 2 and go to bay 3"."""
        told = said
        for noun, start, end in reversed(self._of_one_noun(said, language, which)):
            value = evaluate(said.words[start:end], "number", language)
            if not isinstance(value, float) or not value.is_integer() or not 0 < value <= _MOST:
                return None
            article = [] if said.words[noun - 1] in self._articles else self._definite[:1]
            other = Utterance.in_one_breath([*article, in_figures(int(value)), said.words[noun]])
            told = told.with_other(noun, end, other)
        return told if told is not said else None

    def _of_one_noun(self, said: Utterance, language: str, which: int) -> list[tuple[int, int, int]]:
        places = self._places(said, language)
        nouns = [*dict.fromkeys(said.words[noun] for noun, _, _ in places)][which : which + 1]
        return [place for place in places if said.words[place[0]] in nouns]

    def _places(self, said: Utterance, language: str) -> list[tuple[int, int, int]]:
        """Where each noun stands, in one breath with its number, and where that begins and ends."""
        words = said.words
        found: list[tuple[int, int, int]] = []
        at = 1
        while self._own and at < len(words):
            end = at
            while end < len(words) and is_number(words[end], language) and not said.breaks[end]:
                end += 1
            end = self._before_a_measure(words, at, end)
            noun = at - 1 - (words[at - 1] in _NUMBERED and words[at - 1] not in self._own)
            if end > at and noun > 0 and words[noun] in self._own - self._no_noun:
                found.append((noun, at, end))
            at = max(end, at + 1)
        return found

    def _before_a_measure(self, words: Sequence[str], start: int, end: int) -> int:
        """Where the number of the noun ends, if another with its unit follows: "joint four *ninety* degrees"."""
        measured = self._measures and tuple(words[end : end + 1]) in self._measures
        ends = [at for at in range(start + 1, end if measured else start) if _begins_anew(words, at)]
        return ends[0] if len(ends) == 1 else end

    def _is_meant(self, said: Utterance, readings: Sequence[Reading], language: str, *, which: int) -> bool:
        """Whether the noun stands straight behind an ordinal each time, and no words are free."""
        nouns = [said.words[noun] for noun, _, _ in self._of_one_noun(said, language, which)]
        if not nouns or any(reading.free_words for reading in readings):
            return False
        ordinals = [(one, slot) for one in readings for slot in one.slots if slot.slot.type == "ordinal"]
        return sum(one.words[slot.end :][:1] == (nouns[0],) for one, slot in ordinals) == len(nouns)
