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
from dataclasses import dataclass
from itertools import pairwise

from intent_engine.errors import RobotError
from intent_engine.execution.clock import Clock, MonotonicClock, SteppedClock
from intent_engine.execution.robots.robot import Capability, Pose, Task, TaskState

__all__ = ["SimulatedRobot", "TracePoint", "path_points"]

log = logging.getLogger(__name__)

EVERYTHING = frozenset(Capability)


@dataclass(frozen=True, slots=True)
class TracePoint:
    """One point of the path that the robot drove."""

    time: float
    """s on the robot's clock"""
    pose: Pose
    linear: float
    """m/s from here on"""
    angular: float
    """rad/s from here on"""


class _SimulatedTask:
    def __init__(self, kind: str, start: float, end: float) -> None:
        self.kind = kind
        self.start = start
        self.end = end
        self.finish: Callable[[], str] = lambda: ""
        """Does what the task does at its end; returns why it failed, or nothing."""
        self.legs: tuple[_Leg, ...] = ()
        self._robot: SimulatedRobot | None = None
        self._state = TaskState.RUNNING
        self._reason = ""
        self._callbacks: list[Callable[[Task], None]] = []

    @property
    def state(self) -> TaskState:
        if self._robot is not None:
            self._robot.update()
        return self._state

    @property
    def reason(self) -> str:
        return self._reason

    @property
    def progress(self) -> float | None:
        if self._robot is None or self._state is not TaskState.RUNNING:
            return 1.0 if self._state is TaskState.SUCCEEDED else None
        if self.end <= self.start:
            return 1.0
        return min(max((self._robot.clock.now() - self.start) / (self.end - self.start), 0.0), 1.0)

    def add_done_callback(self, callback: Callable[[Task], None]) -> None:
        if self._state is TaskState.RUNNING:
            self._callbacks.append(callback)
        else:
            callback(self)

    def end_as(self, state: TaskState, reason: str = "") -> list[Callable[[Task], None]]:
        """Leave RUNNING; returns who wants to know."""
        self._state, self._reason = state, reason
        callbacks, self._callbacks = self._callbacks, []
        return callbacks


@dataclass(frozen=True, slots=True)
class _Leg:
    """One part of a navigation: a turn on the spot or a straight line."""

    start: float
    end: float
    begin: Pose
    linear: float
    angular: float

    def pose(self, time: float) -> Pose:
        t = min(max(time, self.start), self.end) - self.start
        return _arc(self.begin, self.linear, self.angular, t)


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
        self.locations = dict(locations or {})
        self.objects: dict[str, Pose | None] | None = None
        if objects is not None:
            self.objects = {name: self._object_pose(name, where) for name, where in objects.items()}
        self.holding: str | None = None
        self.start = start
        self._capabilities = frozenset(capabilities)
        self._acceleration = (acceleration, angular_acceleration)
        self._slip, self._delay, self._random = slip, delay, random.Random(seed)
        self._navigation_speed, self._navigation_turn = navigation_speed, navigation_turn
        self._hand_time, self._reach = hand_time, reach
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
        self._task: _SimulatedTask | None = None
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
            legs = tuple(self._route(goal))
            end = legs[-1].end if legs else self._time
            task = self._begin(_SimulatedTask("navigate", self._time, end))
            task.legs = legs

            def arrive() -> str:
                self._pose = goal
                return ""

            task.finish = arrive
            self._mark()
        _call(callbacks)
        return task

    def pick(self, object_name: str) -> Task:
        return self._hand("pick", lambda: self._take(object_name))

    def place(self, object_name: str | None, location: str | None) -> Task:
        return self._hand("place", lambda: self._put(object_name, location))

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

    def _object_pose(self, name: str, where: str | Pose | None) -> Pose | None:
        if where is None or isinstance(where, Pose):
            return where
        if where not in self.locations:
            raise RobotError(f"{name!r} is said to be at {where!r}, which is not on the simulated robot's map")
        return self.locations[where]

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
            self._pose = _drive(self._pose, speed[0], rates[0], speed[1], rates[1], t)
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

    def _route(self, goal: Pose) -> Iterable[_Leg]:
        """Turn to the goal, drive straight, turn to its heading."""
        time, pose = self._time, self._pose
        dx, dy = goal.x - pose.x, goal.y - pose.y
        distance = math.hypot(dx, dy)
        headings = [(math.atan2(dy, dx), distance)] if distance > 1e-9 else []
        for heading, length in [*headings, (goal.yaw, 0.0)]:
            angle = math.remainder(heading - pose.yaw, math.tau)
            if abs(angle) > 1e-12:
                rate = math.copysign(self._navigation_turn, angle)
                yield _Leg(time, time + abs(angle) / self._navigation_turn, pose, 0.0, rate)
                time += abs(angle) / self._navigation_turn
                pose = Pose(pose.x, pose.y, heading, pose.frame)
            if length:
                duration = length / self._navigation_speed
                yield _Leg(time, time + duration, pose, self._navigation_speed, 0.0)
                time += duration
                pose = Pose(goal.x, goal.y, heading, pose.frame)

    def _hand(self, kind: str, finish: Callable[[], str]) -> Task:
        with self._lock:
            self._open()
            callbacks = self._advance()
            callbacks += self._end_task(TaskState.CANCELED, "another task came")
            task = self._begin(_SimulatedTask(kind, self._time, self._time + self._hand_time))
            task.finish = finish
        _call(callbacks)
        return task

    def _begin(self, task: _SimulatedTask) -> _SimulatedTask:
        task._robot = self
        self._task = task
        return task

    def _end_task(self, state: TaskState, reason: str) -> list[Callable[[], None]]:
        task, self._task = self._task, None
        if task is None:
            return []
        callbacks = task.end_as(state, reason)
        return [lambda callback=callback: callback(task) for callback in callbacks]  # type: ignore[misc]

    def _take(self, name: str) -> str:
        if self.holding is not None:
            return "" if self.holding == name else f"it holds the {self.holding} already"
        if self.objects is not None:
            if name not in self.objects:
                known = ", ".join(sorted(self.objects)) or "nothing"
                return f"there is no {name} here; there is: {known}"
            where = self.objects[name]
            if where is not None and (far := self._distance(where)) > self._reach:
                return f"the {name} is {far:.1f} m away, and it reaches {self._reach:g} m"
        self.holding = name
        return ""

    def _put(self, name: str | None, location: str | None) -> str:
        if self.holding is None:
            return "it holds nothing"
        if name is not None and name != self.holding:
            return f"it holds the {self.holding}, not the {name}"
        place = self._pose
        if location in self.locations:
            place = self.locations[location]
            if (far := self._distance(place)) > self._reach:
                return f"{location} is {far:.1f} m away, and it reaches {self._reach:g} m"
        if self.objects is not None:
            self.objects[self.holding] = place
        self.holding = None
        return ""

    def _distance(self, place: Pose) -> float:
        return math.hypot(place.x - self._pose.x, place.y - self._pose.y)


def path_points(trace: Iterable[TracePoint], end: Pose) -> list[Pose]:
    """The path as poses that straight lines may join: curves are cut into pieces of at most 0.1 rad."""
    marks = list(trace)
    if not marks:
        return [end]
    points = [marks[0].pose]
    for mark, following in pairwise([*marks, None]):
        assert mark is not None
        goal = following.pose if following is not None else end
        turned = goal.yaw - mark.pose.yaw
        if mark.linear and mark.angular and abs(turned) > 0.1:
            length = turned / mark.angular
            steps = math.ceil(abs(turned) / 0.1)
            points += [_arc(mark.pose, mark.linear, mark.angular, length * i / steps) for i in range(1, steps)]
        points.append(goal)
    return points


def _call(callbacks: list[Callable[[], None]]) -> None:
    for callback in callbacks:
        try:
            callback()
        except Exception:
            log.exception("a callback of the simulated robot raised")


def _arc(pose: Pose, linear: float, angular: float, t: float) -> Pose:
    """Constant speeds for ``t`` s: a point, a line or an arc."""
    if angular == 0.0:
        return Pose(
            pose.x + linear * t * math.cos(pose.yaw), pose.y + linear * t * math.sin(pose.yaw), pose.yaw, pose.frame
        )
    yaw = pose.yaw + angular * t
    # sin(b) - sin(a) = 2 cos(mean) sin(half): exact where the arc is nearly a line, too.
    half = angular * t / 2.0
    chord = linear * t * (math.sin(half) / half if half else 1.0)
    return Pose(pose.x + chord * math.cos(pose.yaw + half), pose.y + chord * math.sin(pose.yaw + half), yaw, pose.frame)


def _drive(pose: Pose, linear: float, linear_rate: float, angular: float, angular_rate: float, t: float) -> Pose:
    """Constant accelerations for ``t`` s: in closed form, but for a ramp on a curve (a Fresnel integral)."""
    if angular == 0.0 and angular_rate == 0.0:
        way = linear * t + 0.5 * linear_rate * t * t
        return Pose(pose.x + way * math.cos(pose.yaw), pose.y + way * math.sin(pose.yaw), pose.yaw, pose.frame)
    if linear_rate == 0.0 and angular_rate == 0.0:
        return _arc(pose, linear, angular, t)
    yaw = pose.yaw + angular * t + 0.5 * angular_rate * t * t
    if linear == 0.0 and linear_rate == 0.0:
        return Pose(pose.x, pose.y, yaw, pose.frame)
    # Simpson's rule; its error falls with the fourth power of the step, here below 1e-9 m.
    steps = 2 * max(4, math.ceil(t / 0.02))
    h = t / steps
    x = y = 0.0
    for index in range(steps + 1):
        at = index * h
        weight = 1 if index in (0, steps) else 4 if index % 2 else 2
        heading = pose.yaw + angular * at + 0.5 * angular_rate * at * at
        speed = linear + linear_rate * at
        x += weight * speed * math.cos(heading)
        y += weight * speed * math.sin(heading)
    return Pose(pose.x + x * h / 3.0, pose.y + y * h / 3.0, yaw, pose.frame)
