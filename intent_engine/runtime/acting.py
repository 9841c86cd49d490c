"""What is done about an utterance that is over: the robot stops, or is given goals, and whoever listens is told.

A stop is done before anybody is told of it, since who is told may take its time.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import replace
from typing import Any

from intent_engine.execution.executor import Executor
from intent_engine.execution.failsafe import HANGS
from intent_engine.execution.goal import Goal
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.context.references import Before
from intent_engine.needs import states_of
from intent_engine.runtime.amending import Step
from intent_engine.runtime.answering import Answering
from intent_engine.runtime.continuing import Continuing, Understood
from intent_engine.runtime.hands import Hands
from intent_engine.runtime.heard import HeardKind, Summary, Tell
from intent_engine.runtime.holding import Holding
from intent_engine.runtime.judgement import Judge
from intent_engine.runtime.last_asked import LastAsked
from intent_engine.runtime.last_said import LastSaid
from intent_engine.speech.spoken_utterance import SpokenUtterance

__all__ = ["Acting"]

_TORN = "sound was lost just before it, and perhaps its beginning; say it again"


class Acting:
    """Carries out what was understood. For one thread.

    Args:
        executor: is stopped, and tells whether the robot moves.
        hands: give it what is to be done.
        judgement: what a transcript means.
        continuing: what goes on from the command before.
        holding: whether a stop word was heard while it was said.
        tell: is told of it.
        asked: what was last asked back.
        states: those in which the robot is besides, which only the program knows.
        over: whether listening was ended for good: nothing more is done then but a stop.
    """

    def __init__(
        self,
        executor: Executor,
        hands: Hands,
        judgement: Judge,
        continuing: Continuing,
        holding: Holding,
        tell: Tell,
        asked: LastAsked,
        states: Callable[[], Collection[str]] = tuple,
        *,
        over: Callable[[], bool] = bool,
    ) -> None:
        self._executor = executor
        self._hands = hands
        self._judgement = judgement
        self._continuing = continuing
        self._holding = holding
        self._tell = tell
        self._states = states
        self._over = over
        self._base = 0.0
        self.summary = Summary()
        """What it came to since :meth:`begin`."""
        self._last = LastSaid(lambda: judgement.engine.grammars)
        self._asked = asked
        self._answering = Answering(judgement.engine)

    def begin(self, base: float) -> None:
        """A source begins. What an earlier run left behind, which may have ended in the middle of anything, is
        forgotten: a robot that still counted as held would not be held by the next stop word.

        Args:
            base: s on the executor's clock at which the source begins.
        """
        self._base = base
        self.summary = Summary()
        self._forget()

    @property
    def last(self) -> Before:
        """What was last understood, for words that point back to it."""
        return self._last.meaning

    def state(self) -> Collection[str]:
        """Of the robot, as grammars ask for it: "moving" while it moves, is about to, or is held, and what the program
        says."""
        linear, angular = self._executor.loop.written
        moves = linear or angular or not self._executor.idle or self._holding.on
        return {*states_of(self._states()), *(("moving",) if moves else ())}

    def carry_out(self, utterance: SpokenUtterance, time: float) -> None:
        """Do what an utterance means, if anything; it was decoded, and its result is there.

        First what stops the robot, or takes back what it does; then everybody is told; then a robot that was held goes
        on, if this was no stop; and last what is to be done anew is submitted.
        """
        understood = self._continuing.understood(utterance, self.state(), self.last)
        transcript, meaning = understood.transcript, understood.meaning
        if not transcript.text.strip():
            self._holding.release(time, "nothing was said")
            return
        if self._holding.on:
            meaning = self._judgement.held(transcript, meaning)
        if utterance.torn and meaning.status is Status.ACCEPTED and not meaning.stops:
            meaning = Interpretation(transcript.text, Status.REJECTED, reason=_TORN)
        if utterance.short and not meaning.stops:
            self._holding.release(time, "too short to be another word than a stop")
            return
        self.summary.utterances += 1
        if (answer := self._answer(utterance, meaning)) is not None:
            transcript, meaning = transcript.as_heard(), answer
            understood = replace(understood, meaning=meaning, step=Step(meaning.actions), corrects=False)
        asks = replace(meaning, question=None) if utterance.torn else meaning
        spoken_at = self._base + utterance.last_voice
        self._asked.take(asks, self.last, spoken_at)
        if meaning.status is not Status.ACCEPTED and self._judgement.unsure(transcript):
            transcript = transcript.as_heard()  # what was said, not what was looked for
        told: dict[str, Any] = {
            "speech_ended": utterance.last_voice,
            "goes_on": understood.step.goes_on,
            "in_turn": understood.step.in_turn,
        }
        if meaning.stops:
            self._continuing.stopped(utterance, meaning)  # while what it stops is known to be under way
        if meaning.stops or understood.withdrawn:  # before anybody is told: who is may take its time
            self._holding.forget()
            self._last.forget()
            self._executor.stop(spoken_at=spoken_at)
        elif meaning.denied and self._executor.deny(meaning.denied, spoken_at=spoken_at):
            self._forget()  # "don't clean the lab" to a robot that does
        elif understood.corrects:
            self._last.forget()  # "no, three": whatever was meant, it was not that
        self._tell(HeardKind.TRANSCRIPT, time, transcript=transcript, **told)
        self._tell(HeardKind.INTERPRETATION, time, transcript=transcript, interpretation=meaning, **told)
        if meaning.stops:
            self.summary.accepted += 1
            self._tell(HeardKind.SUBMITTED, time, interpretation=meaning, **told)
            return
        self._holding.release(time, "no stop was said")
        if meaning.status is not Status.ACCEPTED or not meaning.actions or self._over():
            return
        self._last.take(meaning)
        goals = self._submit(understood, utterance)
        if goals is None:
            self.failed(time, HANGS)
            return
        self._tell(HeardKind.SUBMITTED, time, interpretation=meaning, goals=goals, **told)

    def _answer(self, utterance: SpokenUtterance, found: Interpretation) -> Interpretation | None:
        """What an utterance means as the answer to what was asked back; None: it is none."""
        asked = self._asked.at(self._base + utterance.began)
        heard = utterance.result if utterance.alone is None else utterance.alone
        if asked is None or heard is None or utterance.torn:
            return None
        return self._answering.answer(asked, heard, found, self.state())

    def failed(self, time: float, why: str) -> None:
        """Something failed: the robot is stopped, nothing goes on from what was said, and listening goes on."""
        self._forget()
        self.summary.errors += 1
        self._executor.stop()
        self._tell(HeardKind.ERROR, time, detail=why)

    def _submit(self, understood: Understood, utterance: SpokenUtterance) -> tuple[Goal, ...] | None:
        """Its goals; None: the robot hangs."""
        step, spoken = understood.step, self._base + utterance.last_voice
        guards = step.guards_of(understood.meaning, self._states)
        goals = self._hands.submit(
            step.actions, spoken_at=spoken, policy=step.policy, amends=step.amends, guards=guards
        )
        if goals is None:
            return None
        self.summary.accepted += not step.goes_on
        self._continuing.carried_out(utterance, understood, goals)
        return tuple(goals)

    def _forget(self) -> None:
        self._holding.forget()
        self._continuing.forget()
        self._asked.forget()
        self._last.forget()
