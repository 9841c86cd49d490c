"""A goal: one action on its way through the executor.

The states are those of ROS 2's ``GoalStatus``, with ``pending`` before and ``rejected`` beside them::

    pending -> accepted -> executing -> succeeded
       |          |            |-----> canceling -> canceled, aborted
       |          |            `-----> aborted, canceled
       |          `-> canceled, aborted
       `-> rejected

Nav2 and others report a preemption as *aborted*; that is why each end has a :class:`Reason` beside its state.
"""

from __future__ import annotations

import asyncio
import itertools
import threading
import weakref
from collections.abc import Callable, Generator
from concurrent.futures import Future
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Any

from intent_engine.actions import Action, to_json
from intent_engine.execution.robots.robot import Pose

if TYPE_CHECKING:
    from intent_engine.execution.leases import Lease

__all__ = ["Feedback", "Goal", "GoalState", "Guard", "Reason", "Times"]

Guard = Callable[[], str]
"""Why an action must not begin now, in words; empty: it may."""


class GoalState(StrEnum):
    """How a goal stands."""

    PENDING = "pending"
    ACCEPTED = "accepted"
    EXECUTING = "executing"
    CANCELING = "canceling"
    SUCCEEDED = "succeeded"
    CANCELED = "canceled"
    ABORTED = "aborted"
    REJECTED = "rejected"

    @property
    def ended(self) -> bool:
        return self in _ENDED


_ENDED = frozenset({GoalState.SUCCEEDED, GoalState.CANCELED, GoalState.ABORTED, GoalState.REJECTED})

_NEXT = {
    GoalState.PENDING: {GoalState.ACCEPTED, GoalState.REJECTED},
    GoalState.ACCEPTED: {GoalState.EXECUTING, GoalState.CANCELED, GoalState.ABORTED},
    GoalState.EXECUTING: {GoalState.SUCCEEDED, GoalState.CANCELING, GoalState.CANCELED, GoalState.ABORTED},
    GoalState.CANCELING: {GoalState.CANCELED, GoalState.ABORTED},
}


class Reason(StrEnum):
    """Why a goal ended as it did."""

    NONE = ""
    """It succeeded as it was asked, or has not ended."""
    STOP = "stop"
    ESTOP = "estop"
    """An emergency stop, now or since; :meth:`Executor.reset` lets the robot move again."""
    PREEMPTED = "preempted"
    """A newer command took its place."""
    CANCELED = "canceled"
    """Somebody cancelled this goal alone."""
    TIMEOUT = "timeout"
    ROBOT_ERROR = "robot_error"
    HANDLER_ERROR = "handler_error"
    NO_HANDLER = "no_handler"
    """An action of a type that nobody registered for."""
    CAPABILITY = "capability"
    """This robot cannot do that at all."""
    EXPIRED = "expired"
    """The words ended too long ago."""
    LIMIT = "limit"
    BUSY = "busy"
    """Something else is being done, and the policy is to refuse."""
    FORBIDDEN = "forbidden"
    """Its turn came, and what was allowed when it was asked for is not any more: the robot is in other states."""
    NOTHING_MOVES = "nothing_moves"
    """It is about the motion that is carried out, and there is none."""
    EARLIER_FAILED = "earlier_failed"
    """An earlier step of the same utterance did not succeed."""
    HOLD_EXPIRED = "hold_expired"
    """The robot was held and nobody released it."""
    VELOCITY_LOOP = "velocity_loop"
    """The process that owns the velocity died or fell silent; no motion until :meth:`Executor.reset`."""
    WATCHDOG = "watchdog"
    """This program was silent for longer than a velocity is valid, and the velocity loop stopped the robot; or it was
    away for seconds and woke, and does not drive on."""
    CLOSED = "closed"


@dataclass(frozen=True, slots=True)
class Times:
    """When a goal changed its state, in s on the executor's clock; None where it has not (yet)."""

    submitted: float
    spoken: float | None = None
    """End of the words, if they were spoken."""
    accepted: float | None = None
    started: float | None = None
    ended: float | None = None


@dataclass(frozen=True, slots=True)
class Feedback:
    """How far a goal has come."""

    progress: float | None
    """0 to 1; None where nobody can tell"""
    time_left: float | None
    """s; None where nobody can tell"""
    travelled: float | None = None
    """m or rad, for a move or turn; signed"""
    pose: Pose | None = None
    """Where the robot believes it is."""


_ids = itertools.count(1)


class Goal:
    """One action, its state and its end. Only the executor changes it; everybody may read it, from any thread.

    ``goal.result()`` waits for the end in a thread, ``await goal`` in a coroutine; both return the goal itself, whose
    ``state``, ``reason`` and ``detail`` say how it ended. Neither raises because the *robot* failed.
    """

    def __init__(
        self,
        action: Action,
        submitted: float,
        spoken: float | None = None,
        utterance: int = 0,
        text: str | None = None,
        *,
        wait: Callable[[Goal, float | None], None] | None = None,
        askers: tuple[weakref.ref[Lease], ...] = (),
        part_of: tuple[Action, ...] = (),
    ) -> None:
        self.id = next(_ids)
        self.action = action
        """What is done: cut down to the limits, if the robot's file says so."""
        self.asked = action
        """What was asked for."""
        self.utterance = utterance
        """Number of the call of ``submit`` that it came from, or of the one that it follows."""
        self.text = text
        """What was said, if the caller told."""
        self.detail = ""
        """The reason in words; for a clamped action also when it succeeded."""
        self.reason = Reason.NONE
        self.state = GoalState.PENDING
        self.feedback = Feedback(None, None)
        self.times = Times(submitted, spoken)
        self._future: Future[Goal] = Future()
        self._future.set_running_or_notify_cancel()
        self._lock = threading.RLock()  # a signal handler may stop while the goal changes its state
        self._wait = wait  # of its executor
        # For its executor alone:
        self.askers = askers  # leases of the handlers that asked for it, if any did
        self.part_of = part_of  # what those handlers carry out, or did

    @property
    def done(self) -> bool:
        return self.state.ended

    @property
    def succeeded(self) -> bool:
        return self.state is GoalState.SUCCEEDED

    def is_of(self, executor: object) -> bool:
        """Whether it may be a goal of an executor: of no other."""
        return getattr(self._wait, "__self__", executor) is executor

    def result(self, timeout: float | None = None) -> Goal:
        """Wait for the end. On a virtual clock this moves the clock.

        Raises:
            TimeoutError: ``timeout`` s went by first.
        """
        if self._wait is not None:
            self._wait(self, timeout)
            return self
        return self._future.result(timeout)

    def add_done_callback(self, callback: Callable[[Goal], None]) -> None:
        """Call when the goal has ended (at once if it has). An exception in it is logged and goes no further."""
        if not callable(callback):
            raise TypeError(f"add_done_callback takes a function that takes the goal, not {callback!r:.80}")
        self._future.add_done_callback(lambda future: callback(future.result()))

    def future(self) -> Future[Goal]:
        """A :class:`concurrent.futures.Future` of this goal, for ``concurrent.futures.wait`` and the like."""
        copy: Future[Goal] = Future()
        copy.set_running_or_notify_cancel()
        self._future.add_done_callback(lambda done: copy.set_result(done.result()))
        return copy

    def __await__(self) -> Generator[Any, None, Goal]:
        return asyncio.wrap_future(self.future()).__await__()

    def to_json(self) -> dict[str, Any]:
        """A plain dictionary, as the journal writes it."""
        data: dict[str, Any] = {
            "id": self.id,
            "utterance": self.utterance,
            "action": to_json(self.action) if hasattr(self.action, "__dataclass_fields__") else repr(self.action),
            "state": self.state.value,
            "reason": self.reason.value,
            "detail": self.detail,
            "times": {
                "spoken": self.times.spoken,
                "submitted": self.times.submitted,
                "accepted": self.times.accepted,
                "started": self.times.started,
                "ended": self.times.ended,
            },
            "progress": self.feedback.progress,
            "travelled": self.feedback.travelled,
        }
        if self.text is not None:
            data["text"] = self.text
        return data

    def __reduce__(self) -> str:
        raise TypeError(
            "a Goal belongs to its executor, and cannot be copied or pickled, nor can an event of it: hand on "
            "goal.action, or what goal.to_json() and event.to_json() give"
        )

    def __repr__(self) -> str:
        why = f" ({self.reason.value}: {self.detail})" if self.reason else ""
        return f"<Goal {self.id} {self.action!r} {self.state.value}{why}>"


def move_goal(goal: Goal, state: GoalState, now: float, reason: Reason = Reason.NONE, detail: str = "") -> None:
    """Change a goal's state; the executor's part of :class:`Goal`. Does not wake those who wait: see ``settle``. A goal
    that a signal handler ends in the midst of this stays as that has left it.

    Raises:
        RuntimeError: the change is not one of the diagram above (a goal ends once).
    """
    with goal._lock:
        before, times = goal.state, goal.times
        if state not in _NEXT.get(before, ()):
            raise RuntimeError(f"goal {goal.id} cannot go from {goal.state.value} to {state.value}")
        if state is GoalState.ACCEPTED:
            times = Times(times.submitted, times.spoken, now)
        elif state is GoalState.EXECUTING:
            times = Times(times.submitted, times.spoken, times.accepted, now)
        elif state.ended:
            times = Times(times.submitted, times.spoken, times.accepted, times.started, now)
        if goal.state is not before:
            return
        goal.times = times
        if reason:
            goal.reason = reason
        if detail:
            goal.detail = detail
        goal.state = state


def settle(goal: Goal) -> None:
    """Wake those who wait for a goal that has ended. Called outside the executor's lock."""
    if not goal._future.done():
        goal._future.set_result(goal)
