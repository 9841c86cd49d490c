"""Which stop came last, and whether something was asked for before it: that must not begin after it."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from intent_engine.execution.events import EventKind
from intent_engine.execution.goal import Reason

__all__ = ["StopCall", "Stops"]


@dataclass(frozen=True, slots=True, eq=False)
class StopCall:
    """One that was asked for: two are never the same."""

    reason: Reason
    kind: EventKind
    said: float
    """s on the executor's clock, when it was asked for; of a spoken one, when its words ended."""


class Stops:
    """Tells what was asked for before a stop from what was asked for after it. From any thread; takes no lock."""

    def __init__(self) -> None:
        self._latest: StopCall | None = None
        self._said = -math.inf
        self._work = threading.local()
        """``since``: the last stop when the handler began that this thread carries out."""

    @property
    def since(self) -> object:
        """What :meth:`came_after` compares with, for what is asked for now, in this thread. A handler asks as of the
        time when it was begun: one that does several things in turn was stopped with the first of them."""
        return getattr(self._work, "since", self._latest)

    def came_after(self, since: object) -> bool:
        """Whether a stop has been asked for since."""
        return self._latest is not since

    def came_after_words(self, spoken: float | None) -> bool:
        """Whether a stop was said after words that ended at ``spoken`` s; None: they were not spoken."""
        return spoken is not None and spoken < self._said

    def asked(self, stop: StopCall) -> None:
        """Somebody asks for a stop. What a handler does after a stop of its own is its own to say."""
        if getattr(self._work, "since", stop) is self._latest:
            self._work.since = stop
        self._latest = stop

    def entered(self, stops: Iterable[StopCall]) -> None:
        """Under the executor's lock: what they end has ended."""
        self._said = max(self._said, *(stop.said for stop in stops))

    def carrying_out(self, work: Callable[[], None]) -> Callable[[], None]:
        """The work of a handler that begins now, in whatever thread it is done."""
        since = self._latest

        def do() -> None:
            before = self._work.__dict__.copy()
            self._work.since = since
            try:
                work()
            finally:
                self._work.__dict__.clear()
                self._work.__dict__.update(before)

        return do
