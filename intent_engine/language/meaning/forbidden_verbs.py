"""What is forbidden, as a command has it: "non girare a sinistra" forbids "gira a sinistra"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.utterance import Utterance

__all__ = ["as_told", "verbs_told"]

_LEAST_LETTERS = 2
"""Of a stem: "era" is no form of an "a"."""
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
    completes = (at for at, word in enumerate(denied.words[: _MOST_BETWEEN + 1]) if word in grammar.denying)
    if (at := next(completes, None)) is not None:
        ways.insert(0, denied.with_other(at, at + 1, Utterance([], [])))
    for way in ways:
        yield way
        for length, verb in verbs_told(way.words, grammar):
            yield way.with_other(0, length, Utterance([verb], [False]))


def verbs_told(words: Sequence[str], grammar: Grammar) -> Iterator[tuple[int, str]]:
    """Of how many of the words, from the first on, a verb is a form, and that verb as it is told: of "girare" it is
    "gira". Some of them are none."""
    for *form, verb in grammar.forbidden:
        *before, ending = form
        if len(words) < len(form) or list(words[: len(before)]) != before:
            continue
        said = words[len(before)]
        if not ending.startswith("-"):
            if said == ending:
                yield len(form), verb
            continue
        stem = said.removesuffix(ending[1:])
        if stem != said and len(stem) >= _LEAST_LETTERS:
            yield len(form), stem + verb.removeprefix("-")
