"""Recognition beside the stream: one decode at a time in a thread of its own, so that listening never waits."""

from __future__ import annotations

import contextlib
import math
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import replace

from intent_engine.speech.audio import Samples
from intent_engine.speech.beside import start_beside
from intent_engine.speech.leaving import Leavable
from intent_engine.speech.recognizer import Following, Glancing, Recognizer, Transcript

__all__ = ["DecodeThread"]


class DecodeThread:
    """Runs a recogniser. A decode that hangs is given up, and its thread left behind, without harm to the next.

    Args:
        recognizer: used by one thread at a time.
        patience: s after which a decode counts as hung.
    """

    def __init__(self, recognizer: Recognizer, patience: float = 10.0) -> None:
        self.recognizer = recognizer
        self.patience = min(patience, threading.TIMEOUT_MAX)  # no thread can wait longer
        self.on_end: Callable[[], object] | None = None
        """Called in that thread when a decode has ended."""
        self._busy: Future[Transcript] | None = None
        self._following: Future[Transcript] | None = None
        self._began = 0.0

    @property
    def hung(self) -> bool:
        """Whether the decode under way takes longer than it may."""
        busy = self._busy
        return busy is not None and not busy.done() and time.monotonic() - self._began > self.patience

    @property
    def free(self) -> bool:
        """Whether a decode can begin: what only listens along gives way to it."""
        return self._busy is None or self._busy.done() or self._busy is self._following

    def settle(self, most: float = math.inf) -> None:
        """Wait for the decode under way, but no longer than it may take, nor than ``most`` s."""
        busy = self._busy
        if busy is not None:
            left = self._began + self.patience - time.monotonic()
            with contextlib.suppress(TimeoutError):
                busy.exception(timeout=max(0.0, min(left, most)))

    def give_up(self) -> None:
        """Forget the decode under way."""
        self._busy = None

    def leave(self) -> None:
        """Nobody waits for the decode under way any more: it ends soon, if the recogniser can be left."""
        if self._busy is not None and not self._busy.done() and isinstance(self.recognizer, Leavable):
            self.recognizer.leave()

    def begin(self, samples: Samples, *, final: bool) -> Future[Transcript]:
        """Start a decode; the future holds the transcript or what the recogniser raised."""
        return self._begin(lambda: self.recognizer.transcribe(samples, final=final))

    def glance(self, samples: Samples) -> Future[Transcript] | None:
        """Start a glance, as :meth:`begin`; None: the recogniser knows none."""
        recognizer = self.recognizer
        return self._begin(lambda: recognizer.glance(samples)) if isinstance(recognizer, Glancing) else None

    def listen_along(self, samples: Samples) -> Future[Transcript] | None:
        """Listen along while somebody speaks, as :meth:`begin`; None: the recogniser is busy, or cannot."""
        recognizer = self.recognizer
        if not isinstance(recognizer, Following) or not (self._busy is None or self._busy.done()):
            return None
        self._following = self._begin(lambda: recognizer.follow(samples))
        return self._following

    def _begin(self, decode: Callable[[], Transcript]) -> Future[Transcript]:
        before = self._busy if self._busy is self._following else None
        self.leave()
        future: Future[Transcript] = Future()
        if (on_end := self.on_end) is not None:
            future.add_done_callback(lambda _: on_end())
        self._busy = future
        self._began = time.monotonic()

        def work() -> None:
            waited = 0.0
            try:
                if before is not None and not before.done():  # two decodes at once would share one model
                    asked = time.perf_counter()
                    before.exception(self.patience)
                    waited = time.perf_counter() - asked
                found = decode()
                future.set_result(replace(found, decode_seconds=found.decode_seconds + waited) if waited else found)
            except BaseException as error:  # whatever a recogniser raises must come back to the caller
                future.set_exception(error)

        try:
            start_beside(work, "recogniser", patience=self.patience)
        except RuntimeError as error:  # the system has no more threads: as if the recogniser had raised it
            future.set_exception(error)
        return future
