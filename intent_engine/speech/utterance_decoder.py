"""What of an utterance is decoded, and when: one decode at a time, and none that nobody waits for."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from concurrent.futures import FIRST_COMPLETED, Future, InvalidStateError
from concurrent.futures import wait as wait_for
from dataclasses import replace
from typing import Any

from intent_engine.speech.beside import cores
from intent_engine.speech.decoding import DecodeThread
from intent_engine.speech.recognizer import Following, Recognizer, Transcript
from intent_engine.speech.spoken_utterance import SpokenUtterance

__all__ = ["UtteranceDecoder"]

OFTEN = 0.35
"""s of speech after which the recogniser listens along again,"""
REST = 3.0
"""and at least so many times as long as it took the last time: a third of a core at most, on any machine."""
SELDOM = 1.2
"""s of speech after which the recogniser listens along again, where what was said begins no command."""
LONGEST = 6.0
"""s of speech, longer than any command: beyond it the recogniser does not listen along."""
GIVES_WAY = 0.035
"""s within which nine of ten abandoned decodes end: added to a decode where time stands still, as none is abandoned."""


class UtteranceDecoder(DecodeThread):
    """Decodes utterances, and leaves with each its decode.

    Args:
        recognizer, patience: as for :class:`~intent_engine.speech.decoding.DecodeThread`.
        stepped: whether time stands still while it decodes, so that each decode is waited for.
    """

    def __init__(self, recognizer: Recognizer, patience: float, *, stepped: bool) -> None:
        super().__init__(recognizer, patience)
        self._stepped = stepped
        self._able = cores() > 1
        """Whether there is a core for listening along."""
        self._now = 0.0
        """s since the source began."""
        self._next = 0.0
        """s since the source began: when the recogniser listens along again."""
        self._closed: Future[None] = Future()
        """Done when nobody waits for anything any more."""
        self._along: tuple[float, Future[Transcript]] | None = None
        """When the recogniser began to listen along, and what it will have heard; None: it does not."""

    def begin_source(self) -> None:
        """Another source begins, whose times have nothing to do with those before."""
        self._now = self._next = 0.0
        self._along = None

    def follow(self, utterance: SpokenUtterance) -> Transcript | None:
        """Listen along while somebody speaks, now and then. Returns what was heard so, when it is known."""
        self._now = utterance.now
        heard = self._followed()
        if (
            self._able
            and self._along is None
            and OFTEN <= self._now - utterance.began < LONGEST
            and self._now >= self._next
        ):
            job = self.listen_along(utterance.sound())
            if job is not None:
                self._along = self._now, job
                if self._stepped:
                    self.wait(job)
        return heard

    def rest(self) -> None:
        """What was said so far begins no command, and need not be done at once: listen along seldom."""
        self._next = max(self._next, self._now + SELDOM)

    def _followed(self) -> Transcript | None:
        """What the recogniser heard as it listened along, once it has ended."""
        if self._along is None or not self._along[1].done():
            return None
        began, job = self._along
        heard = _heard(job)
        if heard is not None and self._stepped and self._now < began + heard.decode_seconds:
            return None
        self._along = None
        self._next = began + max(OFTEN, REST * (heard.decode_seconds if heard is not None else 0.0))
        # Where it failed, whoever is asked next has the same trouble, and tells it.
        return heard if heard is not None and heard.text else None

    def _begin(self, decode: Callable[[], Transcript]) -> Future[Transcript]:
        if self._along is None:
            return super()._begin(decode)
        began, job = self._along
        self._along = None
        known = _heard(job) if job.done() else None
        if not (self._stepped and known is not None and self._now < began + known.decode_seconds):
            return super()._begin(decode)
        # Time stands still, so it has heard what it would have had to leave.
        if isinstance(self.recognizer, Following):
            self.recognizer.lose()

        def later() -> Transcript:
            found = decode()
            return replace(found, decode_seconds=found.decode_seconds + GIVES_WAY)

        return super()._begin(later)

    def decode(self, utterance: SpokenUtterance, *, final: bool) -> None:
        """Decode what was said so far; nothing is begun while another decode is under way."""
        self._now = utterance.now
        if not self.free:
            if not (self._stepped or self.hung):
                return
            self.give_up()
        self._decoded(utterance, self.begin(utterance.sound(), final=final), final=final)

    def look(self, utterance: SpokenUtterance) -> None:
        """Glance at what was said so far, to be ready if it is clear already."""
        self._now = utterance.now
        job = self.glance(utterance.sound()) if self.free else None
        if job is not None:
            self._decoded(utterance, job, glance=True)

    def forget(self, utterance: SpokenUtterance) -> bool:
        """What was decoded of an utterance is out of date; returns whether anything was."""
        job = utterance.job
        if job is not None and not job.done():  # else another's decode may be under way
            self.leave()
        utterance.speaks_on()
        return job is not None

    def wait(self, job: Future[Transcript]) -> None:
        """Wait for a decode, but no longer than it may take, after which it counts as hung, nor after ``close``."""
        either: list[Future[Any]] = [job, self._closed]
        wait_for(either, timeout=self.patience, return_when=FIRST_COMPLETED)

    def close(self) -> None:
        """Let whoever waits for a decode wait no longer. Idempotent, from any thread."""
        with contextlib.suppress(InvalidStateError):
            self._closed.set_result(None)

    def outcome(self, utterance: SpokenUtterance) -> tuple[bool, str]:
        """Whether the decode of an utterance is over, and why it failed, if it did. One that hangs is given up."""
        job = utterance.job
        if job is None:
            return False, ""
        if not job.done():
            if not (self._stepped or self.hung):
                return False, ""
            self.give_up()
            utterance.job = None if not utterance.ended else job
            return True, f"the recogniser did not answer within {self.patience:g} s"
        error = job.exception()
        if error is not None:
            return True, f"the recogniser failed: {type(error).__name__}: {error}"
        heard = job.result()
        if not isinstance(heard, Transcript):
            return True, f"the recogniser failed: it gave {type(heard).__name__}, and no Transcript"
        utterance.result = heard
        return True, ""

    def _decoded(
        self, utterance: SpokenUtterance, job: Future[Transcript], *, final: bool = False, glance: bool = False
    ) -> None:
        utterance.decoding(job, final=final, glance=glance)
        if self._stepped:
            self.wait(job)


def _heard(job: Future[Transcript]) -> Transcript | None:
    """What was heard in a decode that has ended; None: it failed."""
    found = job.result() if job.exception() is None else None
    return found if isinstance(found, Transcript) else None
