"""What recordings mean: the rows of a labels file, and the commands that must come of each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from intent_engine.actions import Action
from intent_engine.errors import Problem
from intent_engine.interpretation import Interpretation, Status

__all__ = ["COMPOUND", "Expected", "Row", "Step", "evenly", "steps_in", "steps_of"]

COMPOUND = "compound"


@dataclass(frozen=True, slots=True)
class Step:
    """One command of an utterance."""

    intent: str
    slots: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Expected:
    """What a recording means."""

    steps: tuple[Step, ...] = ()
    """Commands in the order said; empty: not labelled, or no command."""
    actions: tuple[Action, ...] | None = None
    """What must be done; None: not labelled."""
    types: tuple[str, ...] | None = None
    """Types of what must be done, or names of custom actions; None: not labelled."""
    by_text: bool = False
    """Whether all this was taken from the text: then the same, done after other words ("go for two feet"), is right."""
    stops: bool = False
    """Whether it is a stop that the reflex knows: one of the grammar's stop phrases is said."""

    @property
    def command(self) -> bool:
        """Whether anything is to be done."""
        return bool(self.steps or self.actions or self.types)


@dataclass(frozen=True, slots=True)
class Row:
    """One recording with its label."""

    id: str
    line: int
    """In the labels file, from 1."""
    audio: Path
    expected: Expected
    text: str | None = None
    """What is said; None: not labelled."""
    start: float = 0.0
    """s"""
    end: float | None = None
    """s; None: the end of the file."""
    speech_end: float | None = None
    """s after ``start``; None: not labelled."""
    doubts: tuple[Problem, ...] = ()
    """What can hardly be meant in it: a value that no sentence of the grammar gives."""


def evenly(rows: list[Row], limit: int | None) -> list[Row]:
    """At most ``limit`` rows, spread over the file: labels are often sorted by what they say."""
    if limit is None or limit >= len(rows):
        return rows
    return [rows[index * len(rows) // limit] for index in range(limit)]


def steps_of(meaning: Interpretation) -> tuple[Step, ...]:
    """The commands of an accepted interpretation; none of any other."""
    if meaning.status is not Status.ACCEPTED or meaning.intent is None:
        return ()
    if meaning.intent == COMPOUND:
        return steps_in(meaning.slots)
    return (Step(meaning.intent, meaning.slots),)


def steps_in(slots: Mapping[str, Any]) -> tuple[Step, ...]:
    """The commands of several at once, from their slots.

    Raises:
        KeyError, TypeError, AttributeError: they are not of that form.
    """
    return tuple(Step(step["intent"], step.get("slots") or {}) for step in slots["steps"])
