"""How far partial text has come, and how it may go on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

from intent_engine.errors import ConfigError
from intent_engine.interpretation import Status
from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning import Interpreter
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

if TYPE_CHECKING:
    from intent_engine.language.networks.word_state import WordState

__all__ = ["Prefix", "PrefixStatus", "prefix_of"]

LONGEST = 2000
"""Letters beyond which nothing is the beginning of a command."""


class PrefixStatus(StrEnum):
    """How far words that may go on have come."""

    IMPOSSIBLE = "impossible"
    """No utterance of the grammar begins so; commands with nothing between them are not looked ahead to."""
    INCOMPLETE = "incomplete"
    """More words are needed."""
    EXTENDABLE = "extendable"
    """A whole command, that further words could still change ("turn left" + "ninety degrees")."""
    COMPLETE = "complete"
    """A whole command that nothing can change; only another command can follow."""


@dataclass(frozen=True, slots=True)
class Prefix:
    """What :meth:`IntentEngine.prefix` says of partial text."""

    status: PrefixStatus
    next_words: tuple[str, ...] = ()
    """Words that may follow, in alphabetical order; ``<number>`` where a numeral may, ``<any>`` where any word may."""
    known_words: int = 0
    """How many of the words could be followed."""
    settled: bool = False
    """A whole command of which further words could only change the manner, as a speed does, or nothing at all: what is
    to be done is said."""
    manner: bool = False
    """A whole command that may go on to a speed."""
    resting: bool = False
    """A whole command that ends in a quantity which people like to add to after a rest: "in an hour", "and a half"."""
    idle_end: bool = False
    """A whole command that may go on to words that fill no slot, and does the same with them."""


def prefix_of(interpreter: Interpreter, text: str, *, spoken: bool = False) -> Prefix:
    """How far partial text has come, and how it may go on; ``spoken`` as for :meth:`IntentEngine.prefix`."""
    matcher = interpreter.matcher
    said = matcher.heard(text) if len(text) < LONGEST else Utterance(["\0"], [False])
    words = said.words
    try:
        for words in _written(matcher, said):
            count, reached = matcher.begun.walk(words)
            if reached is not None:
                break
        if reached is None and spoken and (as_understood := _as_understood(interpreter, text, said)):
            words = as_understood
            count, reached = matcher.begun.walk(words)
    except ConfigError:  # the grammar is too ambiguous to be walked; parsing the text tells it
        count, reached = 0, None
    if reached is None:
        if interpreter.dictates(text):
            return Prefix(PrefixStatus.EXTENDABLE, (), len(words))
        return Prefix(PrefixStatus.IMPOSSIBLE, (), count)
    status = _status(matcher, reached)
    whole = status is not PrefixStatus.INCOMPLETE
    settled = whole and matcher.settled(words)
    idle_end = whole and not settled and _says_it_all(interpreter, words)
    resting = status is PrefixStatus.EXTENDABLE and matcher.resting(words)
    manner = status is PrefixStatus.EXTENDABLE and matcher.tells_manner(words)
    return Prefix(status, _next_words(matcher, reached), count, settled or idle_end, manner, resting, idle_end)


def _says_it_all(interpreter: Interpreter, words: Sequence[str]) -> bool:
    """Whether a whole command does the same with each end that its sentence may have: "show me the history", and
    "section"."""
    endings = interpreter.matcher.endings(words)
    if not endings:
        return False
    meanings = [interpreter.interpret(" ".join([*words, *ending]), spoken=True) for ending in ((), *endings)]
    return all(one.status is Status.ACCEPTED and one.actions == meanings[0].actions for one in meanings)


def _next_words(matcher: Matcher, reached: WordState) -> tuple[str, ...]:
    """The words that may follow a state, for showing."""
    automaton = matcher.begun
    words = sorted(word for word in automaton.next_words(reached) if word and word[0] != "\0")
    if automaton.allows_digits(reached):
        words.append("<number>")
    if automaton.free(reached):
        words.append("<any>")
    return tuple(words)


def _written(matcher: Matcher, said: Utterance) -> Iterator[list[str]]:
    """The words of a text as a recogniser may write them: as they are, together or apart, and with units for short:
    "lift it 5 mm" of a grammar that has "millimeters"."""
    yield said.words
    otherwise = matcher.spacing.otherwise(said)
    if otherwise is not None:
        yield otherwise.words
    yield from (one.words for one in matcher.unit_symbols.in_full(said))


def _as_understood(interpreter: Interpreter, text: str, said: Utterance) -> list[str] | None:
    """The words of a command with one that only sounds like a word of the grammar as that: "go back four meters", heard
    as "go back for meters"; or with the article of the grammar: "take a lamp" of one that has "take the lamp". None: it
    is no command, or not understood so."""
    meaning = interpreter.interpret(text, spoken=True)
    if meaning.status is not Status.ACCEPTED:
        return None
    matcher = interpreter.matcher
    for words in _written(matcher, said):
        for other in _otherwise(matcher, words, matcher.begun.walk(words)[0]):
            _, reached = matcher.begun.walk(other)
            if reached is not None and interpreter.interpret(" ".join(other), spoken=True).actions == meaning.actions:
                return other
    return None


def _otherwise(matcher: Matcher, words: Sequence[str], known: int) -> Iterator[list[str]]:
    """The words, each time with one of the last known ones as another that sounds like it, or another article."""
    articles = thing_words(matcher.grammar.language).articles
    for place in range(min(known, len(words) - 1), -1, -1):
        behind = words[place:]
        for other in matcher.alikes.get(behind[0], ()):
            yield [*words[:place], other, *behind[1:]]
        if place == known and behind[0] not in articles:
            yield from ([*words[:place], article, *behind] for article in articles)
        elif behind[0] in articles:
            yield [*words[:place], *behind[1:]]
            yield from ([*words[:place], article, *behind[1:]] for article in articles - {behind[0]})


def _status(matcher: Matcher, reached: WordState) -> PrefixStatus:
    automaton = matcher.begun
    if not automaton.accepting(reached):
        return PrefixStatus.INCOMPLETE
    return PrefixStatus.EXTENDABLE if automaton.inside(reached) else PrefixStatus.COMPLETE
