"""What was last asked back, and for how long it may be answered."""

from __future__ import annotations

import math
from dataclasses import replace

from intent_engine.execution.events import Event, EventKind
from intent_engine.interpretation import Interpretation
from intent_engine.language.context.references import Before
from intent_engine.speech.endpoint import Settings

__all__ = ["QUESTION_LASTS", "LastAsked"]

QUESTION_LASTS = Settings().question_lasts
"""s from the end of what was not clear to the beginning of its answer: the robot asks, and a person thinks."""


class LastAsked:
    """Keeps a question until something else is understood, the robot is stopped, or it is too old. For one thread, but
    for :meth:`happened`. Times are s on the executor's clock.

    Args:
        lasts: s for which it may be answered; 0: it never may.
    """

    def __init__(self, lasts: float = QUESTION_LASTS) -> None:
        self._lasts = lasts
        self._asked: Interpretation | None = None
        self._ended = -math.inf
        self._stopped = -math.inf

    def take(self, meaning: Interpretation, last: Before, ended: float) -> None:
        """An utterance is understood. What it asks back can be answered, and nothing that was asked before.

        Args:
            meaning: what was made of it.
            last: what was done before, which "again" and "it" of the whole sentence point to.
            ended: when its last word was over.
        """
        question = meaning.question
        if question is None:
            self.forget()
            return
        if isinstance(last, Interpretation):
            question = replace(question, before=last.actions, needs=last.needs, said_before=last.text)
        self._asked, self._ended = replace(meaning, question=question), ended

    def at(self, began: float) -> Interpretation | None:
        """What words answer that begin at this time; None: nothing is asked."""
        over = began - self._ended > self._lasts or not self._lasts or self._stopped > self._ended
        return None if over else self._asked

    def forget(self) -> None:
        """Nothing is asked any more."""
        self._asked = None

    def happened(self, event: Event) -> None:
        """Something was executed: a stop ends what was asked before it, whoever stopped the robot. From any thread; it
        may be told of late, when something else is asked."""
        if event.kind in (EventKind.STOP, EventKind.ESTOP):
            self._stopped = event.time
