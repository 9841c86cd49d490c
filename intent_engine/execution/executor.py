"""The executor: takes actions, makes goals of them, and carries them out on a robot, one at a time.

Life cycle: made -> ``submit`` / ``stop`` / ``hold`` / ``pause`` from any thread -> ``close`` (idempotent; also when
the ``with`` block, the program or the process is left). On a virtual clock it has no thread: moving the clock moves it.

Safety, in the order in which it is kept:

* ``stop`` acts in the caller's own thread: it shuts the gate through which every velocity goes, writes zero, ends
  every task and empties the queue before it returns. No velocity other than zero follows until something new is
  submitted.
* Every way out of a motion ends in two or three zeros and then silence.
* Whatever a robot, a handler or a listener raises ends its own goal and nothing else.
"""

from __future__ import annotations

import logging
import math
import threading
from collections import deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from types import TracebackType
from typing import Any

from intent_engine.actions import Action, Custom, Move, Navigate, Pick, Place, Stop, Turn
from intent_engine.execution import shutdown
from intent_engine.execution.clock import Clock, MonotonicClock, SteppedClock
from intent_engine.execution.events import Dispatcher, Event, EventKind, Listener
from intent_engine.execution.gate import Gate
from intent_engine.execution.goal import Feedback, Goal, GoalState, Reason, move_goal
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Follower, Keep, Motion, Rates
from intent_engine.execution.robots.robot import Capability, Pose, Robot
from intent_engine.execution.runs import Ending, Handler, HandlerRun, MotionRun, Run, StopRun, TaskRun, VelocityLoop

__all__ = ["Executor", "Policy", "Snapshot"]

log = logging.getLogger(__name__)

_NEEDS: dict[type[Any], Capability] = {
    Move: Capability.MOVE,
    Turn: Capability.TURN,
    Navigate: Capability.NAVIGATE,
    Pick: Capability.PICK,
    Place: Capability.PLACE,
}


class Policy(StrEnum):
    """What a new command does when another one is being carried out."""

    REPLACE = "replace"
    """It takes its place at once (the default)."""
    QUEUE = "queue"
    """It waits its turn."""
    REFUSE = "refuse"
    """It is rejected."""


@dataclass(frozen=True, slots=True)
class Snapshot:
    """How the executor stands."""

    goal: Goal | None
    """What is being carried out."""
    queued: int
    held: bool
    paused: bool
    estopped: bool
    closed: bool
    velocity: tuple[float, float]
    """m/s and rad/s, as last written"""
    pose: Pose | None


class Executor:
    """Carries out actions on a robot. All methods may be called from any thread, listeners and handlers included.

    Args:
        robot: what to drive. It is not closed with the executor: who made it closes it.
        limits: of this robot; None: the robot's own (``robot.limits``), or none but that numbers are numbers.
        clock: None: the robot's own, or the machine's.
        handlers: name of a custom action (or a type of action) -> what carries it out; see :meth:`register`.
        journal: is given every event, as :class:`~intent_engine.execution.journal.Journal` is.
        on_event: called with every :class:`~intent_engine.execution.events.Event`; see :meth:`subscribe`.
        loop: what writes velocities; None: this executor itself. A
            :class:`~intent_engine.execution.velocity_loop.Guardian` does it in a process of its own.
        rates: how often a velocity is written and how long it holds; None: the robot's own, or 20 Hz and 300 ms.
        policies: type of action (or name of a custom one) -> what it does when it comes while another is carried out.
        expire_after: s; words that ended longer ago are not acted on. A stop never expires.
        hold_limit: s; a hold that nobody released becomes a stop.
        queue_limit: how many goals may wait.
        handle_sigterm: stop the robot when the process is asked to end (where SIGTERM has no other handler yet).
    """

    FEEDBACK_PERIOD = 0.1
    """s between two feedback events of a goal."""
    STOP_PATIENCE = 0.02
    """s that ``stop`` waits for a robot that hangs in a call, before it stops it past the lock."""

    def __init__(
        self,
        robot: Robot,
        limits: Limits | None = None,
        clock: Clock | None = None,
        handlers: Mapping[str, Handler] | None = None,
        journal: Listener | None = None,
        *,
        on_event: Listener | None = None,
        loop: VelocityLoop | None = None,
        rates: Rates | None = None,
        policies: Mapping[str, Policy | str] | None = None,
        expire_after: float = 5.0,
        hold_limit: float = 10.0,
        queue_limit: int = 64,
        handle_sigterm: bool = True,
    ) -> None:
        self.robot = robot
        self.limits: Limits = limits or getattr(robot, "limits", None) or Limits()
        self.rates: Rates = rates or getattr(robot, "rates", None) or Rates()
        self.clock: Clock = clock or getattr(robot, "clock", None) or MonotonicClock()
        if hasattr(robot, "use_clock"):
            robot.use_clock(self.clock)
        self.policies = {name: Policy(policy) for name, policy in (policies or {}).items()}
        self.expire_after, self.hold_limit, self.queue_limit = expire_after, hold_limit, queue_limit
        self._handlers: dict[str, Handler] = dict(handlers or {})
        self._lock = threading.RLock()
        self._wake = threading.Condition(self._lock)
        """Something is due earlier than was thought."""
        self._ended = threading.Condition(self._lock)
        """A goal has ended."""
        self._gate = Gate(robot)
        self._own_loop = loop is None
        self._loop: VelocityLoop = loop if loop is not None else Follower(self._gate, self.limits, self.rates)
        self._queue: deque[Goal] = deque()
        self._motions: dict[int, Keep] = {}
        self._run: Run | None = None
        self._held_since: float | None = None
        self._paused = self._estopped = self._closed = False
        self._fault = ""
        """Why the velocity loop must not be used until :meth:`reset`."""
        self._late_stop: Reason | None = None
        """A stop that could not take the lock: its bookkeeping is still to do."""
        self._poked = False
        self._feedback_at = math.inf
        self._utterance = 0
        self._stepped = self.clock if isinstance(self.clock, SteppedClock) else None
        if self._stepped is not None and loop is not None:
            raise ValueError("a velocity loop in another process cannot follow a virtual clock; give no loop")
        self._events = Dispatcher(threaded=self._stepped is None)
        if journal is not None:
            self._events.subscribe(journal)
        if on_event is not None:
            self._events.subscribe(on_event)
        if hasattr(self._loop, "attach"):
            self._loop.attach(self._poke_from_outside, self._stop_robot)
        self._thread: threading.Thread | None = None
        if self._stepped is not None:
            self._stepped.attach(self)
        else:
            self._thread = threading.Thread(target=self._main, name="executor", daemon=True)
            self._thread.start()
        shutdown.register(self, handle_sigterm)

    # -- commands ----------------------------------------------------------------------------------------------------

    def submit(
        self,
        actions: Action | Iterable[Action],
        spoken_at: float | None = None,
        *,
        policy: Policy | str | None = None,
        keep: Keep | str | Sequence[Keep | str] = Keep.DISTANCE,
        text: str | None = None,
    ) -> list[Goal]:
        """Carry out the actions of one utterance, in order; a newer utterance takes the place of an older one.

        Either all of them are accepted or none: half of what was said is never done.

        Args:
            actions: what to do. A :class:`Stop` that comes first stops at once, whatever else is going on.
            spoken_at: when the words ended, on the executor's clock.
            policy: what to do with what is being carried out; None: the policy of the first action's type.
            keep: whether ramps cost a motion time (``distance``) or way (``duration``); one for all, or one for each.
            text: what was said, for the journal.

        Returns:
            A goal for each action, in order.

        Raises:
            TypeError: something that is not an action was submitted.
        """
        listed: list[Action] = list(actions) if isinstance(actions, Iterable) else [actions]
        for action in listed:
            if not isinstance(getattr(action, "type", None), str):
                raise TypeError(f"submit takes actions (Move, Turn, Stop, ...), not {type(action).__name__}")
        keeps = [keep] * len(listed) if isinstance(keep, str) else list(keep)
        if len(keeps) != len(listed):
            raise ValueError(f"{len(listed)} actions, but {len(keeps)} values of keep")
        if spoken_at is not None and not math.isfinite(spoken_at):
            raise ValueError(f"spoken_at must be a time on the executor's clock, not {spoken_at}")
        if not listed:
            return []
        try:
            if isinstance(listed[0], Stop):
                self.stop()
            with self._lock:
                goals = self._take(listed, [Keep(each) for each in keeps], spoken_at, policy, text)
                self._advance(self.clock.now())
        finally:
            self._flush()
        return goals

    def stop(self) -> None:
        """Zero velocity now, every goal and task ended, the queue, a hold and a pause forgotten. From any thread."""
        self._stop(Reason.STOP, EventKind.STOP)

    def estop(self) -> None:
        """Stop, and refuse every command but another stop until :meth:`reset`."""
        self._estopped = True
        self._stop(Reason.ESTOP, EventKind.ESTOP)

    def reset(self) -> None:
        """End an emergency stop, or start a velocity loop again that died. Nothing moves until the next submit."""
        with self._lock:
            self._estopped = False
            if self._fault and hasattr(self._loop, "restart"):
                self._loop.restart()
            self._fault = ""
            self._tell(EventKind.RESET)
        self._flush()

    def hold(self) -> None:
        """Zero velocity now, as :meth:`stop`, but :meth:`release` lets the motion go on where it stood.

        For a stop that is not certain yet. Nobody's release within ``hold_limit`` makes a stop of it.
        """
        self._gate.shut()
        with self._lock:
            if not self._closed and self._held_since is None:
                now = self.clock.now()
                self._held_since = now
                self._stop_robot()
                self._suspend(now, at_once=True)
                self._tell(EventKind.HOLD)
                self._wake.notify_all()
        self._flush()

    def release(self) -> None:
        """End a hold: motions cover what was left of them, navigation is given again."""
        with self._lock:
            if self._held_since is not None:
                self._held_since = None
                self._tell(EventKind.RELEASE)
                self._go_on()
        self._flush()

    def pause(self) -> None:
        """Come to rest with the robot's deceleration, and wait for :meth:`resume`."""
        with self._lock:
            if not self._paused and not self._closed:
                self._paused = True
                self._tell(EventKind.PAUSE)
                if self._held_since is None:
                    self._suspend(self.clock.now(), at_once=False)
                    self._advance(self.clock.now())
        self._flush()

    def resume(self) -> None:
        """Go on after :meth:`pause`."""
        with self._lock:
            if self._paused:
                self._paused = False
                self._tell(EventKind.RESUME)
                self._go_on()
        self._flush()

    def cancel(self, goal: Goal) -> None:
        """End one goal and leave the others; a motion comes to rest with the robot's deceleration."""
        with self._lock:
            now = self.clock.now()
            if goal in self._queue:
                self._queue.remove(goal)
                self._end(goal, Ending(GoalState.CANCELED, Reason.CANCELED), now)
            elif self._run is not None and self._run.goal is goal:
                self._give_up(self._run, Reason.CANCELED, now)
                self._advance(now)
        self._flush()

    def register(self, name: str, handler: Handler) -> None:
        """Let ``handler(action)`` or ``handler(action, context)`` carry out the custom action ``name``.

        A handler registered under the type of an action (``pick``) is used where the robot cannot do it itself.
        It runs in a thread of its own; what it raises aborts its goal and nothing else.
        """
        with self._lock:
            self._handlers[name] = handler

    def subscribe(self, listener: Listener) -> Callable[[], None]:
        """Call ``listener`` with every event, in order, in a thread that is not the executor's.

        Returns:
            What ends the subscription.
        """
        return self._events.subscribe(listener)

    # -- waiting -----------------------------------------------------------------------------------------------------

    def wait(self, goals: Goal | Iterable[Goal] | None = None, timeout: float | None = None) -> bool:
        """Wait until the goals (None: everything submitted) have ended. On a virtual clock this moves the clock.

        Returns:
            False if ``timeout`` s went by first, or, on a virtual clock, if nothing more is due (a pause).
        """
        listed = None if goals is None else [goals] if isinstance(goals, Goal) else list(goals)
        deadline = None if timeout is None else self.clock.now() + timeout
        if self._stepped is not None:
            while not self._all_ended(listed):
                if not self.clock.step_once(math.inf if deadline is None else deadline):  # type: ignore[attr-defined]
                    if deadline is not None:
                        self._stepped.run_until_idle(deadline)
                    return self._all_ended(listed)
            return True
        with self._lock:
            while not self._all_ended(listed):
                if self.clock.wait_until(self._ended, deadline) and not self._all_ended(listed):
                    return False
        return True

    def run_until_idle(self) -> bool:
        """On a virtual clock: carry everything out, zeros that end a motion included."""
        if self._stepped is None:
            return self.wait()
        return self._stepped.run_until_idle()

    @property
    def idle(self) -> bool:
        """Nothing is being carried out and nothing waits."""
        with self._lock:
            return self._run is None and not self._queue

    @property
    def estopped(self) -> bool:
        return self._estopped

    def snapshot(self) -> Snapshot:
        """How things stand."""
        with self._lock:
            goal = self._run.goal if self._run is not None else None
            queued, held, velocity = len(self._queue), self._held_since is not None, self._loop.written
        return Snapshot(goal, queued, held, self._paused, self._estopped, self._closed, velocity, self._pose())

    # -- end ---------------------------------------------------------------------------------------------------------

    def close(self) -> None:
        """Stop, end the thread, write the last zeros. What is submitted afterwards is rejected. Idempotent."""
        with self._lock:
            if self._closed:
                return
            self._closed = True
        self._stop(Reason.CLOSED, EventKind.STOP)
        shutdown.unregister(self)
        with self._lock:
            self._wake.notify_all()
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join(1.0)
        if self._stepped is not None:
            self._stepped.detach(self)
        self.last_zeros()
        if hasattr(self._loop, "close"):
            self._loop.close()
        self._events.close()

    def last_zeros(self) -> None:
        """Zero, as often as the rates say, without lock or thread: for the end of the process."""
        self._gate.shut()
        for _ in range(self.rates.zeros):
            self._stop_robot()

    def __enter__(self) -> Executor:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    # -- stepping: on a virtual clock by the clock, else by the thread -------------------------------------------------

    def due(self) -> float | None:
        """When :meth:`step` has something to do."""
        with self._lock:
            return self._due(self.clock.now())

    def step(self) -> None:
        """Do what is due now."""
        with self._lock:
            self._advance(self.clock.now())
        self._flush()

    def _main(self) -> None:
        with self._lock:
            while not self._closed:
                self._advance(self.clock.now())
                self.clock.wait_until(self._wake, self._due(self.clock.now()))

    def _due(self, now: float) -> float | None:
        if self._poked or self._late_stop is not None:
            return now
        times: list[float] = []
        run = self._run
        if self._held_since is not None:
            times.append(self._held_since + self.hold_limit)
        resting = self._held_since is not None or self._paused
        if run is not None:
            run_due = run.due(now)
            if run_due is not None and not (resting and isinstance(run, MotionRun)):
                times.append(run_due)
            if not resting:
                times.append(self._feedback_at)
        loop_due = self._loop.due()
        if loop_due is not None:
            times.append(loop_due)
        first = min(times, default=math.inf)
        return None if math.isinf(first) else max(first, now)

    def _advance(self, now: float) -> None:
        """Do all that is due, under the lock. Nothing that a robot raises leaves here."""
        self._poked = False
        if self._late_stop is not None:
            reason, self._late_stop = self._late_stop, None
            self._stop_here(reason, EventKind.STOP, now)
        if self._held_since is not None and now >= self._held_since + self.hold_limit:
            self._stop_here(Reason.HOLD_EXPIRED, EventKind.STOP, now)
        while True:
            run = self._run
            try:
                if run is None:
                    self._loop.step(now)
                    if not self._begin_next(now):
                        break
                    continue
                ending = run.step(now)
            except Exception as error:
                self._robot_failed(run, error, now)
                continue
            if ending is None:
                break
            self._run = None
            self._end(run.goal, ending, now, run)
        run = self._run
        if run is not None and now >= self._feedback_at:
            self._give_feedback(run, now)

    def _give_feedback(self, run: Run, now: float) -> None:
        self._feedback_at = now + self.FEEDBACK_PERIOD
        try:
            feedback = replace(run.feedback(now), pose=self._pose())
        except Exception:
            log.exception("no feedback of goal %d", run.goal.id)
            return
        run.goal.feedback = feedback
        self._tell(EventKind.FEEDBACK, run.goal, feedback=feedback)

    # -- goals -------------------------------------------------------------------------------------------------------

    def _take(
        self,
        actions: list[Action],
        keeps: list[Keep],
        spoken_at: float | None,
        policy: Policy | str | None,
        text: str | None,
    ) -> list[Goal]:
        now = self.clock.now()
        self._utterance += 1
        goals = [Goal(action, now, spoken_at, self._utterance, text) for action in actions]
        for goal, keep in zip(goals, keeps, strict=True):
            goal._wait = self._wait_for
            self._motions[goal.id] = keep
            self._tell(EventKind.GOAL, goal)
        first_stop = isinstance(actions[0], Stop)
        waiting = goals[1:] if first_stop else goals
        if first_stop:
            # The stop itself is done; whatever may be wrong with the rest of the sentence, it happened.
            for state in (GoalState.ACCEPTED, GoalState.EXECUTING, GoalState.SUCCEEDED):
                self._move(goals[0], state, now)
        refusals = [self._refusal(goal, spoken_at, now) for goal in waiting]
        refused = next((ending for ending in refusals if ending is not None), None)
        chosen = Policy(policy) if policy is not None else self._policy(actions[0])
        busy = self._run is not None or bool(self._queue)
        if waiting and refused is None:
            if busy and chosen is Policy.REFUSE:
                refused = Ending(GoalState.REJECTED, Reason.BUSY, "something else is being done")
                refusals = [refused] * len(waiting)
            elif len(waiting) + (len(self._queue) if chosen is Policy.QUEUE else 0) > self.queue_limit:
                refused = Ending(GoalState.REJECTED, Reason.BUSY, f"more than {self.queue_limit} goals would wait")
                refusals = [refused] * len(waiting)
        if refused is not None:
            whole = f"another step of the same command was refused: {refused.detail or refused.reason.value}"
            for goal, ending in zip(waiting, refusals, strict=True):
                self._end(goal, ending or Ending(GoalState.REJECTED, Reason.EARLIER_FAILED, whole), now)
            return goals
        if waiting and busy and chosen is Policy.REPLACE:
            self._make_way(waiting[0], now)
        for goal in waiting:
            self._move(goal, GoalState.ACCEPTED, now)
            self._queue.append(goal)
        self._wake.notify_all()
        return goals

    def _refusal(self, goal: Goal, spoken_at: float | None, now: float) -> Ending | None:
        """Why a goal must not be accepted; clamps its action where the limits say so."""

        def no(reason: Reason, detail: str) -> Ending:
            return Ending(GoalState.REJECTED, reason, detail)

        action = goal.action
        if self._closed:
            return no(Reason.CLOSED, "the executor is closed")
        if self._estopped:
            return no(Reason.ESTOP, "emergency stop; reset() lets the robot move again")
        if spoken_at is not None and now - spoken_at > self.expire_after:
            return no(
                Reason.EXPIRED, f"the words ended {now - spoken_at:.1f} s ago; the limit is {self.expire_after:g} s"
            )
        if self._fault and isinstance(action, (Move, Turn)):
            return no(Reason.VELOCITY_LOOP, f"{self._fault}; reset() starts it again")
        if isinstance(action, Stop) or self._handler(action) is not None:
            return None
        need = _NEEDS.get(type(action))
        if need is None:
            name = action.name if isinstance(action, Custom) else action.type
            return no(Reason.NO_HANDLER, f"nothing is registered for {name!r}: executor.register({name!r}, ...)")
        if need not in self.robot.capabilities:
            return no(Reason.CAPABILITY, f"this robot cannot {need.value}")
        checked = self.limits.check(action)
        if checked.refused:
            return no(Reason.LIMIT, checked.refused)
        goal.action = checked.action
        goal.detail = "; ".join(checked.clamped)
        return None

    def _policy(self, action: Action) -> Policy:
        name = action.name if isinstance(action, Custom) else action.type
        return self.policies.get(name, self.policies.get(action.type, Policy.REPLACE))

    def _handler(self, action: Action) -> Handler | None:
        if isinstance(action, Custom):
            return self._handlers.get(action.name) or self._handlers.get("custom")
        need = _NEEDS.get(type(action))
        if need is not None and need in self.robot.capabilities:
            return None
        return self._handlers.get(action.type)

    def _make_run(self, goal: Goal) -> Run:
        action, robot = goal.action, self.robot
        handler = self._handler(action)
        if handler is not None:
            return HandlerRun(goal, handler, self._launch, self._poke_from_outside, self.limits.task_duration)
        if isinstance(action, Stop):
            return StopRun(goal, self._stop_wheels)
        if isinstance(action, (Move, Turn)):
            return MotionRun(goal, Motion.of(action, self._motions[goal.id]), self._loop)

        def begin() -> Any:
            if isinstance(action, Navigate):
                return robot.navigate(Pose(action.x, action.y, action.yaw, action.frame))
            if isinstance(action, Pick):
                return robot.pick(action.object)
            assert isinstance(action, Place)
            return robot.place(action.object, action.location)

        return TaskRun(goal, robot, begin, lambda task: self._poke_from_outside(), self.limits.task_duration)

    def _begin_next(self, now: float) -> bool:
        """Begin the next goal of the queue, if it may begin now."""
        if not self._queue or self._held_since is not None or self._paused or self._closed:
            return False
        run = self._make_run(self._queue[0])
        if run.needs_rest:
            if self._loop.moving:
                return False
            self._loop.silence()
        goal = self._queue.popleft()
        self._run = run
        self._gate.open()
        self._move(goal, GoalState.EXECUTING, now)
        self._feedback_at = now + self.FEEDBACK_PERIOD
        run.begin(now)
        return True

    def _make_way(self, goal: Goal, now: float) -> None:
        """Let a newer utterance take the place of everything."""
        while self._queue:
            self._end(self._queue.popleft(), Ending(GoalState.CANCELED, Reason.PREEMPTED), now)
        run = self._run
        if run is None:
            return
        moves_on = isinstance(goal.action, (Move, Turn)) and self._handler(goal.action) is None
        self._give_up(run, Reason.PREEMPTED, now, brake=not moves_on)

    def _give_up(self, run: Run, reason: Reason, now: float, brake: bool = True) -> None:
        if run.goal.state is GoalState.CANCELING:
            return
        try:
            gone = run.give_up(now)
            if isinstance(run, MotionRun) and brake and self._loop.moving:
                run.leave(self._loop.brake(now))
        except Exception as error:
            self._robot_failed(run, error, now)
            return
        if gone:
            self._run = None
            self._end(run.goal, Ending(GoalState.CANCELED, reason), now, run)
        else:
            self._move(run.goal, GoalState.CANCELING, now, reason)

    def _end(self, goal: Goal, ending: Ending, now: float, run: Run | None = None) -> None:
        if run is not None:
            try:
                goal.feedback = replace(run.feedback(now), pose=self._pose(), time_left=0.0)
            except Exception:
                log.exception("no last feedback of goal %d", goal.id)
        self._motions.pop(goal.id, None)
        self._move(goal, ending.state, now, ending.reason, ending.detail)
        self._ended.notify_all()
        if ending.state in (GoalState.ABORTED, GoalState.CANCELED):
            # What was said in one breath is done in order or not at all.
            while self._queue and self._queue[0].utterance == goal.utterance:
                rest = self._queue.popleft()
                reason = ending.reason if ending.state is GoalState.CANCELED else Reason.EARLIER_FAILED
                self._end(rest, Ending(GoalState.CANCELED, reason or goal.reason), now)

    def _move(self, goal: Goal, state: GoalState, now: float, reason: Reason = Reason.NONE, detail: str = "") -> None:
        move_goal(goal, state, now, reason, detail)
        self._tell(EventKind.GOAL, goal)

    # -- stopping ----------------------------------------------------------------------------------------------------

    def _stop(self, reason: Reason, kind: EventKind) -> None:
        self._gate.shut()
        if self._lock.acquire(timeout=self.STOP_PATIENCE):
            try:
                self._stop_here(reason, kind, self.clock.now())
            finally:
                self._lock.release()
        else:
            # The robot hangs in a call that another thread made. Its stop may be called at any time; the books are
            # kept as soon as the lock is free, and the shut gate writes another zero after the call that hangs.
            self._late_stop = reason
            self._stop_robot()
            self._poke_from_outside()
        self._flush()

    def _stop_here(self, reason: Reason, kind: EventKind, now: float) -> None:
        self._gate.shut()
        self._stop_robot()
        run, self._run = self._run, None
        try:
            travel = self._loop.halt(now, write=False)
            if isinstance(run, MotionRun):
                run.leave(travel)
        except Exception as error:
            self._loop_failed(error, now)
        self._held_since, self._paused = None, False
        if run is not None:
            if isinstance(run, HandlerRun):
                run.give_up(now)
            # A goal that was making way already keeps its own reason.
            was = run.goal.reason if run.goal.state is GoalState.CANCELING else reason
            self._end(run.goal, Ending(GoalState.CANCELED, was), now, run)
        while self._queue:
            self._end(self._queue.popleft(), Ending(GoalState.CANCELED, reason), now)
        self._tell(kind, reason=reason)
        self._wake.notify_all()

    def _stop_robot(self) -> None:
        try:
            self.robot.stop()
        except Exception as error:
            # The protocol forbids it; and still the velocity is tried.
            log.exception("the robot raised in stop()")
            try:
                self.robot.velocity(0.0, 0.0, self.rates.valid_for)
            except Exception:
                log.exception("the robot raised in velocity(0, 0)")
            self._tell(EventKind.ERROR, detail=f"the robot raised in stop(): {error}")

    def _stop_wheels(self, now: float) -> None:
        self._stop_robot()
        self._loop.halt(now, write=False)

    def _suspend(self, now: float, at_once: bool) -> None:
        run = self._run
        try:
            if run is not None:
                run.suspend(now, at_once)
            if at_once and self._loop.moving:
                self._loop.halt(now, write=False)
        except Exception as error:
            self._robot_failed(run, error, now)

    def _go_on(self) -> None:
        if self._held_since is not None or self._paused or self._closed:
            return
        now = self.clock.now()
        self._gate.open()
        if self._run is not None:
            self._feedback_at = now + self.FEEDBACK_PERIOD
            try:
                self._run.resume(now)
            except Exception as error:
                self._robot_failed(self._run, error, now)
        self._advance(now)
        self._wake.notify_all()

    def _robot_failed(self, run: Run | None, error: Exception, now: float) -> None:
        """A robot raised: zero, and its goal is aborted."""
        self._gate.shut()
        self._stop_robot()
        reason = getattr(error, "goal_reason", Reason.ROBOT_ERROR)
        try:
            travel = self._loop.halt(now, write=False)
            if isinstance(run, MotionRun):
                run.leave(travel)
        except Exception as second:
            reason = getattr(second, "goal_reason", reason)
        if reason is Reason.VELOCITY_LOOP:
            self._fault = str(error)
        if run is None or self._run is not run:
            self._tell(EventKind.ERROR, detail=str(error), reason=reason)
            return
        self._run = None
        state = GoalState.CANCELED if run.goal.state is GoalState.CANCELING else GoalState.ABORTED
        self._end(run.goal, Ending(state, reason, str(error) or type(error).__name__), now, run)

    def _loop_failed(self, error: Exception, now: float) -> None:
        self._fault = str(error)
        self._tell(EventKind.ERROR, detail=self._fault, reason=Reason.VELOCITY_LOOP)

    # -- helpers -----------------------------------------------------------------------------------------------------

    def _tell(
        self,
        kind: EventKind,
        goal: Goal | None = None,
        *,
        reason: Reason = Reason.NONE,
        detail: str = "",
        feedback: Feedback | None = None,
    ) -> None:
        if goal is not None:
            reason, detail = goal.reason, goal.detail
        state = goal.state if goal is not None else None
        self._events.put(Event(kind, self.clock.now(), goal, state, reason, detail, feedback))

    def _flush(self) -> None:
        """Let listeners hear, if no thread does it, and never under the lock of this thread's own doing."""
        self._events.flush()

    def _launch(self, work: Callable[[], None]) -> None:
        if self._stepped is not None:
            self._events.put(work)
        else:
            threading.Thread(target=work, name="handler", daemon=True).start()

    def _poke_from_outside(self) -> None:
        """Look again soon. Takes no lock that a robot's thread could be waiting for."""
        self._poked = True
        if self._lock.acquire(blocking=False):
            try:
                self._wake.notify_all()
            finally:
                self._lock.release()

    def _pose(self) -> Pose | None:
        try:
            return self.robot.pose()
        except Exception:
            log.exception("the robot raised in pose()")
            return None

    def _all_ended(self, goals: list[Goal] | None) -> bool:
        if goals is None:
            return self.idle
        return all(goal.done for goal in goals)

    def _wait_for(self, goal: Goal, timeout: float | None) -> None:
        if not self.wait(goal, timeout) and not goal.done:
            raise TimeoutError(f"{goal!r} has not ended")
