"""The seam for explanations: which methods decide something, marked where they are written.

A mark costs a parse nothing. :func:`watched` copies a rule with its marked methods given through a watcher, so that
whoever explains needs to know no method's name, and a rule needs to know nothing of explanations.
"""

from __future__ import annotations

import copy
from collections.abc import Callable
from enum import StrEnum
from typing import Any, Protocol, TypeVar

__all__ = ["Kind", "Watch", "step", "watched"]


class Kind(StrEnum):
    """What is decided. The arguments and answers are those of the method that bears the mark."""

    STOP = "stop"
    """Utterance -> whether it is a command to stop."""
    WAKE = "wake word"
    """Utterance -> what follows the wake word; None: it was not said."""
    DICTATION = "dictation"
    """Text -> the command in which something is dictated; None: nothing is."""
    NUMBERS = "numbers"
    """Utterance -> whether one number was begun twice."""
    SENTENCE = "sentence"
    """Words -> the clause that they are, exactly."""
    CHOICE = "choice"
    """Readings -> the clause that one of them makes."""
    COMMAND = "command"
    """Utterance -> the clause that it is, exact, corrected or misheard."""
    MISHEARD = "misheard"
    """Words -> the clause that they sound like."""
    CORRECTION = "correction"
    """Utterance -> the clause after its corrections."""
    REPLACEMENT = "replacement"
    """Utterance, utterance -> the former with what the latter corrects in it."""
    NEGATION = "negation"
    """Utterance -> what of it is wanted all the same, or None and why nothing is."""
    COMPOUND = "compound"
    """Utterance -> the clauses of which it is made."""
    RUN_ON = "run-on"
    """Utterance -> the clauses that follow one another in it; None: that is not certain."""
    REFUSAL = "refused"
    """Text -> an interpretation without an action."""
    OTHERWISE = "otherwise"
    """Text, utterance -> an interpretation of what no rule understood."""


class Watch(Protocol):
    """Stands before a method: calls it, looks at what it is given and answers, and changes neither."""

    def __call__(self, kind: Kind, method: Callable[..., Any], /) -> Callable[..., Any]: ...


_Method = TypeVar("_Method", bound=Callable[..., Any])
_Rule = TypeVar("_Rule")
_MARK = "decides"


def step(kind: Kind) -> Callable[[_Method], _Method]:
    """Mark a method as one that decides something."""

    def mark(method: _Method) -> _Method:
        vars(method)[_MARK] = kind
        return method

    return mark


def watched(rule: _Rule, watch: Watch) -> _Rule:
    """A copy of an object, whose marked methods are watched. The object itself is left as it is."""
    copied = copy.copy(rule)
    for name, function in vars(type(rule)).items():
        kind = getattr(function, _MARK, None)
        if kind is not None:
            vars(copied)[name] = watch(kind, getattr(copied, name))
    return copied
