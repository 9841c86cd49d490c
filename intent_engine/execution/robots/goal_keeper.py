"""Which navigation goal is driven and which must end: the rules, without middleware, thread or clock of their own.

A goal and a request to cancel it travel on different roads, and the cancel may arrive first: the server then knows of
nothing to cancel, answers so, and drives. So a cancel is sent again until the goal is seen to have ended, and a new
goal waits until every cancel has been answered, lest a late one should end it.
"""

from __future__ import annotations

import logging
import math
import uuid as uuids
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

from intent_engine.execution.robots.remote_task import RemoteTask
from intent_engine.execution.robots.robot import Pose, TaskState

__all__ = ["ABORTED", "CANCELED", "CANCELING", "SUCCEEDED", "GoalKeeper", "GoalLink"]

log = logging.getLogger(__name__)

# action_msgs/msg/GoalStatus
ACCEPTED, EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = range(1, 7)
ACTIVE = frozenset({ACCEPTED, EXECUTING, CANCELING})


class GoalLink(Protocol):
    """What the keeper needs of the middleware. All calls are quick and raise nothing."""

    names_goals: bool
    """Whether the server knows a goal under the UUID that we gave it; if not, it is found by its newness."""

    def unavailable(self) -> str:
        """Why no goal can be given now; empty if one can."""
        ...

    def servers(self) -> frozenset[bytes]:
        """Who tells the states of goals; a server that is started anew is another one."""
        ...

    def send(self, goal: Pose, uuid: bytes) -> None: ...

    def cancel(self, uuid: bytes | None, number: int) -> bool:
        """Ask the server to end a goal (None: all that it has). False: there is no server to ask.

        Its answer comes back as ``heard_cancel``.
        """
        ...


@dataclass(slots=True)
class _Sent:
    """A goal on its way or being driven."""

    task: RemoteTask
    uuid: bytes | None
    """None until it is known."""
    before: frozenset[bytes]
    """Goals that the server had when this one was sent."""
    at: float
    taken: bool = False
    """The server has it."""
    cancelling: float | None = None
    """Since when it must end."""
    servers: frozenset[bytes] = frozenset()
    """Who was there when the server first named it; nobody: it has not yet."""
    missing: float | None = None
    """Since when the server, which had it, does not name it any more, or another server has come."""
    gone: float | None = None
    """Since when there is no server."""
    aborted: float | None = None
    """Since when it is known to have failed, and the reason is waited for."""
    whole: float = 0.0
    """m: the longest way that was left."""


class GoalKeeper:
    """One robot's navigation goals, one at a time. Told the time by its owner, and used from one thread only."""

    RESEND = 0.05
    """s between two cancels of a goal that goes on."""
    BETWEEN_STOPS = 0.01
    """s between the cancels of two stops that follow each other."""
    RESEND_CANCELING = 0.5
    """s, once the server has said that it is ending the goal."""
    APPEAR = 3.0
    """s for a goal that was sent to be taken by the server."""
    PATIENCE = 5.0
    """s of cancelling a goal that was never seen, or others' goals that do not end."""
    ANSWER = 1.0
    """s after which an unanswered cancel is taken for lost."""
    GONE = 2.0
    """s without a server, or without a word of the goal, after which it has failed."""
    GRACE = 0.5
    """s for the reason of a failure to follow it."""

    def __init__(self, link: GoalLink) -> None:
        self._link = link
        self._current: _Sent | None = None
        self._waiting: tuple[RemoteTask, Pose] | None = None
        self._statuses: dict[bytes, int] = {}
        self._asked = self._answered = 0
        """Number of the last cancel that was sent, and of the last that was answered."""
        self._asked_at = -math.inf
        self._cancel_at = -math.inf
        """When the next cancel may be sent."""
        self._sweep: tuple[float, int] | None = None
        """A stop: since when every goal must end, and how many cancels had been sent before it."""

    @property
    def quiet(self) -> bool:
        """Nothing is driven by us and nothing has to be ended."""
        return self._current is None and self._waiting is None and self._sweep is None

    # -- commands ----------------------------------------------------------------------------------------------------

    def navigate(self, task: RemoteTask, goal: Pose, now: float) -> None:
        """Drive to ``goal``, once whatever was before it has ended."""
        if self._waiting is not None:
            self._waiting[0].end(TaskState.CANCELED, "another goal came")
        self._waiting = (task, goal)
        if self._current is not None:
            self._must_end(self._current, now)
        self.step(now)

    def cancel(self, task: RemoteTask, now: float) -> None:
        """End one goal."""
        if self._waiting is not None and self._waiting[0] is task:
            self._waiting = None
            task.end(TaskState.CANCELED, "cancelled")
        elif self._current is not None and self._current.task is task:
            self._must_end(self._current, now)
        self.step(now)

    def stop(self, now: float) -> None:
        """End every goal of the server, whoever gave it: who says stop wants the robot to stand."""
        if self._waiting is not None:
            self._waiting[0].end(TaskState.CANCELED, "stopped")
            self._waiting = None
        if self._current is not None:
            self._must_end(self._current, now)
        self._cancel_at = max(now, self._asked_at + self.BETWEEN_STOPS)
        self._sweep = (now, self._asked)
        self.step(now)

    # -- what is heard -----------------------------------------------------------------------------------------------

    def heard_status(self, statuses: Mapping[bytes, int], now: float) -> None:
        """All goals that the server has, in the order in which it took them, each with its state."""
        self._statuses = dict(statuses)
        sent = self._current
        if sent is not None:
            if sent.uuid is None:
                sent.uuid = next((uuid for uuid in statuses if uuid not in sent.before), None)
            code = statuses.get(sent.uuid) if sent.uuid is not None else None
            if code is not None:
                sent.taken, sent.missing = True, None
                sent.servers = sent.servers or self._link.servers()
                self._heard_state(sent, code, now)
            elif sent.taken and sent.missing is None:
                sent.missing = now
        if self._ending_anything():
            # What goes on is asked to end as soon as it is heard of, not at the next tick.
            self._cancel_at = min(self._cancel_at, now)
        self.step(now)

    def heard_answer(self, uuid: bytes, accepted: bool, now: float) -> None:
        """The server took a goal, or refused it."""
        sent = self._current
        if sent is not None and sent.uuid == uuid:
            if accepted:
                sent.taken = True
                if sent.cancelling is not None:
                    self._cancel_at = now
            else:
                self._end(sent, TaskState.FAILED, "the navigation server refused the goal")
        self.step(now)

    def heard_result(self, uuid: bytes, code: int, reason: str, now: float) -> None:
        """How a goal ended, and why."""
        sent = self._current
        if sent is not None and sent.uuid == uuid:
            if code == SUCCEEDED:
                self._end(sent, TaskState.SUCCEEDED, "")
            elif code == CANCELED:
                self._end(sent, TaskState.CANCELED, reason or "cancelled")
            else:
                self._end(sent, TaskState.FAILED, reason or "the navigation gave up and did not say why")
        self.step(now)

    def heard_cancel(self, number: int, refused: bool, now: float) -> None:
        """The server answered a cancel. That it will end a goal does not matter, the goals' states do; a no does."""
        self._answered = max(self._answered, number)
        if refused and self._sweep is not None:
            # There is something that drives, whether we have heard of it or not: this was not the last cancel.
            since, before = self._sweep
            self._sweep = (since, max(before, number))
        self.step(now)

    def heard_progress(self, uuid: bytes, left: float) -> None:
        """m that are left of the way of a goal."""
        sent = self._current
        if sent is not None and sent.uuid == uuid and math.isfinite(left):
            sent.whole = max(sent.whole, left)
            sent.task.progress = min(max(1.0 - left / sent.whole, 0.0), 1.0) if sent.whole > 0 else None

    # -- time --------------------------------------------------------------------------------------------------------

    def due(self, now: float) -> float | None:
        """When :meth:`step` has something to do, if nothing is heard before."""
        if self.quiet:
            return None
        return max(now, min(self._cancel_at, now + self.RESEND)) if self._ending_anything() else now + 0.2

    def lost(self, reason: str) -> None:
        """The server cannot be asked or heard any more: who waits for a goal is told so."""
        tasks = [self._current.task] if self._current is not None else []
        for task in [*tasks, *([self._waiting[0]] if self._waiting is not None else [])]:
            task.end(TaskState.FAILED, reason)

    def step(self, now: float) -> None:
        """Do what is due."""
        if self._current is not None:
            self._look(self._current, now)
        if self._sweep is not None:
            self._look_at_sweep(*self._sweep, now)
        if self._ending_anything() and now >= self._cancel_at:
            self._send_cancel(now)
        unanswered = self._asked > self._answered and now - self._asked_at < self.ANSWER
        if self._waiting is not None and self._current is None and self._sweep is None and not unanswered:
            (task, goal), self._waiting = self._waiting, None
            self._send(task, goal, now)

    # -- inside ------------------------------------------------------------------------------------------------------

    def _send(self, task: RemoteTask, goal: Pose, now: float) -> None:
        why = self._link.unavailable()
        if why:
            task.end(TaskState.FAILED, why)
            return
        uuid = uuids.uuid4().bytes
        self._current = _Sent(task, uuid if self._link.names_goals else None, frozenset(self._statuses), now)
        self._link.send(goal, uuid)

    def _must_end(self, sent: _Sent, now: float) -> None:
        if sent.cancelling is None:
            sent.cancelling = now
            self._cancel_at = now

    def _ending_anything(self) -> bool:
        return self._sweep is not None or (self._current is not None and self._current.cancelling is not None)

    def _send_cancel(self, now: float) -> None:
        sent = self._current
        # A goal whose name is not known can only be ended together with all others.
        uuid = sent.uuid if sent is not None and self._sweep is None else None
        if self._link.cancel(uuid, self._asked + 1):
            self._asked += 1
            self._asked_at = now
        elif sent is None:
            self._sweep = None  # no server, no goals
        going_on = any(code in (ACCEPTED, EXECUTING) for code in self._statuses.values())
        unseen = sent is not None and not sent.taken
        self._cancel_at = now + (self.RESEND if going_on or unseen else self.RESEND_CANCELING)

    def _heard_state(self, sent: _Sent, code: int, now: float) -> None:
        if code == SUCCEEDED:
            self._end(sent, TaskState.SUCCEEDED, "")
        elif code == CANCELED:
            self._end(sent, TaskState.CANCELED, "cancelled")
        elif code == ABORTED and sent.aborted is None:
            sent.aborted = now
            if not self._link.names_goals:
                self._end(sent, TaskState.FAILED, "the navigation gave up")

    def _look(self, sent: _Sent, now: float) -> None:
        """What only time tells."""
        sent.gone = None if not self._link.unavailable() else now if sent.gone is None else sent.gone
        if sent.missing is None and sent.servers and self._link.servers() - sent.servers:
            # A server tells states only when they change, and the middleware believes for long in one that was killed.
            sent.missing = now
        if not sent.taken:
            if sent.cancelling is None and now - sent.at >= self.APPEAR:
                # It may still come: then it is ended.
                sent.task.end(TaskState.FAILED, f"the navigation did not take the goal within {self.APPEAR:g} s")
                self._must_end(sent, now)
            elif sent.cancelling is not None and now - sent.cancelling >= self.PATIENCE:
                self._end(sent, TaskState.CANCELED, "the navigation never took the goal")
        elif sent.aborted is not None and now - sent.aborted >= self.GRACE:
            self._end(sent, TaskState.FAILED, "the navigation gave up and did not say why")
        elif sent.missing is not None and now - sent.missing >= self.GONE:
            self._end(sent, TaskState.FAILED, "the navigation was started anew and has forgotten the goal")
        if sent.gone is not None and now - sent.gone >= self.GONE:
            self._end(sent, TaskState.FAILED, f"the navigation is gone: {self._link.unavailable()}")

    def _look_at_sweep(self, since: float, asked_before: int, now: float) -> None:
        active = any(code in ACTIVE for code in self._statuses.values())
        if self._current is None and not active and self._answered > asked_before:
            self._sweep = None
        elif now - since >= self.PATIENCE:
            self._sweep = None
            if active:
                log.error("navigation goals go on, although all were cancelled %.0f times", self._asked - asked_before)

    def _end(self, sent: _Sent, state: TaskState, reason: str) -> None:
        if self._current is sent:
            self._current = None
        if sent.cancelling is not None and state is TaskState.FAILED:
            # Nav2 and others call it aborted when a goal was replaced or taken back.
            state = TaskState.CANCELED
        sent.task.end(state, reason)
