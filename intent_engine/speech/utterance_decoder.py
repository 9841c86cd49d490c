"""What of an utterance is decoded, and when: one decode at a time, and none that nobody waits for."""

from __future__ import annotations

import contextlib
from concurrent.futures import Future

from intent_engine.speech.decoding import DecodeThread
from intent_engine.speech.recognizer import Recognizer, Transcript
from intent_engine.speech.spoken_utterance import SpokenUtterance

__all__ = ["UtteranceDecoder"]


class UtteranceDecoder(DecodeThread):
    """Decodes utterances, and leaves with each its decode.

    Args:
        recognizer, patience: as for :class:`~intent_engine.speech.decoding.DecodeThread`.
        stepped: whether time stands still while it decodes, so that each decode is waited for.
    """

    def __init__(self, recognizer: Recognizer, patience: float, *, stepped: bool) -> None:
        super().__init__(recognizer, patience)
        self._stepped = stepped

    def decode(self, utterance: SpokenUtterance, *, final: bool) -> None:
        """Decode what was said so far; nothing is begun while another decode is under way."""
        if not self.free:
            if not (self._stepped or self.hung):
                return
            self.give_up()
        self._decoded(utterance, self.begin(utterance.sound(), final=final), final=final)

    def look(self, utterance: SpokenUtterance) -> None:
        """Glance at what was said so far, to be ready if it is clear already."""
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
        """Wait for a decode, but no longer than it may take."""
        with contextlib.suppress(TimeoutError):  # it counts as hung then
            job.exception(timeout=self.patience)

    def _decoded(
        self, utterance: SpokenUtterance, job: Future[Transcript], *, final: bool = False, glance: bool = False
    ) -> None:
        utterance.decoding(job, final=final, glance=glance)
        if self._stepped:
            self.wait(job)
