"""What is decoded is taken up: it tells how long to wait while somebody speaks, and is acted on when that is over."""

from __future__ import annotations

from collections.abc import Callable
from time import monotonic
from typing import Any

from intent_engine.runtime.acting import Acting
from intent_engine.runtime.continuing import Continuing
from intent_engine.runtime.expectation import Expectation
from intent_engine.runtime.heard import HeardKind, Tell
from intent_engine.runtime.holding import Holding
from intent_engine.speech.endpoint import Endpointer, Outlook
from intent_engine.speech.spoken_utterance import SpokenUtterance
from intent_engine.speech.utterance_decoder import UtteranceDecoder

__all__ = ["TakingUp"]

LAG = 2.0
"""Times the patience with a decode, after which what was said waits in vain: for one that hung, and for its own."""


class TakingUp:
    """Takes up decodes, in the order in which their utterances were said. For one thread.

    Args:
        decoding: decodes utterances.
        endpoint: is told how long to wait.
        expectation: what may follow the words heard.
        continuing: what goes on from the command before.
        acting: carries out what was understood.
        holding: whether a stop word was heard while it was said.
        tell: is told of what was heard so far.
        stepped: whether time stands still while it decodes.
        over: whether listening was ended for good.
    """

    def __init__(
        self,
        decoding: UtteranceDecoder,
        endpoint: Endpointer,
        expectation: Expectation,
        continuing: Continuing,
        acting: Acting,
        holding: Holding,
        tell: Tell,
        *,
        stepped: bool,
        over: Callable[[], bool],
    ) -> None:
        self._decoding = decoding
        self._endpoint = endpoint
        self._expectation = expectation
        self._continuing = continuing
        self._acting = acting
        self._holding = holding
        self._tell = tell
        self._stepped = stepped
        self._over = over
        self._waiting: list[SpokenUtterance] = []
        """Over, and not done yet."""

    def forget(self) -> None:
        """Act on none of those that are over."""
        self._waiting.clear()

    def outdated(self, utterance: SpokenUtterance, time: float) -> None:
        """What was decoded is out of date."""
        self._endpoint.judge(Outlook.UNKNOWN)
        if self._decoding.forget(utterance):
            self._tell(HeardKind.OUTDATED, time)

    def ended(self, utterance: SpokenUtterance, time: float) -> None:
        """An utterance is over; what was decoded at its last pause is good enough, if it was."""
        self._see_to_lag(time)
        utterance.over_at = monotonic()
        if utterance.glance and not utterance.judged:
            self.outdated(utterance, time)
        if utterance.job is None:
            self._decoding.decode(utterance, final=True)
        self._waiting.append(utterance)
        self.collect(time, None)

    def _see_to_lag(self, time: float) -> None:
        """Leave what waits, if the recogniser is slower than people speak: it would be later with each utterance, and
        do what was said a minute ago. A stop may be among it, so the robot is stopped.

        Both clocks must say so: a recording may be played faster than it was said, and one that is waited for slower.
        """
        most = LAG * self._decoding.patience
        oldest = next(iter(self._waiting), None)
        if oldest is None or self._stepped or time - oldest.now <= most:
            return
        if monotonic() - oldest.over_at <= most:
            return
        late = time - oldest.now
        self._waiting.clear()
        if oldest.job is not None:  # else the one under way may be of what was said last
            self._decoding.leave()
        self._acting.failed(time, f"the recogniser is too slow: what was said {late:.0f} s ago still waits for it")

    def collect(self, time: float, utterance: SpokenUtterance | None) -> None:
        """Take up decodes that are ready: judge an utterance under way, act on those that ended."""
        if utterance is not None and not utterance.judged and self._ready(utterance, time):
            if not utterance.glance and self._goes_on(utterance):
                self._decoding.decode(utterance, final=utterance.final)
                return self.collect(time, utterance) if self._stepped else None
            utterance.judged = True
            if utterance.result is not None:
                self._judge(utterance, time)
        while self._waiting:
            first = self._waiting[0]
            if first.job is None:
                if not self._decoding.free and not self._decoding.hung:
                    return
                self._decoding.decode(first, final=True)
            if not self._ready(first, time):
                return
            if first.draft:
                first.job = None
                continue
            if self._goes_on(first):
                continue
            self._waiting.pop(0)
            if first.result is not None:
                self._acting.carry_out(first, time)

    def drain(self) -> None:
        """The source has ended: wait for the decodes that are under way."""
        while self._waiting and not self._over():
            first = self._waiting[0]
            if first.job is None:
                self._decoding.settle()
                self._decoding.decode(first, final=True)
            if first.job is not None:
                self._decoding.wait(first.job)
                if self._over():
                    return
                if not first.job.done():
                    self._decoding.give_up()
                    self._acting.failed(self._acting.summary.seconds, "the recogniser did not answer")
                    self._waiting.pop(0)
                    continue
            self.collect(self._acting.summary.seconds, None)

    def _ready(self, utterance: SpokenUtterance, time: float) -> bool:
        over, failure = self._decoding.outcome(utterance)
        if failure and not self._over():
            self._acting.failed(time, failure)
        return over

    def _goes_on(self, utterance: SpokenUtterance) -> bool:
        """Whether what was decoded may belong to the command before; it is to be heard anew then, together with it."""
        before = self._continuing.heard_with(utterance, self._acting.state(), self._acting.last, held=self._holding.on)
        if before is not None:
            utterance.together_with(before)
        return before is not None

    def _judge(self, utterance: SpokenUtterance, time: float) -> None:
        """What was decoded tells how long to wait. What a glance saw is only taken if it is clear, and nothing can
        change it: for all else there is time to hear the last sounds too."""
        assert utterance.result is not None
        meaning, outlook = None, Outlook.UNKNOWN
        if not (utterance.glance and utterance.result.draft):
            meaning, outlook = self._expectation.outlook(
                utterance.result, self._acting.state(), self._acting.last, amendable=self._continuing.on
            )
        utterance.called = outlook is Outlook.CALLED
        taken = not utterance.glance or outlook is Outlook.COMPLETE
        if taken:
            self._endpoint.judge(outlook, self._expectation.wait(utterance.result, meaning))
        told: dict[str, Any] = {"transcript": utterance.result, "interpretation": meaning, "outlook": outlook}
        self._tell(HeardKind.PARTIAL, time, speech_ended=utterance.last_voice, **told)
        if not taken:
            utterance.speaks_on()
            if self._endpoint.silence:
                self._decoding.decode(utterance, final=False)
