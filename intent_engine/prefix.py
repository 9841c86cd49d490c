"""How far words that may go on have come, and how they may go on."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

from intent_engine.errors import ConfigError
from intent_engine.language.utterance import Utterance

if TYPE_CHECKING:
    from intent_engine.language.matcher import Matcher
    from intent_engine.language.meaning import Interpreter
    from intent_engine.language.word_state import WordState

__all__ = ["Prefix", "PrefixStatus", "next_words", "prefix_of"]


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
    """A whole command of which further words could only change the manner, as a speed does: what is to be done is
    said."""
    resting: bool = False
    """A whole command that ends in a quantity which people like to add to after a rest: "in an hour", "and a half"."""


def prefix_of(interpreter: Interpreter, text: str) -> Prefix:
    """How far partial text has come in the grammar of an interpreter, and how it may go on."""
    matcher = interpreter.matcher
    said = Utterance.of(text, matcher.grammar.language) if len(text) < 2000 else Utterance(["\0"], [False])
    words = said.words
    try:
        count, reached = matcher.prefix(words)
        if reached is None and (otherwise := matcher.spacing.otherwise(said)) is not None:
            words = otherwise.words
            count, reached = matcher.prefix(words)
    except ConfigError:  # see IntentEngine.parse
        count, reached = 0, None
    if reached is None:
        if interpreter.dictates(text):
            return Prefix(PrefixStatus.EXTENDABLE, (), len(words))
        return Prefix(PrefixStatus.IMPOSSIBLE, (), count)
    status = _status(matcher, reached)
    settled = status is not PrefixStatus.INCOMPLETE and matcher.settled(words)
    resting = status is PrefixStatus.EXTENDABLE and matcher.resting(words)
    return Prefix(status, next_words(matcher, reached), count, settled, resting)


def next_words(matcher: Matcher, reached: WordState) -> tuple[str, ...]:
    """The words that may follow a state, for showing."""
    automaton = matcher.spoken
    words = sorted(word for word in automaton.next_words(reached) if word and word[0] != "\0")
    if automaton.allows_digits(reached):
        words.append("<number>")
    if automaton.free(reached):
        words.append("<any>")
    return tuple(words)


def _status(matcher: Matcher, reached: WordState) -> PrefixStatus:
    automaton = matcher.spoken
    if not automaton.accepting(reached):
        return PrefixStatus.INCOMPLETE
    return PrefixStatus.EXTENDABLE if automaton.inside(reached) else PrefixStatus.COMPLETE
