"""What is forbidden, as a command has it: "non girare a sinistra" forbids "gira a sinistra"."""

from __future__ import annotations

from collections.abc import Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.utterance import Utterance
from intent_engine.language.verb_forms import verbs_told

__all__ = ["as_told"]

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
        ways.insert(0, denied.with_other(at, at + 1, Utterance([], [])))
    for way in ways:
        yield way
        for length, verb in verbs_told(way.words, grammar):
            yield way.with_other(0, length, Utterance([verb], [False]))
