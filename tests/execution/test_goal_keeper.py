"""The rules of navigation goals against a server at the end of slow roads, on a clock that nobody waits for."""

from __future__ import annotations

import heapq
import itertools
import math
import random
import uuid as uuids
from collections.abc import Callable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.execution.robots.goal_keeper import ABORTED, CANCELED, CANCELING, SUCCEEDED, GoalKeeper
from intent_engine.execution.robots.remote_task import RemoteTask
from intent_engine.execution.robots.robot import Pose, TaskState

EXECUTING = 2
FOR_EVER = 1e6


class World:
    """A navigation server, the roads to it, and time. Goals and cancels travel apart, each road in its order."""

    def __init__(self, names_goals: bool, seed: int = 0, delay: float = 0.05, deaf: int = 0) -> None:
        self.names_goals = names_goals
        self.random, self.delay = random.Random(seed), delay
        self.now = 0.0
        self.events: list[tuple[float, int, Callable[[], None]]] = []
        self.order = itertools.count()
        self.last: dict[str, float] = {}
        self.states: dict[bytes, int] = {}
        self.ends: dict[bytes, float] = {}
        self.deaf = deaf
        """How many cancels the server refuses."""
        self.reachable = True
        self.told_by = frozenset({b"first"})
        self.takes_goals = True
        self.cancels = 0
        self.numbers = itertools.count(1)
        self.keeper = GoalKeeper(self)

    # -- what the keeper calls ---------------------------------------------------------------------------------------

    def unavailable(self) -> str:
        return "" if self.reachable else "no server"

    def servers(self) -> frozenset[bytes]:
        return self.told_by

    def send(self, goal: Pose, uuid: bytes) -> None:
        self.travel("goal", lambda: self.take(uuid if self.names_goals else uuids.uuid4().bytes, goal.x))

    def cancel(self, uuid: bytes | None, number: int) -> bool:
        if not self.reachable:
            return False
        self.cancels += 1
        self.travel("cancel", lambda: self.take_cancel(uuid, number))
        return True

    # -- the server --------------------------------------------------------------------------------------------------

    def take(self, uuid: bytes, seconds: float) -> None:
        if not self.takes_goals:
            return
        self.states[uuid] = EXECUTING
        if seconds < FOR_EVER:
            self.at(self.now + seconds, lambda: self.finish(uuid, SUCCEEDED))
        self.tell()
        if self.names_goals:
            self.travel("answer", lambda: self.keeper.heard_answer(uuid, True, self.now))

    def take_cancel(self, uuid: bytes | None, number: int) -> None:
        driven = [each for each, state in self.states.items() if state == EXECUTING and uuid in (None, each)]
        refused = bool(driven) and self.deaf > 0
        if refused:
            self.deaf -= 1
        else:
            for each in driven:
                self.states[each] = CANCELING
                braked = self.now + self.random.uniform(0, self.delay)
                self.at(braked, lambda each=each: self.finish(each, CANCELED))
            self.tell()
        self.travel("cancel answer", lambda: self.keeper.heard_cancel(number, refused, self.now))

    def finish(self, uuid: bytes, state: int) -> None:
        if self.states[uuid] in (EXECUTING, CANCELING):
            self.states[uuid] = state
            self.tell()
            if self.names_goals:
                self.travel("result", lambda: self.keeper.heard_result(uuid, state, "", self.now))

    def tell(self) -> None:
        states = dict(self.states)
        self.travel("status", lambda: self.keeper.heard_status(states, self.now))

    def active(self) -> int:
        return sum(state in (EXECUTING, CANCELING) for state in self.states.values())

    # -- time and roads ----------------------------------------------------------------------------------------------

    def at(self, time: float, do: Callable[[], None]) -> None:
        heapq.heappush(self.events, (time, next(self.order), do))

    def travel(self, road: str, do: Callable[[], None]) -> None:
        arrival = max(self.now + self.random.uniform(0, self.delay), self.last.get(road, 0.0))
        self.last[road] = arrival
        self.at(arrival, do)

    def run(self, seconds: float) -> None:
        end, steps = self.now + seconds, 0
        while True:
            due = self.keeper.due(self.now)
            first = self.events[0][0] if self.events else math.inf
            moment = min(first, math.inf if due is None else due)
            steps = steps + 1 if moment <= self.now else 0
            assert steps < 1000, "time stands still"
            if moment > end:
                self.now = end
                return
            self.now = max(self.now, moment)
            if first <= self.now:
                heapq.heappop(self.events)[2]()
            else:
                self.keeper.step(self.now)

    # -- commands ----------------------------------------------------------------------------------------------------

    def navigate(self, seconds: float = FOR_EVER) -> RemoteTask:
        task = RemoteTask(next(self.numbers))
        self.keeper.navigate(task, Pose(seconds, 0.0, 0.0), self.now)
        return task

    def stop(self) -> None:
        self.keeper.stop(self.now)


WAYS = pytest.mark.parametrize("names_goals", [True, False], ids=["action", "goal_pose"])

commands = st.lists(
    st.tuples(
        st.sampled_from(["navigate", "short", "stop", "cancel", "foreign"]),
        st.one_of(st.just(0.0), st.floats(0.0, 0.2), st.floats(0.0, 2.0)),
    ),
    max_size=8,
)


@settings(max_examples=200, deadline=None)
@given(commands, st.booleans(), st.integers(0, 10_000), st.floats(0.0, 0.3), st.integers(0, 3))
def test_after_a_stop_nothing_drives_and_every_task_ends_once(script, names_goals, seed, delay, deaf):
    world = World(names_goals, seed, delay, deaf)
    tasks: list[RemoteTask] = []
    ends: list[int] = []
    for what, pause in script:
        if what in ("navigate", "short"):
            tasks.append(world.navigate(FOR_EVER if what == "navigate" else 0.1))
            tasks[-1].add_done_callback(lambda task: ends.append(task.number))
        elif what == "cancel" and tasks:
            world.keeper.cancel(tasks[-1], world.now)
        elif what == "foreign" and names_goals:
            world.take(uuids.uuid4().bytes, FOR_EVER)
        elif what == "stop":
            world.stop()
        world.run(pause)
    world.stop()
    world.run(20.0)
    assert world.active() == 0
    assert world.keeper.quiet
    assert sorted(ends) == [task.number for task in tasks]
    asked = world.cancels
    world.run(20.0)
    assert world.cancels == asked  # and then there is silence


@settings(max_examples=100, deadline=None)
@given(st.booleans(), st.integers(0, 10_000), st.floats(0.0, 0.3), st.floats(0.0, 1.0), st.integers(1, 4))
def test_a_goal_after_a_stop_is_not_the_stops(names_goals, seed, delay, pause, stops):
    world = World(names_goals, seed, delay)
    first = world.navigate()
    world.run(pause)
    for _ in range(stops):
        world.stop()
    second = world.navigate(1.0)
    world.run(30.0)
    assert (first.state, second.state) == (TaskState.CANCELED, TaskState.SUCCEEDED)


@WAYS
def test_a_lost_goal_fails_and_is_ended_should_it_come_late(names_goals):
    world = World(names_goals)
    world.takes_goals = False
    task = world.navigate()
    world.run(GoalKeeper.APPEAR + 0.1)
    assert task.state is TaskState.FAILED
    assert "did not take the goal" in task.reason
    world.takes_goals = True
    world.take(world.keeper._current.uuid or uuids.uuid4().bytes, FOR_EVER)
    world.run(5.0)
    assert world.active() == 0
    assert world.keeper.quiet


@WAYS
def test_a_server_that_does_not_end_a_goal_is_asked_on_and_on(names_goals):
    world = World(names_goals, deaf=200)
    task = world.navigate()
    world.run(0.5)
    world.keeper.cancel(task, world.now)
    world.run(8.0)
    assert task.state is TaskState.RUNNING
    world.run(10.0)
    assert task.state is TaskState.CANCELED
    assert world.active() == 0


@WAYS
def test_a_server_that_goes_away(names_goals):
    world = World(names_goals)
    task = world.navigate()
    world.run(1.0)
    world.reachable = False
    world.run(GoalKeeper.GONE + 0.5)
    assert task.state is TaskState.FAILED
    assert "gone" in task.reason
    again = world.navigate()
    assert (again.state, again.reason) == (TaskState.FAILED, "no server")
    world.stop()
    assert world.keeper.quiet


@WAYS
def test_a_server_that_was_started_anew_and_says_nothing_is_noticed(names_goals):
    """States are told when they change; and the middleware believes for long in a server that was killed."""
    world = World(names_goals)
    task = world.navigate()
    world.run(1.0)
    assert task.state is TaskState.RUNNING
    world.states.clear()
    world.told_by = frozenset({b"first", b"second"})
    world.run(GoalKeeper.GONE + 0.5)
    assert task.state is TaskState.FAILED
    assert "anew" in task.reason


@WAYS
def test_a_server_that_was_started_anew_has_forgotten_the_goal(names_goals):
    world = World(names_goals)
    task = world.navigate()
    world.run(1.0)
    world.states.clear()
    world.tell()
    world.run(GoalKeeper.GONE + 0.5)
    assert task.state is TaskState.FAILED
    assert "anew" in task.reason


@WAYS
def test_aborted_is_failed_unless_it_was_to_end(names_goals):
    world = World(names_goals)
    task = world.navigate()
    world.run(1.0)
    world.finish(next(iter(world.states)), ABORTED)
    world.run(1.0)
    assert task.state is TaskState.FAILED

    task = world.navigate()
    world.run(1.0)
    world.keeper.cancel(task, world.now)
    world.finish(list(world.states)[-1], ABORTED)
    world.run(1.0)
    assert task.state is TaskState.CANCELED


def test_progress():
    world = World(names_goals=True)
    task = world.navigate()
    world.run(1.0)
    uuid = next(iter(world.states))
    for left, progress in [(0.0, None), (4.0, 0.0), (3.0, 0.25), (float("nan"), 0.25), (0.0, 1.0)]:
        world.keeper.heard_progress(uuid, left)
        assert task.progress == progress


def test_a_stop_with_nothing_to_stop_asks_once():
    world = World(names_goals=True)
    world.stop()
    world.run(10.0)
    assert world.cancels == 1
    assert world.keeper.quiet
