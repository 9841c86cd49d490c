"""What the executor tells: events, and a dispatcher that keeps listeners away from the executor's lock and time."""

from __future__ import annotations

import logging
import queue
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from intent_engine.actions import Action, to_json
from intent_engine.execution.goal import Feedback, Goal, GoalState, Reason, settle

__all__ = ["Event", "EventKind", "Listener"]

log = logging.getLogger(__name__)


class EventKind(StrEnum):
    """What happened."""

    GOAL = "goal"
    """A goal changed its state."""
    FEEDBACK = "feedback"
    DENY = "deny"
    """It was said that something shall not be done; a stop follows if it was."""
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
    denied: tuple[Action, ...] = ()
    """What shall not be done."""

    def to_json(self) -> dict[str, Any]:
        """A plain dictionary without what is empty."""
        data: dict[str, Any] = {"event": self.kind.value, "time": self.time}
        if self.goal is not None:
            data["goal"] = self.goal.id
            data["action"] = self.goal.action.type
        if self.state is not None:
            data["state"] = self.state.value
        if self.denied:
            data["denied"] = [to_json(action) for action in self.denied]
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


class _Lane:
    """One listener, and a thread that calls it with what comes, in order; it holds up nobody else."""

    def __init__(self, call: Listener, name: str) -> None:
        self.call = call
        # Re-entrant, unlike queue.Queue: a signal handler may stop the executor in the middle of a put.
        self._events: queue.SimpleQueue[Event | threading.Event | None] = queue.SimpleQueue()
        self.put: Callable[[Event | threading.Event | None], object] = self._events.put
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def begin(self) -> None:
        """Deliver what was put, and what is put from now on."""
        self._thread.start()

    def mark(self) -> threading.Event:
        """Is set when all that was put until now has been delivered; at once for the listener itself."""
        mark = threading.Event()
        if self._thread is threading.current_thread():
            mark.set()
        else:
            self.put(mark)
        return mark

    def end(self, timeout: float) -> None:
        """Deliver what is waiting, for ``timeout`` s at the most."""
        self.put(None)
        if self._thread is not threading.current_thread():
            self._thread.join(timeout)

    def _run(self) -> None:
        while (event := self._events.get()) is not None:
            if isinstance(event, threading.Event):
                event.set()
                continue
            try:
                _deliver(self.call, event)
            except BaseException:  # sys.exit() in a listener, say: it ends neither this thread nor the program
                log.exception("a listener raised on %s", event.kind.value)


class Dispatcher:
    """Calls listeners and handlers outside the executor's lock, in the order in which things happened.

    With ``threaded`` each listener has a thread of its own, so that one that is slow, hangs or raises delays nothing
    else, the results of goals least of all; without (a virtual clock) all are called in the thread that moves the
    clock, when it calls :meth:`flush`. A listener that raises is logged and called again for the next event.

    Args:
        now: the executor's clock.
        threaded: see above.
    """

    def __init__(self, now: Callable[[], float], threaded: bool) -> None:
        self._now = now
        self._threaded = threaded
        self._outbox: queue.SimpleQueue[Event | Callable[[], None]] = queue.SimpleQueue()
        """Without threads: what waits for a flush. Re-entrant, as the lanes are."""
        self._flushing = threading.Lock()
        self._listeners: tuple[Listener, ...] = ()
        self._lanes: tuple[_Lane, ...] = (_Lane(_settled, "executor-results"),) if threaded else ()
        for lane in self._lanes:
            lane.begin()

    def subscribe(self, listener: Listener) -> Callable[[], None]:
        """Call ``listener`` with each event from now on; returns what ends this."""
        if not self._threaded:
            self._listeners = (*self._listeners, listener)

            def forget() -> None:
                self._listeners = tuple(other for other in self._listeners if other is not listener)

            return forget
        lane = _Lane(listener, "executor-events")

        def unsubscribe() -> None:
            if lane in self._lanes:
                self._lanes = tuple(other for other in self._lanes if other is not lane)
                lane.put(None)

        try:
            self._lanes = (*self._lanes, lane)
            lane.begin()
        except BaseException:  # Ctrl-C, or there is no thread: nobody else could end it
            unsubscribe()
            raise
        return unsubscribe

    def tell(
        self,
        kind: EventKind,
        goal: Goal | None = None,
        *,
        reason: Reason = Reason.NONE,
        detail: str = "",
        feedback: Feedback | None = None,
        denied: tuple[Action, ...] = (),
    ) -> None:
        """Let the listeners know, later and outside the executor's lock."""
        if goal is not None:
            reason, detail = goal.reason, goal.detail
        state = goal.state if goal is not None else None
        event = Event(kind, self._now(), goal, state, reason, detail, feedback, denied)
        lanes = self._lanes
        if not self._threaded:
            self._outbox.put(event)
        for lane in lanes:
            lane.put(event)
        if lanes and not self._lanes:  # closed just now: it may lie behind the ends of the lanes
            self._outbox.put(event)

    def launch(self, work: Callable[[], None]) -> None:
        """Do the work of a handler: in a thread of its own, so that a slow one holds up no listener."""
        if self._threaded:
            threading.Thread(target=work, name="handler", daemon=True).start()
        else:
            self._outbox.put(work)

    def flush(self) -> None:
        """Without threads, or when they have ended: do what is waiting. If another thread is at it, that one does it
        all."""
        while not self._outbox.empty() and self._flushing.acquire(blocking=False):
            try:
                while True:
                    try:
                        item = self._outbox.get_nowait()
                    except queue.Empty:
                        break
                    self._do(item)
            finally:
                self._flushing.release()

    def settle(self, timeout: float) -> bool:
        """Wait until all that was told has been delivered; False if that takes longer than ``timeout`` s."""
        self.flush()
        end = time.monotonic() + timeout
        marks = [lane.mark() for lane in self._lanes]
        return all(mark.wait(max(end - time.monotonic(), 0.0)) for mark in marks)

    def close(self, timeout: float = 1.0) -> None:
        """Deliver what is waiting, for ``timeout`` s at the most, then end the threads."""
        self.flush()
        self._threaded = False  # what ends from now on is told by who ends it
        lanes, self._lanes = self._lanes, ()
        end = time.monotonic() + timeout
        for lane in lanes:
            lane.end(max(end - time.monotonic(), 0.0))

    def disown(self) -> None:
        """In a child that was forked, which has none of the threads: who waits for a goal is woken all the same."""
        self._threaded, self._lanes, self._listeners = False, (), ()
        self._outbox, self._flushing = queue.SimpleQueue(), threading.Lock()

    def _do(self, item: Event | Callable[[], None]) -> None:
        if isinstance(item, Event):
            for listener in (_settled, *self._listeners):
                _deliver(listener, item)
            return
        try:
            item()
        except Exception:
            log.exception("a call of the executor raised")


def _settled(event: Event) -> None:
    """Wake those who wait for the future of a goal that has ended."""
    if event.kind is EventKind.GOAL and event.goal is not None and event.state is not None and event.state.ended:
        settle(event.goal)


def _deliver(listener: Listener, event: Event) -> None:
    try:
        listener(event)
    except Exception:
        log.exception("a listener raised on %s", event.kind.value)
