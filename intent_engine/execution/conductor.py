"""The rules of the executor: which goal is next, which makes way, and what a stop, a hold or a failure ends.

A conductor has no lock, no thread and no clock: it is told the time, and the executor calls it under its lock. It never
asks the robot itself: its runs do, and the failsafe.
"""

from __future__ import annotations

import logging
import math

from intent_engine.actions import ChangeSpeed
from intent_engine.execution.admission import Admission, Terms, forbidden
from intent_engine.execution.carriers import Carriers
from intent_engine.execution.events import Dispatcher, EventKind
from intent_engine.execution.failsafe import Failsafe, reason_of
from intent_engine.execution.goal import Goal, GoalState, Reason
from intent_engine.execution.handlers import HandlerRun
from intent_engine.execution.intake import Intake
from intent_engine.execution.motion import Motion, Travel
from intent_engine.execution.policy import Policy
from intent_engine.execution.progress import Progress
from intent_engine.execution.queue import GoalQueue, Queued
from intent_engine.execution.raised import pass_on_interrupt, told
from intent_engine.execution.runs import Ending, MotionRun, Run, VelocityLoop
from intent_engine.execution.speed_change import SpeedChanger
from intent_engine.execution.stops import Stops

__all__ = ["Conductor"]

log = logging.getLogger(__name__)


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
        intake: Intake,
        progress: Progress,
        stops: Stops,
        hold_limit: float,
    ) -> None:
        """``events`` hear of everything; ``intake`` says what is refused, ``progress`` enters what becomes of goals,
        and ``stops`` knows what was asked for before a stop."""
        self._admission = admission
        self._carriers = carriers
        self._loop = loop
        self._failsafe = failsafe
        self._events = events
        self._intake = intake
        self._progress = progress
        self._stops = stops
        self._leases = stops.leases
        self._hold_limit = hold_limit
        self._queue = GoalQueue(progress)
        self._speeds = SpeedChanger(intake, progress, admission.limits, lambda: self._run, self._robot_failed)
        self._run: Run | None = None
        self._held_since: float | None = None
        self._feedback_at = math.inf
        self.paused = False

    @property
    def idle(self) -> bool:
        return self._run is None and not self._queue

    @property
    def held(self) -> bool:
        return self._held_since is not None

    @property
    def running(self) -> Goal | None:
        run = self._run  # may be asked for without the lock of a robot that hangs
        return run.goal if run is not None else None

    @property
    def closed(self) -> bool:
        return self._intake.closed

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
            self._leases.taken_over(None, Reason.HOLD_EXPIRED)
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
            self._leases.broken_off(run.goal, ending.reason)
            self._end(run.goal, ending, now, run)
        if self._run is not None and now >= self._feedback_at:
            self._feedback_at = now + self.FEEDBACK_PERIOD
            self._progress.feedback(self._run, now)

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
        ``since``: the last stop when they were asked for. ``amends``: the earlier goal that the first one puts
        right; what that one has covered counts."""
        goals = self._intake.announced(goals, now)
        if not goals:
            return
        terms = terms[-len(goals) :]
        if any(isinstance(goal.action, ChangeSpeed) for goal in goals):
            self._speeds.change(goals, terms, now, since)
            return
        policy = policy or self._admission.policy(goals[0].action)
        refusals = [self._intake.refusal(goal, now, since) for goal in goals]
        full = self._intake.no_room(len(goals), len(self._queue), self.idle, policy)
        if not any(refusals) and full is not None:
            refusals = [full] * len(goals)
        if self._intake.refuse(goals, refusals, now):
            return
        covered = self._covered_for(goals[0], amends, now) if amends is not None else None
        if policy is Policy.REPLACE:
            self._leases.taken_over(goals[0], Reason.PREEMPTED)
            self._make_way(goals[0], now)
        before = self._queue.last or self.running
        for goal, its in zip(goals, terms, strict=True):
            if policy is Policy.FOLLOW and before is not None:
                goal.utterance = before.utterance
            self._progress.move(goal, GoalState.ACCEPTED, now)
            self._queue.add(Queued(goal, its, covered if goal is goals[0] else None, since))

    @property
    def goals(self) -> list[Goal]:
        """What is being carried out, and what waits its turn."""
        running = [self.running] if self.running is not None else []
        return [*running, *self._queue]

    def cancel(self, goal: Goal, now: float) -> None:
        """End one goal and what was said with it after it."""
        self._leases.cancelled(goal)
        if self._queue.remove(goal):
            self._end(goal, Ending(GoalState.CANCELED, Reason.CANCELED), now)
        elif self._run is not None and self._run.goal is goal:
            self._give_up(self._run, Reason.CANCELED, now)

    def hold(self, now: float, stopped: bool = True) -> None:
        """Rest at once; the robot itself has been ``stopped``, or its stop has failed."""
        self._held_since = now
        self._suspend(now, at_once=True, stopped=stopped)

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
                self._queue.clear(reason, now)
                self._events.tell(kind, reason=reason)

    # -- from goal to goal -------------------------------------------------------------------------------------------

    def _begin_next(self, now: float) -> bool:
        """Begin the next goal of the queue, if it may begin now."""
        if not self._queue or self.held or self.paused or self.closed:
            return False
        waiting = self._queue.first
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
        self._queue.pop()
        if ending is not None:
            self._end(goal, ending, now)
            if self._loop.moving:
                self._loop.brake(now)  # a motion that was to go over into this one
            return True
        if run.needs_rest:
            self._loop.silence()
        self._leases.taken_over(goal, Reason.PREEMPTED)
        self._run = run
        self._progress.move(goal, GoalState.EXECUTING, now)
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
        self._queue.clear(Reason.PREEMPTED, now)
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
            self._progress.move(run.goal, GoalState.CANCELING, now, reason)

    def _end(self, goal: Goal, ending: Ending, now: float, run: Run | None = None) -> None:
        """End a goal; what was said in one breath is done in order or not at all."""
        self._progress.end(goal, ending, now, run)
        if ending.state not in (GoalState.ABORTED, GoalState.CANCELED):
            return
        if ending.reason is Reason.WATCHDOG:
            self._queue.clear(ending.reason, now)  # a robot that wakes begins nothing either
        reason = goal.reason if ending.state is GoalState.CANCELED else Reason.EARLIER_FAILED
        self._queue.end_after(goal, reason, now)

    # -- rest and failure --------------------------------------------------------------------------------------------

    def _suspend(self, now: float, at_once: bool, stopped: bool = True) -> None:
        run = self._run
        try:
            if run is not None:
                # What the robot does by itself is cancelled by its own name where the robot could not be stopped.
                run.suspend(now, at_once and (stopped or isinstance(run, MotionRun)))
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
        self._leases.broken_off(run.goal, reason)
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
