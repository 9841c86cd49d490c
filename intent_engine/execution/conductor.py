"""The rules of the executor: which goal is next, which makes way, and what a stop, a hold or a failure ends.

A conductor has no lock, no thread and no clock: it is told the time, and the executor calls it under its lock. It never
asks the robot itself: its runs do, and the failsafe.
"""

from __future__ import annotations

import logging
import math
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, replace

from intent_engine.actions import ChangeSpeed, Stop
from intent_engine.execution import speed_change
from intent_engine.execution.admission import Admission, Policy, Terms, forbidden
from intent_engine.execution.carriers import Carriers
from intent_engine.execution.events import Dispatcher, EventKind
from intent_engine.execution.failsafe import Failsafe, reason_of
from intent_engine.execution.goal import Goal, GoalState, Guard, Reason, move_goal
from intent_engine.execution.handlers import HandlerRun
from intent_engine.execution.motion import Motion, Travel
from intent_engine.execution.raised import pass_on_interrupt, told
from intent_engine.execution.runs import Ending, MotionRun, Run, VelocityLoop
from intent_engine.execution.speed_change import SpeedChange
from intent_engine.execution.stops import Stops

__all__ = ["Conductor"]

log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True, eq=False)
class _Waiting:
    """A goal that waits its turn."""

    goal: Goal
    terms: Terms
    covered: Travel | None
    """How far the goal that it amends has come; None: it amends none."""
    since: object
    """The last stop when it was asked for."""


class Conductor:
    """Carries out one goal at a time on one robot."""

    FEEDBACK_PERIOD = 0.1
    """s between two feedback events of a goal."""

    def __init__(
        self,
        admission: Admission,
        carriers: Carriers,
        loop: VelocityLoop,
        failsafe: Failsafe,
        events: Dispatcher,
        ended: Callable[[], None],
        stops: Stops,
        hold_limit: float,
        queue_limit: int,
    ) -> None:
        """``events`` hear of everything; ``ended`` wakes those who wait for the end of a goal; ``stops`` knows what was
        asked for before a stop."""
        self._admission = admission
        self._carriers = carriers
        self._loop = loop
        self._failsafe = failsafe
        self._events = events
        self._ended = ended
        self._stops = stops
        self._hold_limit, self._queue_limit = hold_limit, queue_limit
        self._queue: deque[_Waiting] = deque()
        self._run: Run | None = None
        self._held_since: float | None = None
        self._feedback_at = math.inf
        self._mute: Run | None = None
        """The last one of which it was said that it tells nothing."""
        self.paused = self.estopped = self.closed = False

    @property
    def idle(self) -> bool:
        return self._run is None and not self._queue

    @property
    def held(self) -> bool:
        return self._held_since is not None

    @property
    def running(self) -> Goal | None:
        return self._run.goal if self._run is not None else None

    @property
    def queued(self) -> int:
        return len(self._queue)

    # -- time --------------------------------------------------------------------------------------------------------

    def due(self, now: float) -> float | None:
        """When :meth:`advance` has something to do."""
        times: list[float] = []
        run, resting = self._run, self.held or self.paused
        if self._held_since is not None:
            times.append(self._held_since + self._hold_limit)
        if run is not None:
            run_due = run.due(now)
            if run_due is not None and not (resting and isinstance(run, MotionRun)):
                times.append(run_due)
            if not resting:
                times.append(self._feedback_at)
        loop_due = self._loop.due()
        if loop_due is not None and self._failsafe.loop_is_asked:
            times.append(loop_due)
        first = min(times, default=math.inf)
        return None if math.isinf(first) else max(first, now)

    def advance(self, now: float) -> None:
        """Do all that is due. Nothing that a robot raises leaves here."""
        if self._held_since is not None and now >= self._held_since + self._hold_limit:
            self.stop(Reason.HOLD_EXPIRED, EventKind.STOP, now)
        while True:
            run = self._run
            try:
                if not isinstance(run, MotionRun) and self._failsafe.loop_is_asked:
                    self._loop.step(now)  # the zeros that end a motion
                if run is None:
                    if not self._begin_next(now):
                        break
                    continue
                ending = run.step(now)
            except BaseException as error:
                pass_on_interrupt(error)
                self._robot_failed(run, error, now)
                continue
            if ending is None:
                break
            self._run = None
            self._end(run.goal, ending, now, run)
        if self._run is not None and now >= self._feedback_at:
            self._give_feedback(self._run, now)

    # -- commands ----------------------------------------------------------------------------------------------------

    def take(
        self,
        goals: list[Goal],
        terms: list[Terms],
        policy: Policy | None,
        now: float,
        since: object,
        amends: Goal | None = None,
    ) -> None:
        """Accept the goals of one utterance, or reject them all. A stop that comes first has been done already.
        ``since``: the last stop when they were asked for."""
        for goal in goals:
            self._events.tell(EventKind.GOAL, goal)
        if isinstance(goals[0].action, Stop):
            # Whatever may be wrong with the rest of the sentence, the stop has happened.
            for state in (GoalState.ACCEPTED, GoalState.EXECUTING):
                self._move(goals[0], state, now)
            self._end(goals[0], Ending(GoalState.SUCCEEDED), now)
            goals, terms = goals[1:], terms[1:]
        if not goals:
            return
        if any(isinstance(goal.action, ChangeSpeed) for goal in goals):
            self._change_speed(goals, terms, now, since)
            return
        policy = policy or self._admission.policy(goals[0].action)
        refusals = [self._refusal(goal, now, since) for goal in goals]
        if not any(refusals) and (full := self._no_room(len(goals), policy)) is not None:
            refusals = [full] * len(goals)
        if self._refuse(goals, refusals, now):
            return
        covered = self._covered_for(goals[0], amends, now) if amends is not None else None
        if policy is Policy.REPLACE:
            self._make_way(goals[0], now)
        before = self._queue[-1].goal if self._queue else self.running
        for goal, its in zip(goals, terms, strict=True):
            if policy is Policy.FOLLOW and before is not None:
                goal.utterance = before.utterance
            self._move(goal, GoalState.ACCEPTED, now)
            self._queue.append(_Waiting(goal, its, covered if goal is goals[0] else None, since))

    @property
    def goals(self) -> list[Goal]:
        """What is being carried out, and what waits its turn."""
        running = [self.running] if self.running is not None else []
        return [*running, *(each.goal for each in self._queue)]

    def cancel(self, goal: Goal, now: float) -> None:
        """End one goal and what was said with it after it."""
        waiting = next((each for each in self._queue if each.goal is goal), None)
        if waiting is not None:
            self._queue.remove(waiting)
            self._end(goal, Ending(GoalState.CANCELED, Reason.CANCELED), now)
        elif self._run is not None and self._run.goal is goal:
            self._give_up(self._run, Reason.CANCELED, now)

    def hold(self, now: float) -> None:
        """Rest at once; the robot itself has been stopped."""
        self._held_since = now
        self._suspend(now, at_once=True)

    def release(self, now: float) -> None:
        self._held_since = None
        self._go_on(now)

    def pause(self, now: float) -> None:
        """Come to rest, gently."""
        self.paused = True
        if not self.held:
            self._suspend(now, at_once=False)

    def resume(self, now: float) -> None:
        self.paused = False
        self._go_on(now)

    def stop(self, reason: Reason, kind: EventKind, now: float) -> None:
        """Zero, and the end of everything, also where the robot's stop is broken off by Ctrl-C or a ``sys.exit()``."""
        stopped = False
        try:
            stopped = self._failsafe.stop()
        finally:
            run, self._run = self._run, None
            self._held_since, self.paused = None, False
            try:
                self._leave(run, self._failsafe.halt_loop(now))
                if isinstance(run, HandlerRun) or not (run is None or stopped):
                    self._let_go(run, now)
            finally:
                if run is not None:
                    # A goal that was making way already keeps its own reason.
                    was = run.goal.reason if run.goal.state is GoalState.CANCELING else reason
                    self._end(run.goal, Ending(GoalState.CANCELED, was), now, run)
                self._clear_queue(reason, now)
                self._events.tell(kind, reason=reason)

    # -- from goal to goal -------------------------------------------------------------------------------------------

    def _refusal(self, goal: Goal, now: float, since: object) -> Ending | None:
        if self.closed:
            return Ending(GoalState.REJECTED, Reason.CLOSED, "the executor is closed")
        if self.estopped:
            return Ending(GoalState.REJECTED, Reason.ESTOP, "emergency stop; reset() lets the robot move again")
        if self._stops.came_after(since):
            return Ending(GoalState.REJECTED, Reason.STOP, "a stop came after it was asked for")
        if self._stops.came_after_words(goal.times.spoken):
            return Ending(GoalState.REJECTED, Reason.STOP, "it was said before the last stop; say it again")
        if self._failsafe.fault and self._admission.drives(goal.action):
            return Ending(GoalState.REJECTED, Reason.VELOCITY_LOOP, f"{self._failsafe.fault}; reset() starts it again")
        return self._admission.expired(goal, now) or self._admission.impossible(goal)

    def _refuse(self, goals: list[Goal], refusals: list[Ending | None], now: float) -> bool:
        """Reject them all, if there is a refusal of one; whether there was."""
        refused = next((ending for ending in refusals if ending is not None), None)
        if refused is not None:
            whole = f"another step of the same command was refused: {refused.detail or refused.reason.value}"
            for goal, ending in zip(goals, refusals, strict=True):
                self._end(goal, ending or Ending(GoalState.REJECTED, Reason.EARLIER_FAILED, whole), now)
        return refused is not None

    def _change_speed(self, goals: list[Goal], terms: list[Terms], now: float, since: object) -> None:
        """Do what is being done faster, or slower, at once: nothing makes way for it, and it never waits its turn."""
        if not all(isinstance(goal.action, ChangeSpeed) for goal in goals):
            alone = [speed_change.ALONE if isinstance(each.action, ChangeSpeed) else None for each in goals]
            refusals = [self._refusal(each, now, since) or why for each, why in zip(goals, alone, strict=True)]
            self._refuse(goals, refusals, now)
            return
        for goal, its in zip(goals, terms, strict=True):
            self._change_once(goal, its.guard, now, since)

    def _change_once(self, goal: Goal, guard: Guard | None, now: float, since: object) -> None:
        assert isinstance(goal.action, ChangeSpeed)
        refused = self._refusal(goal, now, since)
        if refused is None and (forbids := forbidden(goal, guard)) is not None:
            refused = replace(forbids, state=GoalState.REJECTED)
        if goal.done:
            return  # whoever was asked has stopped the robot
        run = self._run
        doing, drives = run.goal.action if run is not None else None, isinstance(run, MotionRun)
        change = refused or speed_change.changed(doing, drives, goal.action.factor, self._admission.limits)
        ending = self._at_speed(run, change, now) if isinstance(change, SpeedChange) else change
        if ending.state is not GoalState.REJECTED:
            for state in (GoalState.ACCEPTED, GoalState.EXECUTING):
                self._move(goal, state, now)
        self._end(goal, ending, now)

    def _at_speed(self, run: Run | None, change: SpeedChange, now: float) -> Ending:
        assert isinstance(run, MotionRun)
        try:
            if not run.change_speed(change.speed, now):
                return speed_change.COMING_TO_REST
        except BaseException as error:
            pass_on_interrupt(error)
            self._robot_failed(run, error, now)
            return Ending(GoalState.ABORTED, reason_of(error), told(error))
        run.goal.action = change.action
        return Ending(GoalState.SUCCEEDED, detail=change.told)

    def _no_room(self, count: int, policy: Policy) -> Ending | None:
        if policy is Policy.REFUSE and not self.idle:
            return Ending(GoalState.REJECTED, Reason.BUSY, "something else is being done")
        if count + (len(self._queue) if policy in (Policy.QUEUE, Policy.FOLLOW) else 0) > self._queue_limit:
            return Ending(GoalState.REJECTED, Reason.BUSY, f"more than {self._queue_limit} goals would wait")
        return None

    def _begin_next(self, now: float) -> bool:
        """Begin the next goal of the queue, if it may begin now."""
        if not self._queue or self.held or self.paused or self.closed:
            return False
        waiting = self._queue[0]
        goal, terms = waiting.goal, waiting.terms
        run = self._carriers.run_of(goal, terms.keep, waiting.covered)
        if run.needs_rest and self._loop.moving:
            return False
        ending = forbidden(goal, terms.guard)
        if goal.done or self.held or self.paused:
            return True  # whoever was asked has stopped the robot
        if ending is None and not self._failsafe.begin():
            return False  # a stop that waits for the lock ends it, or a hold keeps it waiting
        if ending is None and self._stops.came_after(waiting.since):  # a signal handler's, as this was accepted
            ending = Ending(GoalState.CANCELED, Reason.STOP)
        if not self._queue:
            return True  # the same, just now
        self._queue.popleft()
        if ending is not None:
            self._end(goal, ending, now)
            if self._loop.moving:
                self._loop.brake(now)  # a motion that was to go over into this one
            return True
        if run.needs_rest:
            self._loop.silence()
        self._run = run
        self._move(goal, GoalState.EXECUTING, now)
        if self._run is not run:
            return True  # a signal handler has stopped the robot
        self._feedback_at = now + self.FEEDBACK_PERIOD
        try:
            run.begin(now)
        except BaseException as error:
            pass_on_interrupt(error)
            self._robot_failed(run, error, now)
        return True

    def _covered_for(self, goal: Goal, amended: Goal, now: float) -> Travel | None:
        """What a goal that is amended has covered of the one that amends it; None: they do not go the same way."""
        then, whole = Motion.of(amended.action), Motion.of(goal.action)
        if not (self._admission.drives(goal.action) and then and whole and then.same_way(whole)):
            return None
        if isinstance(self._run, MotionRun) and self._run.goal is amended:
            return self._run.covered(now)
        # One that was stopped is over: what follows begins anew.
        return Travel(amended.feedback.travelled or 0.0, then.duration) if amended.succeeded else None

    def _make_way(self, goal: Goal, now: float) -> None:
        """Let a newer utterance take the place of everything; a motion is braked unless another one follows it."""
        self._clear_queue(Reason.PREEMPTED, now)
        if self._run is not None:
            self._give_up(self._run, Reason.PREEMPTED, now, brake=not self._admission.drives(goal.action))

    def _give_up(self, run: Run, reason: Reason, now: float, brake: bool = True) -> None:
        if run.goal.state is GoalState.CANCELING:
            return
        try:
            gone = run.give_up(now)
            if isinstance(run, MotionRun) and brake and self._loop.moving:
                run.leave(self._loop.brake(now))
        except BaseException as error:
            pass_on_interrupt(error)
            self._robot_failed(run, error, now)
            return
        if gone:
            self._run = None
            self._end(run.goal, Ending(GoalState.CANCELED, reason), now, run)
        else:
            self._move(run.goal, GoalState.CANCELING, now, reason)

    def _clear_queue(self, reason: Reason, now: float) -> None:
        while self._queue:
            self._end_one(self._queue.popleft().goal, Ending(GoalState.CANCELED, reason), now)

    def _end(self, goal: Goal, ending: Ending, now: float, run: Run | None = None) -> None:
        """End a goal; what was said in one breath is done in order or not at all."""
        self._end_one(goal, ending, now, run)
        if ending.state not in (GoalState.ABORTED, GoalState.CANCELED):
            return
        reason = goal.reason if ending.state is GoalState.CANCELED else Reason.EARLIER_FAILED
        # Goals are numbered in the order in which they wait.
        said = [each for each in self._queue if each.goal.utterance == goal.utterance]
        for later in [each for each in said if each.goal.id > goal.id]:
            self._queue.remove(later)
            self._end_one(later.goal, Ending(GoalState.CANCELED, reason), now)

    def _end_one(self, goal: Goal, ending: Ending, now: float, run: Run | None = None) -> None:
        if run is not None:
            try:
                goal.feedback = replace(run.feedback(now), pose=self._failsafe.pose(), time_left=0.0)
            except BaseException as error:
                log.exception("no last feedback of goal %d", goal.id)
                pass_on_interrupt(error)
        self._move(goal, ending.state, now, ending.reason, ending.detail)
        self._ended()

    def _move(self, goal: Goal, state: GoalState, now: float, reason: Reason = Reason.NONE, detail: str = "") -> None:
        move_goal(goal, state, now, reason, detail)
        self._events.tell(EventKind.GOAL, goal)

    def _give_feedback(self, run: Run, now: float) -> None:
        self._feedback_at = now + self.FEEDBACK_PERIOD
        try:
            feedback = replace(run.feedback(now), pose=self._failsafe.pose())
        except BaseException as error:
            if self._mute is not run:
                log.exception("no feedback of goal %d; this is said once", run.goal.id)
            self._mute = run
            pass_on_interrupt(error)
            return
        run.goal.feedback = feedback
        self._events.tell(EventKind.FEEDBACK, run.goal, feedback=feedback)

    # -- rest and failure --------------------------------------------------------------------------------------------

    def _suspend(self, now: float, at_once: bool) -> None:
        run = self._run
        try:
            if run is not None:
                run.suspend(now, at_once)
            if at_once and self._loop.moving:
                self._loop.halt(now, write=False)
        except BaseException as error:
            pass_on_interrupt(error)
            self._robot_failed(run, error, now)

    def _go_on(self, now: float) -> None:
        if self.held or self.paused or self.closed or not self._failsafe.let_through():
            return
        if self._run is not None:
            self._feedback_at = now + self.FEEDBACK_PERIOD
            try:
                self._run.resume(now)
            except BaseException as error:
                pass_on_interrupt(error)
                self._robot_failed(self._run, error, now)
        self.advance(now)

    def _robot_failed(self, run: Run | None, error: BaseException, now: float) -> None:
        """A robot raised, or the velocity loop is lost: zero, and the goal is aborted."""
        stopped = self._failsafe.failed(error)
        self._leave(run, self._failsafe.end_motion(now))
        if run is not None and not stopped:
            self._let_go(run, now)
        reason = reason_of(error)
        if run is None or self._run is not run:
            if self._failsafe.failures == 1:
                self._events.tell(EventKind.ERROR, detail=told(error), reason=reason)
            return
        self._run = None
        state = GoalState.CANCELED if run.goal.state is GoalState.CANCELING else GoalState.ABORTED
        self._end(run.goal, Ending(state, reason, told(error)), now, run)

    def _leave(self, run: Run | None, travel: Travel | None) -> None:
        """The wheels are no longer a goal's; None: it moved none, or nobody knows how far it came."""
        if travel is not None and isinstance(run, MotionRun):
            run.leave(travel)

    def _let_go(self, run: Run, now: float) -> None:
        """A handler is told to end; of a robot whose stop failed, the task is cancelled by its own name."""
        try:
            run.give_up(now)
        except BaseException as error:
            log.exception("goal %d could not be given up", run.goal.id)
            pass_on_interrupt(error)
