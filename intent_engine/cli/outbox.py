"""What a session tells, written in a thread of its own: a reader that stands still holds up no stop."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from types import TracebackType

from intent_engine.cli.streams import drop_output
from intent_engine.cli.terminal import note

__all__ = ["Outbox"]

MOST = 10_000
"""Lines that may wait. A session that listens to talk writes some ten a second; each is less than 2 kB."""
PATIENCE = 0.5
"""s that lines get which are still unread when a session is broken off."""


class Outbox:
    """Takes what is to be written and returns at once. Thread-safe.

    A listener that waits until its line is read would hold up the frames, and with them the stop that is said next:
    ``listen --json | less``, a terminal that was halted with Ctrl-S, a program that is being debugged.

    Life cycle: ``with`` (its thread runs) -> ``put`` -> the end of the block waits until all is written; broken off by
    an exception it waits no longer than ``PATIENCE``, and gives the rest to nobody.

    Args:
        on_failure: is called once, from the thread, when nothing can be written any more.
    """

    def __init__(self, on_failure: Callable[[], object] | None = None) -> None:
        self.on_failure = on_failure
        self._waiting: deque[Callable[[], object]] = deque()
        self._changed = threading.Condition()
        self._writing = self._ending = False
        self._error: Exception | None = None
        self._thread = threading.Thread(target=self._work, name="outbox", daemon=True)
        self.unread = 0
        """Lines that found no room, since nobody read; told at the end, on standard error."""

    def put(self, write: Callable[[], object]) -> None:
        """Write something, in its turn.

        Raises:
            BrokenPipeError: what was put before found no reader.
            OutputError: it could not be written.
            Exception: whatever else writing it raised.
        """
        with self._changed:
            if self._error is not None:
                raise self._error
            if len(self._waiting) >= MOST:
                self.unread += 1
                return
            self._waiting.append(write)
            self._changed.notify_all()

    def settle(self, seconds: float | None = None) -> None:
        """Wait until all is written, at most so long.

        Raises:
            BrokenPipeError: it found no reader.
            OutputError: it could not be written.
            Exception: whatever else writing it raised.
        """
        with self._changed:
            self._changed.wait_for(lambda: self._error is not None or not (self._waiting or self._writing), seconds)
            if self._error is not None:
                raise self._error

    def __enter__(self) -> Outbox:
        self._thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None) -> None:
        with self._changed:
            self._ending = True
            self._changed.notify_all()
        self._thread.join(None if kind is None else PATIENCE)
        if self._thread.is_alive():
            drop_output()
            self._thread.join()
        if self.unread:
            lines = f"{self.unread:,} line{'s' * (self.unread != 1)}"
            note(f"warning: {lines} of what happened found no reader for so long that there was no room: they are lost")
        if kind is None and self._error is not None:
            raise self._error

    def _work(self) -> None:
        while (write := self._next()) is not None:
            try:
                write()
            except Exception as error:  # nothing after it could be written: whoever tells next is to hear of it
                with self._changed:
                    self._error = error
                    self._waiting.clear()
                    self._changed.notify_all()
                if self.on_failure is not None:
                    self.on_failure()
                return

    def _next(self) -> Callable[[], object] | None:
        with self._changed:
            self._writing = False
            self._changed.notify_all()
            while not self._waiting:
                if self._ending:
                    return None
                self._changed.wait()
            self._writing = True
            return self._waiting.popleft()
