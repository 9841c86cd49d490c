"""A simulated differential-drive robot: a pose, a map, things to carry, and (if wished) slip and delay.

The motion between two commands is integrated in closed form, so that on a virtual clock a metre is a metre to the
last bit, whatever the rate of the commands. It has no thread: it works out where it is whenever it is asked.
"""

from __future__ import annotations

import logging
import math
import random
import threading
from collections import deque
from collections.abc import Callable, Iterable, Mapping

from intent_engine.errors import RobotError
from intent_engine.execution.clock import Clock, MonotonicClock, SteppedClock
from intent_engine.execution.given import capabilities_of, check_clock, check_number, check_pose
from intent_engine.execution.robots.kinematics import drive
from intent_engine.execution.robots.robot import Capability, Pose, Task, TaskState
from intent_engine.execution.robots.simulated_hand import SimulatedHand
from intent_engine.execution.robots.simulated_task import SimulatedTask, route
from intent_engine.execution.robots.trace import TracePoint

__all__ = ["SimulatedRobot"]

log = logging.getLogger(__name__)

EVERYTHING = frozenset(Capability)


class SimulatedRobot:
    """A differential drive on a flat floor. Thread-safe.

    Args:
        clock: shared with the executor; None: the executor's, or the machine's if there is none.
        start: pose at the beginning.
        locations: name -> pose, for ``place`` and for plots.
        objects: object -> name of a location, a pose, or None for "at hand". With ``objects=None`` everything can be
            picked anywhere; with a mapping only what it holds, and only within ``reach``.
        acceleration: m/s^2 (and rad/s^2, ``angular_acceleration``) that the wheels can do; infinite: a command is
            followed at once.
        slip: standard deviation of the part of each commanded velocity that is lost or gained (0.05: five per cent).
        delay: s from a command to its effect. ``stop`` is not delayed.
        seed: of the slip; the same seed and the same commands give the same path.
        navigation_speed, navigation_turn: m/s and rad/s of its own navigation.
        hand_time: s that a pick or a place takes.
        reach: m within which it can pick and place.
    """

    def __init__(
        self,
        clock: Clock | None = None,
        *,
        start: Pose = Pose(0.0, 0.0, 0.0),  # noqa: B008 (frozen)
        locations: Mapping[str, Pose] | None = None,
        objects: Mapping[str, str | Pose | None] | None = None,
        capabilities: Iterable[Capability] = EVERYTHING,
        acceleration: float = math.inf,
        angular_acceleration: float = math.inf,
        slip: float = 0.0,
        delay: float = 0.0,
        seed: int = 0,
        navigation_speed: float = 0.5,
        navigation_turn: float = 1.0,
        hand_time: float = 2.0,
        reach: float = 1.0,
    ) -> None:
        check_clock(clock)
        check_pose("start", start)
        for name, places in (("locations", locations), ("objects", objects)):
            if places is not None and not isinstance(places, Mapping):
                raise TypeError(f"{name} are a dictionary by name, not {places!r:.80}")
        for name, where in (locations or {}).items():
            check_pose(f"the location {name!r}", where)
        for name, value, unit in (
            ("acceleration", acceleration, "m/s^2"),
            ("angular_acceleration", angular_acceleration, "rad/s^2"),
            ("navigation_speed", navigation_speed, "m/s"),
            ("navigation_turn", navigation_turn, "rad/s"),
        ):
            check_number(name, value, unit, positive=True)
        for name, value, unit in (("slip", slip, "1"), ("delay", delay, "s"), ("hand_time", hand_time, "s")):
            check_number(name, value, unit)
        check_number("reach", reach, "m")
        self.locations = dict(locations or {})
        self._hand = SimulatedHand(self.locations, objects, reach)
        self.start = start
        self._capabilities = capabilities_of(capabilities)
        self._acceleration = (acceleration, angular_acceleration)
        self._slip, self._delay, self._random = slip, delay, random.Random(seed)
        self._navigation_speed, self._navigation_turn = navigation_speed, navigation_turn
        self._hand_time = hand_time
        self._clock: Clock | None = None
        self._lock = threading.RLock()
        self._pose = start
        self._speed = (0.0, 0.0)
        """m/s and rad/s at ``_time``"""
        self._target = (0.0, 0.0)
        self._valid_until = -math.inf
        self._time = 0.0
        self._pending: deque[tuple[float, float, float, float]] = deque()
        """Commands on their way: when they take effect, linear, angular, valid until"""
        self._task: SimulatedTask | None = None
        self._closed = False
        self.trace: deque[TracePoint] = deque(maxlen=200_000)
        self.writes = 0
        """Velocities received"""
        if clock is not None:
            self.use_clock(clock)

    # -- clock -------------------------------------------------------------------------------------------------------

    @property
    def clock(self) -> Clock:
        if self._clock is None:
            self.use_clock(MonotonicClock())
        assert self._clock is not None
        return self._clock

    def use_clock(self, clock: Clock) -> None:
        """Share the executor's clock; a robot that has one already must have been given the same.

        Raises:
            RobotError: it has another one.
        """
        if self._clock is clock:
            return
        if self._clock is not None:
            raise RobotError("the simulated robot and the executor have different clocks; give both the same one")
        self._clock, self._time = clock, clock.now()
        self.trace.append(TracePoint(self._time, self._pose, 0.0, 0.0))
        if isinstance(clock, SteppedClock):
            clock.attach(self)

    def due(self) -> float | None:
        """When its task ends: a virtual clock stops there, so that the executor hears of it at its very time."""
        with self._lock:
            return max(self._task.end, self._time) if self._task is not None else None

    def step(self) -> None:
        self.update()

    # -- robot -------------------------------------------------------------------------------------------------------

    @property
    def capabilities(self) -> frozenset[Capability]:
        return self._capabilities

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        if not (math.isfinite(linear) and math.isfinite(angular) and valid_for >= 0):
            raise RobotError(f"velocity({linear}, {angular}, {valid_for}): not numbers to drive by")
        with self._lock:
            self._open()
            callbacks = self._advance()
            self.writes += 1
            if (linear or angular) and self._task is not None and self._task.kind == "navigate":
                callbacks += self._end_task(TaskState.FAILED, "a velocity was commanded during the navigation")
            if self._slip and (linear or angular):
                linear *= 1.0 + self._random.gauss(0.0, self._slip)
                angular *= 1.0 + self._random.gauss(0.0, self._slip)
            effect = self._time + self._delay
            self._pending.append((effect, linear, angular, effect + valid_for))
            self._apply_pending()
        _call(callbacks)

    def stop(self) -> None:
        with self._lock:
            if self._clock is None:
                return
            callbacks = self._advance()
            self._pending.clear()
            self._speed = self._target = (0.0, 0.0)
            self._mark()
            callbacks += self._end_task(TaskState.CANCELED, "stopped")
        _call(callbacks)

    def navigate(self, goal: Pose) -> Task:
        with self._lock:
            self._open()
            callbacks = self._advance()
            callbacks += self._end_task(TaskState.CANCELED, "another goal came")
            self._speed = self._target = (0.0, 0.0)
            self._pending.clear()
            legs = tuple(route(self._pose, goal, self._time, self._navigation_speed, self._navigation_turn))
            end = legs[-1].end if legs else self._time
            task = self._begin(SimulatedTask(self, "navigate", self._time, end))
            task.legs = legs

            def arrive() -> str:
                self._pose = goal
                return ""

            task.finish = arrive
            self._mark()
        _call(callbacks)
        return task

    def pick(self, object_name: str) -> Task:
        return self._use_hand("pick", lambda: self._hand.take(object_name, self._pose))

    def place(self, object_name: str | None, location: str | None) -> Task:
        return self._use_hand("place", lambda: self._hand.put(object_name, location, self._pose))

    def cancel(self, task: Task) -> None:
        with self._lock:
            callbacks = self._advance()
            if task is self._task:
                callbacks += self._end_task(TaskState.CANCELED, "cancelled")
        _call(callbacks)

    def pose(self) -> Pose:
        self.update()
        return self._pose

    def close(self) -> None:
        if self._closed:
            return
        self.stop()
        self._closed = True
        if isinstance(self._clock, SteppedClock):
            self._clock.detach(self)

    @property
    def holding(self) -> str | None:
        """What is in its hand."""
        return self._hand.holding

    @property
    def objects(self) -> Mapping[str, Pose | None] | None:
        """Where things lie (None: at hand); None: everything is everywhere."""
        return self._hand.objects

    def speed(self) -> tuple[float, float]:
        """What the wheels do now: m/s, rad/s."""
        self.update()
        with self._lock:
            task = self._task
            if task is not None:
                for leg in task.legs:
                    if leg.start <= self._time < leg.end:
                        return (leg.linear, leg.angular)
            return self._speed

    def update(self) -> None:
        """Bring the pose to the present time, and end the task whose time has come."""
        with self._lock:
            callbacks = self._advance()
        _call(callbacks)

    # -- inside ------------------------------------------------------------------------------------------------------

    def _open(self) -> None:
        if self._closed:
            raise RobotError("the simulated robot is closed")

    def _advance(self) -> list[Callable[[], None]]:
        """Integrate up to now; returns the calls to make when the lock is released."""
        now = self.clock.now()
        callbacks: list[Callable[[], None]] = []
        while True:
            until = now
            if self._pending:
                until = min(until, self._pending[0][0])
            if self._task is not None:
                until = min(until, self._task.end)
            if until > self._time:
                self._integrate(until)
            self._apply_pending()
            if self._task is not None and self._task.end <= self._time:
                failed = self._task.finish()
                state = TaskState.FAILED if failed else TaskState.SUCCEEDED
                callbacks += self._end_task(state, failed)
                self._mark()
            if self._time >= now:
                return callbacks

    def _apply_pending(self) -> None:
        while self._pending and self._pending[0][0] <= self._time:
            _, linear, angular, valid_until = self._pending.popleft()
            target = (linear, angular)
            changed = target != self._target
            self._target, self._valid_until = target, valid_until
            if math.isinf(self._acceleration[0]):
                self._speed = (linear, self._speed[1])
            if math.isinf(self._acceleration[1]):
                self._speed = (self._speed[0], angular)
            if changed:
                self._mark()

    def _integrate(self, until: float) -> None:
        """Move on in pieces of constant acceleration: up to the end of validity, and to the end of each ramp."""
        task = self._task
        if task is not None and task.legs:
            leg = next((leg for leg in task.legs if until < leg.end), task.legs[-1])
            for passed in task.legs:
                if self._time < passed.start <= until:
                    self.trace.append(TracePoint(passed.start, passed.begin, passed.linear, passed.angular))
            self._pose, self._time = leg.pose(until), until
            return
        while self._time < until:
            target = self._target if self._time < self._valid_until else (0.0, 0.0)
            end = min(until, self._valid_until) if self._time < self._valid_until else until
            rates = [0.0, 0.0]
            speed = list(self._speed)
            for axis in (0, 1):
                change = target[axis] - speed[axis]
                if change and math.isinf(self._acceleration[axis]):
                    speed[axis] = target[axis]
                elif change:
                    rates[axis] = math.copysign(self._acceleration[axis], change)
                    ramp_end = self._time + change / rates[axis]
                    if ramp_end > self._time:
                        end = min(end, ramp_end)
                    else:
                        speed[axis], rates[axis] = target[axis], 0.0
            t = end - self._time
            self._pose = drive(self._pose, speed[0], rates[0], speed[1], rates[1], t)
            after = [speed[axis] + rates[axis] * t for axis in (0, 1)]
            for axis in (0, 1):
                if abs(target[axis] - after[axis]) < 1e-12:
                    after[axis] = target[axis]
            changed = (after[0], after[1]) != self._speed
            self._speed, self._time = (after[0], after[1]), end
            if changed:
                self._mark()

    def _mark(self) -> None:
        if self.trace and self.trace[-1].time == self._time:
            self.trace.pop()
        self.trace.append(TracePoint(self._time, self._pose, *self._speed))

    def _use_hand(self, kind: str, finish: Callable[[], str]) -> Task:
        with self._lock:
            self._open()
            callbacks = self._advance()
            callbacks += self._end_task(TaskState.CANCELED, "another task came")
            task = self._begin(SimulatedTask(self, kind, self._time, self._time + self._hand_time))
            task.finish = finish
        _call(callbacks)
        return task

    def _begin(self, task: SimulatedTask) -> SimulatedTask:
        self._task = task
        return task

    def _end_task(self, state: TaskState, reason: str) -> list[Callable[[], None]]:
        task, self._task = self._task, None
        if task is None:
            return []
        callbacks = task.end_as(state, reason)
        return [lambda callback=callback: callback(task) for callback in callbacks]  # type: ignore[misc]


def _call(callbacks: list[Callable[[], None]]) -> None:
    for callback in callbacks:
        try:
            callback()
        except Exception:
            log.exception("a callback of the simulated robot raised")
