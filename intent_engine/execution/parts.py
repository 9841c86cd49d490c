"""The parts of an executor, put together: each is given the others that it calls, and no more."""

from __future__ import annotations

from collections.abc import Mapping

from intent_engine.execution import given
from intent_engine.execution.admission import Admission, limits_of
from intent_engine.execution.books import Books
from intent_engine.execution.carriers import Carriers
from intent_engine.execution.clock import Clock, MonotonicClock, SteppedClock
from intent_engine.execution.conductor import Conductor
from intent_engine.execution.events import Dispatcher, EventKind
from intent_engine.execution.failsafe import Failsafe
from intent_engine.execution.gate import Gate
from intent_engine.execution.goal import Reason
from intent_engine.execution.handlers import Handler
from intent_engine.execution.intake import Intake
from intent_engine.execution.life import Life
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Follower, Rates
from intent_engine.execution.policy import Policy
from intent_engine.execution.progress import Progress
from intent_engine.execution.pulse import Pulse
from intent_engine.execution.robots.robot import Robot
from intent_engine.execution.runs import VelocityLoop
from intent_engine.execution.snapshot import Snapshot
from intent_engine.execution.waiting import Waiting

__all__ = ["Parts"]


class Parts:
    """What is between the methods of an :class:`~intent_engine.execution.executor.Executor` and its robot.

    The arguments are the executor's, which has seen that they are what they should be.

    Raises:
        TypeError: the robot's own clock is none, or something else of it is not what it should be.
        ValueError: a policy that there is not, or a velocity loop in another process for a virtual clock, or with other
            accelerations.
    """

    def __init__(
        self,
        robot: Robot,
        limits: Limits | None,
        clock: Clock | None,
        handlers: Mapping[str, Handler],
        loop: VelocityLoop | None,
        rates: Rates | None,
        policies: Mapping[str, Policy | str],
        expire_after: float,
        hold_limit: float,
        queue_limit: int,
    ) -> None:
        limits = limits_of(robot, limits)
        given.check_loop(loop, limits)
        self.rates: Rates = rates or getattr(robot, "rates", None) or Rates()
        self.clock: Clock = clock or getattr(robot, "clock", None) or MonotonicClock()
        given.check_clock(self.clock)
        if hasattr(robot, "use_clock"):
            robot.use_clock(self.clock)
        gate = Gate(robot)
        self.loop: VelocityLoop = loop if loop is not None else Follower(gate, limits, self.rates)
        self.admission = Admission(robot, limits, handlers, policies, expire_after)
        stepped = isinstance(self.clock, SteppedClock)
        if stepped and loop is not None:
            raise ValueError("a velocity loop in another process cannot follow a virtual clock; give no loop")
        self.events = events = Dispatcher(self.clock.now, threaded=not stepped)
        self.failsafe = failsafe = Failsafe(robot, self.loop, gate, events, self.rates.valid_for)
        self.books = books = Books(self.clock, gate, failsafe, lambda *stop: self.conductor.stop(*stop))
        self.waiting = Waiting(self.clock, books.ended, lambda: self.idle)
        stops = books.stops
        carriers = Carriers(
            robot,
            self.admission,
            self.loop,
            lambda goal, work: events.launch(stops.carrying_out(goal, work)),
            books.poke,
            failsafe.stop_robot,
        )
        progress = Progress(events, failsafe, books.tell_ended)
        self.intake = Intake(self.admission, failsafe, stops, progress, queue_limit)
        self.conductor = Conductor(
            self.admission, carriers, self.loop, failsafe, events, self.intake, progress, stops, hold_limit
        )
        self.pulse = Pulse(books, self.conductor, events, self.clock)
        self.life = Life(robot, self.loop, gate, failsafe, books, events, self.intake, self.waiting, self.rates.zeros)
        if hasattr(self.loop, "attach"):
            self.loop.attach(books.poke, failsafe.stop_robot)
        if hasattr(robot, "when_gone"):
            robot.when_gone(lambda: books.stop(Reason.ROBOT_ERROR, EventKind.STOP))

    @property
    def idle(self) -> bool:
        """Nothing is being carried out and nothing waits."""
        with self.books.asked() as now:
            return now is not None and self.conductor.idle

    def snapshot(self) -> Snapshot:
        """How things stand. A robot that hangs is not asked where it is."""
        with self.books.asked() as free:
            pose = self.failsafe.pose() if free is not None else None
            now, estopped, written = self.conductor, self.intake.estopped, self.loop.written
            return Snapshot(
                now.running, now.queued, now.held, now.paused, estopped, now.closed, written, pose, free is None
            )
