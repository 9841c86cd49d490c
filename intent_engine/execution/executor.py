"""The executor: takes actions, makes goals of them, and carries them out on a robot, one at a time.

Life cycle: made -> ``submit`` / ``stop`` / ``hold`` / ``pause`` from any thread -> ``close`` (idempotent; also when
the ``with`` block, the program or the process is left). On a virtual clock it has no thread: moving the clock moves it.

Safety, in the order in which it is kept:

* ``stop`` acts in the caller's own thread: it shuts the gate through which every velocity goes, writes zero, ends
  every task and empties the queue before it returns. No velocity other than zero follows until something new is
  submitted.
* Every way out of a motion ends in two or three zeros and then silence.
* Whatever a robot or a handler raises ends its own goal and nothing else. What a listener raises is logged, and it is
  called again with the next event; to end a program from one, tell another thread.
* Of a robot that hangs in a call nothing is asked but a stop, and whoever asks for something else is told so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from types import TracebackType

from intent_engine.actions import Action, Stop, actions_of
from intent_engine.errors import RobotError
from intent_engine.execution import given, shutdown
from intent_engine.execution.admission import check_robot, checked
from intent_engine.execution.clock import Clock, SteppedClock
from intent_engine.execution.denial import does
from intent_engine.execution.events import EventKind, Listener
from intent_engine.execution.failsafe import HANGS
from intent_engine.execution.goal import Goal, Guard, Reason
from intent_engine.execution.handlers import Handler
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Keep, Rates
from intent_engine.execution.parts import Parts
from intent_engine.execution.policy import Policy
from intent_engine.execution.robots.robot import Robot
from intent_engine.execution.runs import VelocityLoop
from intent_engine.execution.snapshot import Snapshot
from intent_engine.execution.stops import StopCall

__all__ = ["Executor", "Snapshot"]


class Executor:
    """Carries out actions on a robot. All methods may be called from any thread, listeners and handlers included.

    Args:
        robot: what to drive. It is not closed with the executor: who made it closes it.
        limits: of this robot; None: the robot's own (``robot.limits``, as they are now), or none but that numbers are
            numbers.
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
        handle_sigterm: stop the robot when the process is asked to end, or its terminal is closed (where SIGTERM or
            SIGHUP have no other handler yet, and this is made in the main thread).

    Raises:
        TypeError: the robot lacks methods, or is a class and not an instance; or something else is not what it should.
        ValueError: a time below zero, a policy that there is not, or a robot that another executor drives.
    """

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
        check_robot(robot)
        shutdown.check_free(robot)
        given.check_parts(clock, rates, loop, journal, on_event)
        given.check_number("hold_limit", hold_limit)
        given.check_number("queue_limit", queue_limit, "goals")
        self._parts = parts = Parts(
            robot, limits, clock, handlers or {}, loop, rates, policies or {}, expire_after, hold_limit, queue_limit
        )
        self.robot, self.rates, self.clock, self.loop = robot, parts.rates, parts.clock, parts.loop
        self._books, self._conductor, self._events = parts.books, parts.conductor, parts.events
        self._failsafe, self._admission, self._intake = parts.failsafe, parts.admission, parts.intake
        self._pulse, self._waiting, self._life = parts.pulse, parts.waiting, parts.life
        self._utterance = 0
        for listener in (journal, on_event):
            if listener is not None:
                self._events.subscribe(listener)
        self._life.begin(self.clock, self._pulse, handle_sigterm)

    # -- commands ----------------------------------------------------------------------------------------------------

    def submit(
        self,
        actions: Action | Iterable[Action],
        spoken_at: float | None = None,
        *,
        policy: Policy | str | None = None,
        keep: Keep | str | Sequence[Keep | str] = Keep.DISTANCE,
        text: str | None = None,
        amends: Goal | None = None,
        guards: Sequence[Guard | None] = (),
    ) -> list[Goal]:
        """Carry out the actions of one utterance, in order; a newer utterance takes the place of an older one.

        Either all of them are accepted or none: half of what was said is never done. What was asked for before a stop
        is rejected as well, if that comes before this call has returned; so is what a handler submits that was begun
        before the stop, unless it was the handler that stopped, and what one submits that had to make way.

        Args:
            actions: what to do. A :class:`Stop` that comes first stops at once, whatever else is going on.
            spoken_at: when the words ended, or the program decided, on the executor's clock. What was said before a
                stop is rejected.
            policy: what to do with what is being carried out; None: the policy of the first action's type.
            keep: whether ramps cost a motion time (``distance``) or way (``duration``); one for all, or one for each.
            text: what was said, for the journal.
            amends: an earlier goal that the first action puts right, as "turn left" becomes "turn left ninety degrees":
                what that has covered already counts, if both drive, or turn, in the same direction. A robot that has
                come further already comes to rest; it does not go back.
            guards: one for each action, or none at all; None: none for this one. It is asked when the action's turn has
                come, which may be long after this call, under the executor's lock: it must answer at once. If it gives
                a reason, or raises, the action is not done, nor is what comes after it in the same call.

        Returns:
            A goal for each action, in order; rejected with :attr:`Reason.ROBOT_ERROR` while the robot hangs in a call
            that another thread has made.

        Raises:
            TypeError: something that is not an action was submitted, a guard that cannot be called, or what is no goal.
            ValueError: an unknown policy, an unknown keep or not one for each action, not a guard for each, or a time
                that is none.
        """
        stops = self._books.stops
        since: object = stops.since
        several = isinstance(actions, Iterable) and not isinstance(actions, Mapping)
        listed: list[Action] = list(actions) if several else [actions]  # type: ignore[arg-type, list-item]
        if listed and isinstance(listed[0], Stop):
            # Whatever may be wrong with the rest.
            since = self._stop(Reason.STOP, EventKind.STOP, given.time_of(spoken_at))
        actions_of("submit", listed)
        terms = checked(listed, keep, spoken_at, guards)
        if text is not None:
            given.check_text("text", text)
        taken = given.named(Policy, "policy", policy) if policy is not None else None
        amends = given.goal_of("amends", amends, self) if amends is not None else None
        if not listed:
            return []
        try:
            with self._books.asked() as free:
                now = self.clock.now() if free is None else free
                self._utterance += 1
                made = partial(Goal, wait=self._wait_for, askers=stops.leases.askers, part_of=stops.leases.part_of)
                goals = [made(action, now, spoken_at, self._utterance, text) for action in listed]
                if free is None:
                    self._intake.turn_away(goals, now)
                    return goals
                with self._pulse.whole():
                    self._conductor.take(goals, terms, taken, now, since, amends)
                self._pulse.advance(now)
        finally:
            self._events.flush()
        return goals

    def stop(self, *, spoken_at: float | None = None) -> None:
        """Zero velocity now, every goal and task ended, the queue, a hold and a pause forgotten. From any thread.

        Args:
            spoken_at: when its words ended, on the executor's clock; None: now. What was said before it, and is
                submitted after it, is rejected.

        Raises:
            TypeError: that is no number. The robot is stopped.
            ValueError: it is no time. The robot is stopped.
        """
        self._stop(Reason.STOP, EventKind.STOP, given.time_of(spoken_at))
        given.check_spoken(spoken_at)

    def estop(self) -> None:
        """Stop, and refuse every command but another stop until :meth:`reset`."""
        self._intake.estopped = True
        self._stop(Reason.ESTOP, EventKind.ESTOP)

    def reset(self) -> None:
        """End an emergency stop, or start a velocity loop again that died. Nothing moves until the next submit.

        Raises:
            RobotError: the velocity loop could not be started, or the robot hangs in a call; no motion is accepted
                until it can.
        """
        with self._books.asked() as now:
            if now is None:
                raise RobotError(HANGS)
            self._intake.estopped = False
            if self._failsafe.fault and hasattr(self.loop, "restart"):
                self.loop.restart()
            self._failsafe.fault = ""
            self._events.tell(EventKind.RESET)
        self._events.flush()

    def hold(self) -> None:
        """Zero velocity now, as :meth:`stop`, but :meth:`release` lets the motion go on where it stood.

        For a stop that is not certain yet. Nobody's release within ``hold_limit`` makes a stop of it, and so does a
        robot that hangs in a call.
        """
        with self._books.held() as now:
            if now is not None and not (self._conductor.closed or self._conductor.held):
                self._conductor.hold(now, self._failsafe.stop_robot())
                self._events.tell(EventKind.HOLD)
                self._books.wake.notify_all()
        self._events.flush()

    def release(self) -> None:
        """End a hold: motions cover what was left of them, navigation is given again. Not while the robot hangs in a
        call."""
        with self._books.asked() as now:
            if now is not None and self._conductor.held:
                self._events.tell(EventKind.RELEASE)
                self._conductor.release(now)
                self._books.wake.notify_all()
        self._events.flush()

    def pause(self) -> None:
        """Come to rest with the robot's deceleration, and wait for :meth:`resume`. A robot that hangs is stopped."""
        with self._books.resting() as now:
            if now is not None and not (self._conductor.closed or self._conductor.paused):
                self._events.tell(EventKind.PAUSE)
                self._conductor.pause(now)
                self._pulse.advance(now)
        self._events.flush()

    def resume(self) -> None:
        """Go on after :meth:`pause`. Not while the robot hangs in a call."""
        with self._books.asked() as now:
            if now is not None and self._conductor.paused:
                self._events.tell(EventKind.RESUME)
                self._conductor.resume(now)
                self._books.wake.notify_all()
        self._events.flush()

    def cancel(self, goal: Goal) -> None:
        """End one goal, and what was said with it after it; a motion comes to rest with the robot's deceleration. A
        robot that hangs is stopped.

        Raises:
            TypeError: it is no goal.
            ValueError: it is another executor's.
        """
        goal = given.goal_of("cancel", goal, self)
        with self._books.resting() as now:
            if now is not None:
                self._conductor.cancel(goal, now)
                self._pulse.advance(now)
        self._events.flush()

    def deny(self, actions: Action | Iterable[Action], *, spoken_at: float | None = None) -> bool:
        """Stop, if one of these is being carried out or waits its turn: "don't clean the lab" to a robot that does; and
        a robot that hangs in a call, whatever it does.

        What the handler of one of them submits is a part of it. Listeners are told in any case, since others may do it:
        an action may have been handed over to them.

        Args:
            actions: :attr:`Interpretation.denied`. What they leave open may be anything: a custom action without slots
                denies all of its name.
            spoken_at: as of :meth:`stop`.

        Returns:
            Whether it stopped.

        Raises:
            TypeError: something that is not an action was denied, or the time is no number.
            ValueError: it is no time.
        """
        listed = actions_of("deny", actions)
        if not listed:
            return False
        with self._books.asked() as now:
            self._events.tell(EventKind.DENY, denied=listed)
            found = now is None or does([*self._conductor.goals, *self._books.stops.at_work], listed)
        if found:
            self.stop(spoken_at=spoken_at)
        self._events.flush()
        given.check_spoken(spoken_at)
        return found

    def register(self, name: str, handler: Handler) -> None:
        """Let ``handler(action)`` or ``handler(action, context)`` carry out the custom action ``name``.

        A handler registered under the type of an action (``pick``) is used where the robot cannot do it itself.
        It runs in a thread of its own; what it raises aborts its goal and nothing else.

        Raises:
            TypeError: the name is no text, or nothing can be called with an action.
        """
        given.check_handler("register", name, handler)
        with self._books.lock:
            self._admission.handlers[name] = handler

    def subscribe(self, listener: Listener) -> Callable[[], None]:
        """Call ``listener`` with every event, in order, in a thread that is not the executor's.

        Returns:
            What ends the subscription; what cannot be called is a TypeError.
        """
        given.check_listener("a listener", listener)
        return self._events.subscribe(listener)

    # -- waiting -----------------------------------------------------------------------------------------------------

    def wait(self, goals: Goal | Iterable[Goal] | None = None, timeout: float | None = None) -> bool:
        """Wait until the goals (None: everything submitted) have ended. On a virtual clock this moves the clock.

        Returns:
            False if ``timeout`` s went by first, or, on a virtual clock, if nothing more is due (a pause).

        Raises:
            RuntimeError: a handler waits without a timeout for its own goal, which ends when the handler does, or for
                one that waits its turn behind it.
        """
        listed = None if goals is None else given.goals_of("wait", goals, self)
        return self._waiting.wait(listed, timeout)

    def settle(self, timeout: float = 1.0) -> bool:
        """Wait until every listener was called with all that has happened; False if that takes more than ``timeout`` s.

        :meth:`wait` waits for no listener: one that hangs would hold up whoever waits for the robot.
        """
        given.check_number("timeout", timeout)
        return self._events.settle(timeout)

    def run_until_idle(self) -> bool:
        """On a virtual clock: carry everything out, zeros that end a motion included."""
        return self.clock.run_until_idle() if isinstance(self.clock, SteppedClock) else self.wait()

    @property
    def idle(self) -> bool:
        """Nothing is being carried out and nothing waits."""
        return self._parts.idle

    @property
    def limits(self) -> Limits:
        """Those that it was made with, for good: another limit is another executor's."""
        return self._admission.limits

    @property
    def estopped(self) -> bool:
        return self._intake.estopped

    def snapshot(self) -> Snapshot:
        """How things stand; without a pose, where the robot hangs in a call."""
        return self._parts.snapshot()

    # -- end ---------------------------------------------------------------------------------------------------------

    def close(self) -> None:
        """Stop, end the thread, write the last zeros. What is submitted afterwards is rejected. Idempotent.

        A robot that hangs in a call is not waited for longer than some seconds; what was asked of it ends when it
        answers.
        """
        self._life.close()

    def __reduce__(self) -> str:
        raise TypeError(
            "an Executor drives a robot and cannot be copied or pickled: share it between threads, and hand actions "
            "to its process, which pickle and have to_json"
        )

    def __enter__(self) -> Executor:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _stop(self, reason: Reason, kind: EventKind, said: float | None = None) -> StopCall:
        """Stop; what comes after it is asked for since what is returned."""
        stop = self._books.stop(reason, kind, said)
        self._events.flush()
        return stop

    def _wait_for(self, goal: Goal, timeout: float | None) -> None:
        self._waiting.wait_for(goal, timeout)
