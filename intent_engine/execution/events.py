"""What the executor tells: events, and a dispatcher that keeps listeners away from the executor's lock and time."""

from __future__ import annotations

import logging
import queue
import threading
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from intent_engine.execution.goal import Feedback, Goal, GoalState, Reason, settle

__all__ = ["Event", "EventKind", "Listener"]

log = logging.getLogger(__name__)


class EventKind(StrEnum):
    """What happened."""

    GOAL = "goal"
    """A goal changed its state."""
    FEEDBACK = "feedback"
    STOP = "stop"
    ESTOP = "estop"
    RESET = "reset"
    HOLD = "hold"
    RELEASE = "release"
    PAUSE = "pause"
    RESUME = "resume"
    ERROR = "error"
    """Something failed that belongs to no goal: the velocity loop died, the robot raised in a stop."""


@dataclass(frozen=True, slots=True)
class Event:
    """One thing that happened; ``state``, ``reason`` and ``feedback`` are those of that moment."""

    kind: EventKind
    time: float
    """s on the executor's clock"""
    goal: Goal | None = None
    state: GoalState | None = None
    reason: Reason = Reason.NONE
    detail: str = ""
    feedback: Feedback | None = None

    def to_json(self) -> dict[str, Any]:
        """A plain dictionary without what is empty."""
        data: dict[str, Any] = {"event": self.kind.value, "time": self.time}
        if self.goal is not None:
            data["goal"] = self.goal.id
            data["action"] = self.goal.action.type
        if self.state is not None:
            data["state"] = self.state.value
        if self.reason:
            data["reason"] = self.reason.value
        if self.detail:
            data["detail"] = self.detail
        if self.feedback is not None:
            data["progress"] = self.feedback.progress
            data["time_left"] = self.feedback.time_left
            if self.feedback.pose is not None:
                pose = self.feedback.pose
                data["pose"] = {"x": pose.x, "y": pose.y, "yaw": pose.yaw, "frame": pose.frame}
        return data


Listener = Callable[[Event], object]


class Dispatcher:
    """Calls listeners and handlers outside the executor's lock, in the order in which things happened.

    With ``threaded`` they run in a thread of its own, so that a slow listener delays other listeners and nothing
    else; without (a virtual clock) in the thread that moves the clock, when it calls :meth:`flush`.
    A listener that raises is logged and called again for the next event.

    Args:
        now: the executor's clock.
        threaded: see above.
    """

    def __init__(self, now: Callable[[], float], threaded: bool) -> None:
        self._now = now
        self._threaded = threaded
        # Re-entrant, unlike queue.Queue: a signal handler may stop the executor in the middle of a put.
        self._outbox: queue.SimpleQueue[Event | Callable[[], None] | None] = queue.SimpleQueue()
        self._listeners: list[Listener] = []
        self._flushing = threading.Lock()
        self._thread: threading.Thread | None = None
        if threaded:
            self._thread = threading.Thread(target=self._run, name="executor-events", daemon=True)
            self._thread.start()

    def subscribe(self, listener: Listener) -> Callable[[], None]:
        """Call ``listener`` with each event from now on; returns what ends this."""
        self._listeners = [*self._listeners, listener]

        def unsubscribe() -> None:
            self._listeners = [other for other in self._listeners if other is not listener]

        return unsubscribe

    def tell(
        self,
        kind: EventKind,
        goal: Goal | None = None,
        *,
        reason: Reason = Reason.NONE,
        detail: str = "",
        feedback: Feedback | None = None,
    ) -> None:
        """Let the listeners know, later and outside the executor's lock."""
        if goal is not None:
            reason, detail = goal.reason, goal.detail
        state = goal.state if goal is not None else None
        self._outbox.put(Event(kind, self._now(), goal, state, reason, detail, feedback))

    def launch(self, work: Callable[[], None]) -> None:
        """Do the work of a handler: in a thread of its own, so that a slow one holds up no listener."""
        if self._threaded:
            threading.Thread(target=work, name="handler", daemon=True).start()
        else:
            self._outbox.put(work)

    def flush(self) -> None:
        """Without a thread: do what is waiting. If another thread is at it, that one does it all."""
        if self._threaded:
            return
        while not self._outbox.empty() and self._flushing.acquire(blocking=False):
            try:
                while True:
                    try:
                        item = self._outbox.get_nowait()
                    except queue.Empty:
                        break
                    if item is not None:
                        self._do(item)
            finally:
                self._flushing.release()

    def close(self, timeout: float = 1.0) -> None:
        """Deliver what is waiting, then end the thread."""
        if self._thread is None:
            self.flush()
            return
        thread, self._thread = self._thread, None
        self._outbox.put(None)
        if thread is not threading.current_thread():
            thread.join(timeout)

    def _run(self) -> None:
        while (item := self._outbox.get()) is not None:
            self._do(item)

    def _do(self, item: Event | Callable[[], None]) -> None:
        if not isinstance(item, Event):
            try:
                item()
            except Exception:
                log.exception("a call of the executor raised")
            return
        if item.kind is EventKind.GOAL and item.goal is not None and item.state is not None and item.state.ended:
            settle(item.goal)
        for listener in self._listeners:
            try:
                listener(item)
            except Exception:
                log.exception("a listener raised on %s", item.kind.value)
