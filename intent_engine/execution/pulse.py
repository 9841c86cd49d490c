"""What is due is done: by the executor's thread, by a clock that is moved, or by whoever enters something new."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

from intent_engine.execution.books import Books
from intent_engine.execution.clock import Clock
from intent_engine.execution.conductor import Conductor
from intent_engine.execution.events import Dispatcher, EventKind
from intent_engine.execution.goal import Reason
from intent_engine.execution.raised import with_type

__all__ = ["Pulse"]


class Pulse:
    """Moves the conductor on.

    Args:
        books: whose lock it is.
        conductor: is moved on.
        events: is told what broke it off.
        clock: gives the time, and wakes the thread.
    """

    def __init__(self, books: Books, conductor: Conductor, events: Dispatcher, clock: Clock) -> None:
        self._books = books
        self._conductor = conductor
        self._events = events
        self._clock = clock

    def due(self) -> float | None:
        """When something is to be done; None: never."""
        with self._books.lock:
            now = self._clock.now()
            return now if self._books.due else self._conductor.due(now)

    def step(self) -> None:
        """Do what is due now, and let everybody hear of it: for a clock that is moved."""
        with self._books.locked() as now:
            self.advance(now)
        self._events.flush()

    @contextlib.contextmanager
    def whole(self) -> Iterator[None]:
        """Something is done to its end: whatever breaks it off has stopped the robot before it goes on."""
        try:
            yield
        except BaseException as error:  # Ctrl-C, or a robot's sys.exit(): perhaps behind a velocity that was written
            self._events.tell(EventKind.ERROR, detail=with_type(error))
            self._conductor.stop(Reason.ROBOT_ERROR, EventKind.STOP, self._clock.now())
            raise

    def advance(self, now: float) -> None:
        """Do what is due, under the lock of the books."""
        self._books.looked()
        try:
            with self.whole():
                self._conductor.advance(now)
        finally:
            self._books.wake.notify_all()

    def run(self) -> None:
        """Do what is due, whenever it is, until the conductor is closed: for a thread of its own."""
        with self._books.lock:
            while not self._conductor.closed:
                # Without this thread no goal would end. What breaks it off has been told of, and the robot is stopped.
                with contextlib.suppress(BaseException), self._books.locked() as now:
                    self.advance(now)
                self._clock.wait_until(self._books.wake, self.due())
            with self._books.locked():
                pass  # a stop that did not get the lock of a robot that hung, as it was closed, is entered
        self._events.flush()
