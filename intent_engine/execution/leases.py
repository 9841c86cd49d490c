"""The lease that a handler has on the robot: what it submits is done until another command takes the robot over.

A handler cannot be ended from outside, and may submit without looking whether it still has its turn. Its lease follows
it by a context variable: into the coroutines and tasks of :mod:`asyncio` that it starts, in whatever loop, and into
threads that are started in a copy of its context.
"""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterable
from contextvars import ContextVar

from intent_engine.actions import Action
from intent_engine.execution.goal import Goal, GoalState, Reason
from intent_engine.execution.runs import Ending

__all__ = ["Lease", "Leases"]

_WHY = {
    Reason.PREEMPTED: "another command has come since it began",
    Reason.CANCELED: "it was cancelled",
    Reason.TIMEOUT: "it took too long",
    Reason.HOLD_EXPIRED: "the robot was held, and nobody released it",
}


class Lease:
    """One handler's, from its beginning until nobody can ask for anything in its name."""

    def __init__(self, goal: Goal, since: object, leases: Leases, within: Lease | None) -> None:
        self.goal = goal
        """Whose handler has it."""
        self.since = since
        """The last stop when it began, or the handler's own since."""
        self.lost = Reason.NONE
        """Why it is over."""
        self.works = True
        """The handler has not returned."""
        self.leases = leases
        self.within = within
        """What the same thread, or task, was doing around it: the handler of another executor, perhaps."""


_held: ContextVar[Lease | None] = ContextVar("lease", default=None)


class Leases:
    """Who has a lease on one robot, and who has lost it. Under the executor's lock, where it does not say otherwise."""

    def __init__(self) -> None:
        self._all: tuple[weakref.ref[Lease], ...] = ()  # never changed in place: a signal handler may come at any time

    @property
    def holder(self) -> Lease | None:
        """Of the handler that asks for something now, in this thread or task; None: it is none. Takes no lock."""
        lease = _held.get()
        while lease is not None and lease.leases is not self:
            lease = lease.within
        return lease

    @property
    def askers(self) -> tuple[weakref.ref[Lease], ...]:
        """The holder, and those that had it begun, the nearest first. Takes no lock."""
        holder = self.holder
        if holder is None:
            return ()
        # Those who can ask for nothing any more are left out: a handler may have begun itself again for days.
        return (weakref.ref(holder), *(giver for giver in holder.goal.askers if giver() is not None))

    @property
    def part_of(self) -> tuple[Action, ...]:
        """What the handler carries out that asks for something now, and what that is a part of. Takes no lock."""
        if (holder := self.holder) is None:
            return ()
        whole: list[Action] = []
        for action in (holder.goal.asked, holder.goal.action, *holder.goal.part_of):
            if action not in whole:  # a handler may have begun itself again for days
                whole.append(action)
        return tuple(whole)

    def at_work(self, since: object) -> list[Goal]:
        """Those whose handlers may still submit something, though they may have ended; ``since``: the last stop."""
        return [lease.goal for lease in _alive(self._all) if lease.works and not lease.lost and lease.since is since]

    def carrying_out(self, goal: Goal, since: object, work: Callable[[], None]) -> Callable[[], None]:
        """The work of a handler that begins now, in whatever thread it is done."""
        lease = Lease(goal, since, self, None)
        self._all = (*(each for each in self._all if each() is not None), weakref.ref(lease))

        def do() -> None:
            lease.within = _held.get()
            before = _held.set(lease)
            try:
                work()
            finally:
                _held.reset(before)
                lease.works = False

        return do

    def taken_over(self, goal: Goal | None, reason: Reason) -> None:
        """The robot is another's now: of the handlers, only those that asked for ``goal`` go on."""
        keep = _alive(goal.askers) if goal is not None else []
        self._end([lease for lease in _alive(self._all) if lease not in keep], reason)

    def cancelled(self, goal: Goal) -> None:
        """Somebody cancels what a handler does, or has asked for; if not a handler what is its own."""
        asking = _alive(self.askers)
        concerned = [*_alive(goal.askers), *self._of(goal)]
        self._end([lease for lease in concerned if lease not in asking], Reason.CANCELED)

    def broken_off(self, goal: Goal, reason: Reason) -> None:
        """The goal of a handler has ended before the handler."""
        self._end(self._of(goal), reason)

    def refusal(self, goal: Goal) -> Ending | None:
        """Why a goal is refused that was asked for by a handler that had to make way."""
        lost = next((lease.lost for lease in _alive(goal.askers) if lease.lost), None)
        if lost is None:
            return None
        why = f"the handler that asks for it has no turn any more: {_WHY.get(lost, lost.value)}"
        return Ending(GoalState.REJECTED, lost, why)

    def _of(self, goal: Goal) -> list[Lease]:
        return [lease for lease in _alive(self._all) if lease.goal is goal]

    def _end(self, leases: Iterable[Lease], reason: Reason) -> None:
        for lease in leases:
            lease.lost = lease.lost or reason


def _alive(askers: Iterable[weakref.ref[Lease]]) -> list[Lease]:
    return [lease for ask in askers if (lease := ask()) is not None]
