"""What is forbidden, as a command has it: "non girare a sinistra" forbids "gira a sinistra"."""

from __future__ import annotations

from collections.abc import Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.verb_forms import verbs_told

__all__ = ["as_told", "last_verb_first", "verb_first"]

_MOST_BETWEEN = 3
"""Words of a verb before what completes its negation: "ne te déplace pas"."""


def as_told(denied: Utterance, grammar: Grammar) -> Iterator[Utterance]:
    """What follows a negation, and then the commands that it may forbid: without the other half of the negation, and
    with the verb as it is told. Of some of them nothing is a command.

    Args:
        denied: the words behind the negation.
        grammar: whose language has such forms.
    """
    ways = [denied]
    completes = (at for at, word in enumerate(denied.words[: _MOST_BETWEEN + 1]) if word in grammar.wording.denying)
    if (at := next(completes, None)) is not None:
        ways.insert(0, denied.cut(at, at + 1))
    for way in ways:
        yield way
        for length, verb in verbs_told(way.words, grammar):
            yield way.with_other(0, length, Utterance([verb], [False]))


def verb_first(denied: Utterance, grammar: Grammar) -> Iterator[Utterance]:
    """What is forbidden in words that have their verb in another form or place, as a command may have it: "das Labor
    reinigen" is "reinige das Labor", "nach links drehen" is "dreh dich nach links", "den Ball aufheben" is "heb den
    Ball auf", and "reinigen Sie das Labor" is told to a stranger. Of most of them nothing is a command.

    Args:
        denied: what was said, without the negation.
        grammar: whose language has such forms.
    """
    words, wording = denied.words, grammar.wording
    for length, verb in verbs_told(words, grammar):  # where the negation stood behind it: "n'allez pas au bar"
        yield denied.with_other(0, length, Utterance([verb], [False]))
    if len(words) > 1 and words[1] in wording.asked:
        for _, verb in verbs_told(words[:1], grammar):
            yield denied.with_other(0, 2, Utterance([verb], [False]))
    yield from last_verb_first(denied, grammar)


def last_verb_first(said: Utterance, grammar: Grammar) -> Iterator[Utterance]:
    """The same of a verb that stands last in the infinitive, as it does in a language with verbs that are parted."""
    words, wording = said.words, grammar.wording
    if not wording.parted or len(words) < 2:
        return
    *before, last = words
    parted = [(last.removeprefix(begin), begin) for begin in wording.parted if last.startswith(begin)]
    for infinitive, behind in ((last, ""), *parted):
        for _, verb in verbs_told([infinitive], grammar):
            for itself in ((), *((word,) for word in sorted(wording.before_verbs))):
                told = [verb, *itself, *before, *filter(None, [behind])]
                yield Utterance.in_one_breath(told)
