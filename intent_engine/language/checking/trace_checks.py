"""Ways through the automaton that nobody means, most of them with a word that is taken for a number by its sound."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language import quantities
from intent_engine.language.automaton import Automaton
from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.networks.network import NAMED
from intent_engine.language.networks.word_state import Trace
from intent_engine.language.numbers.english_words import DIGITS, NUMBER_WORDS, ZERO
from intent_engine.language.slots.adjacent_numbers import is_number

__all__ = ["LEADING", "NUMBERS_BY_SOUND", "loses_a_number", "means_nothing"]

NUMBERS_BY_SOUND = frozenset(
    (("to", "two"), ("too", "two"), ("for", "four"), ("fore", "four"), ("won", "one"), ("ate", "eight"))
)
"""Words that are numbers where a unit follows, as sure as these themselves: of 30 times that "to meters", "to feet" or
"for meters" was heard in quiet and in noise, and the sentence was one but for that, each was that number."""
LEADING = frozenset(("to", "too", "for", "fore"))
GOES_ON = frozenset(("hundred", "thousand", "million", "point"))
"""Words of a number before which these may be one too; "to twenty degrees" is no 220."""
CUT_OFF = (["to"], ["for"])
"""Words with which a sentence goes on. At its end neither is "two" or "four"."""


def means_nothing(trace: Trace, words: Sequence[str], language: str) -> bool:
    """Whether a way through the automaton is none that anybody means by these words.

    Args:
        trace: the way.
        words: that led along it.
        language: of the words.
    """
    return (
        _cut_off(trace, words)
        or _leads_to_a_number(trace, words, language)
        or _drops_a_digit(trace, words)
        or _names_no_number(trace, words, language)
    )


def loses_a_number(trace: Trace, words: Sequence[str], grammar: Grammar, strict: Automaton) -> bool:
    """Whether a number is taken for another word and what belongs to it for free text: "wave two times once" is no
    "wave to *times once*", for "wave two times" was said.

    Args:
        trace: a way through the loose automaton.
        words: that led along it.
        grammar: whose.
        strict: the automaton in which no word is taken for another.
    """
    return any(
        mark[0] == "alike"
        and mark[1] not in NUMBER_WORDS
        and is_number(words[position - 1], grammar.language)
        and _opens_free_text(trace, position, grammar)
        and strict.walk(list(words))[0] > position
        for position, mark in trace
    )


def _opens_free_text(trace: Trace, place: int, grammar: Grammar) -> bool:
    """Whether what stands behind a word is free text."""
    return any(
        position == place
        and mark[0] == "open"
        and mark[1][0] == "slot"
        and grammar.slots[mark[1][2]].type in FREE_KINDS
        for position, mark in trace
    )


def _cut_off(trace: Trace, words: Sequence[str]) -> bool:
    """Whether the last word is taken for a number, but may be where a sentence broke off: "turn left to"."""
    return words[-1:] in CUT_OFF and any(mark[0] == "alike" and position == len(words) for position, mark in trace)


def _leads_to_a_number(trace: Trace, words: Sequence[str], language: str) -> bool:
    """Whether a word is taken for a number that only leads to one: "turn right to twenty degrees"."""
    return not LEADING.isdisjoint(words) and any(
        mark[0] == "alike"
        and words[position - 1] in LEADING
        and (words[position - 1], mark[1]) in NUMBERS_BY_SOUND
        and position < len(words)
        and words[position] not in GOES_ON
        and is_number(words[position], language)
        for position, mark in trace
    )


def _drops_a_digit(trace: Trace, words: Sequence[str]) -> bool:
    """Whether the first of two digits is taken for a word that leads to the other: who says "turn left *four* five
    degrees" means 45, and not "for five degrees"."""
    return any(
        mark[0] == "alike"
        and mark[1] not in NUMBER_WORDS
        and _is_digit(words[position - 1])
        and position < len(words)
        and _is_digit(words[position])
        for position, mark in trace
    )


def _is_digit(word: str) -> bool:
    return word in DIGITS or word in ZERO or (len(word) == 1 and word.isdecimal())


def _names_no_number(trace: Trace, words: Sequence[str], language: str) -> bool:
    """Whether what stands for the number of a name is not one whole number that is said as it is: "drawer 7 and 8",
    "drawer 7.5", "drawer minus seven". No drawer is called so, and the first of two is not the one that is meant."""
    for _, mark in trace:
        if mark[1] is NAMED:
            break
    else:
        return False  # as most are: few sentences have such numbers
    begin = 0
    heard: list[str] = []
    for position, mark in trace:
        if mark[:2] == ("open", NAMED):
            begin, heard = position, [*words]
        elif mark[0] == "alike" and heard:
            heard[position - 1] = mark[1]
        elif mark == ("close", NAMED):
            number = quantities.evaluate(heard[begin:position], "number", language)
            if not (isinstance(number, float) and number >= 0 and number.is_integer()):
                return True
            if _is_part(heard, begin, language) or _is_part(heard, position, language):
                return True
    return False


def _is_part(words: Sequence[str], cut: int, language: str) -> bool:
    """Whether words on both sides of a place are one number, or could be two that end elsewhere: "track twenty five
    times" has no track of twenty that is to be played five times, and nobody knows whether it has a track 25."""
    start = end = cut
    while start > 0 and _of_a_number(words[start - 1], language):
        start -= 1
    while end < len(words) and _of_a_number(words[end], language):
        end += 1
    if cut in (start, end):
        return False
    if _is_number(words[start:end], language):
        return True
    ways = (_is_number(words[start:at], language) and _is_number(words[at:end], language) for at in range(start, end))
    return sum(ways) > 1


def _of_a_number(word: str, language: str) -> bool:
    return is_number(word, language) or word in GOES_ON


def _is_number(words: Sequence[str], language: str) -> bool:
    return isinstance(quantities.evaluate(words, "number", language), float)
