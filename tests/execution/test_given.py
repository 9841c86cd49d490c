"""What a program gives to an executor and to a simulated robot: wrong things are told where they are given."""

from __future__ import annotations

import asyncio
import functools
import math

import pytest

from intent_engine.actions import Custom, Move, Navigate
from intent_engine.execution.clock import MonotonicClock, VirtualClock
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Rates
from intent_engine.execution.robots.robot import Capability, Pose
from intent_engine.execution.robots.simulated import SimulatedRobot
from intent_engine.language.locations import LocationMap

MOVE = Move(0.5, 1.0, 2.0)
NAVIGATE = Navigate("kitchen", 1.0, 2.0, 0.0)


async def coroutine(*_) -> str:
    return ""


class AsyncCall:
    async def __call__(self, *_) -> str:
        return ""


def generator(_):
    yield 1


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"start": (0, 0, 0)}, r"start is a pose, as Pose\(1\.0, 2\.0, 0\.0\) in m and rad, not \(0, 0, 0\)"),
        ({"start": Pose("1", 0.0, 0.0)}, "start is a pose"),  # type: ignore[arg-type]
        ({"start": Pose(math.nan, 0.0, 0.0)}, "start must be finite"),
        ({"locations": "home"}, "locations are a dictionary by name, not 'home'"),
        ({"locations": {"kitchen": (1.0, 2.0)}}, "the location 'kitchen' is a pose"),
        ({"objects": ["cup"]}, "objects are a dictionary by name"),
        ({"objects": {"cup": (1.0, 2.0)}}, "where 'cup' is, is the name of a location, a Pose, or None"),
        ({"capabilities": "move"}, r"capabilities are a set, as \{Capability\.MOVE\}, not 'move'"),
        ({"capabilities": Capability.MOVE}, "capabilities are a set"),
        ({"capabilities": ["trun"]}, "a capability is one of 'move', 'turn', 'navigate', 'pick', 'place', not 'trun'"),
        ({"clock": VirtualClock}, "a clock is MonotonicClock"),
        ({"acceleration": -1.0}, "acceleration must not be below zero"),
        ({"acceleration": 0.0}, "acceleration must be above zero"),
        ({"delay": -1.0}, "delay must not be below zero"),
        ({"slip": math.nan}, "slip must be a number, not nan"),
        ({"navigation_speed": 0.0}, "navigation_speed must be above zero"),
        ({"hand_time": "2"}, "hand_time is a number of s, not '2'"),
    ],
)
def test_what_no_simulated_robot_is_made_of(given, says):
    with pytest.raises((TypeError, ValueError), match=says):
        SimulatedRobot(**given)


def test_capabilities_may_be_named_and_places_come_of_a_map():
    places = LocationMap.from_mapping({"kitchen": (1.0, 2.0)})
    robot = SimulatedRobot(capabilities=["move"], locations=places, objects={"cup": "kitchen"})
    assert robot.capabilities == {Capability.MOVE}


class Own:
    """A robot of somebody's own."""

    capabilities = frozenset(Capability)

    def __init__(self, **changes) -> None:
        self.__dict__.update(changes)
        self.stops = 0

    def velocity(self, linear, angular, valid_for): ...
    def stop(self):
        self.stops += 1

    def navigate(self, goal): ...
    def pick(self, object_name): ...
    def place(self, object_name, location): ...
    def cancel(self, task): ...
    def pose(self): ...


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"stop": coroutine}, "stop of a robot is called, and not awaited, but is async"),
        ({"velocity": AsyncCall()}, "velocity of a robot is called, and not awaited, but is async"),
        ({"navigate": functools.partial(coroutine, 1)}, "navigate of a robot is called, and not awaited"),
        (
            {"velocity": lambda linear, angular: None},
            r"called with 3 arguments, and this one takes \(linear, angular\)",
        ),
        ({"stop": lambda how: None}, "stop of a robot is called with 0 arguments"),
        ({"velocity": None}, "velocity of a robot is a method, not None"),
        ({"capabilities": "move"}, "capabilities are a set"),
        ({"capabilities": lambda: {"move"}}, "capabilities are a set"),
        ({"capabilities": {"Move"}}, "a capability is one of"),
        ({"rates": 20}, r"rates of a robot are Rates\(rate=20\.0\), not 20"),
        ({"clock": 5}, "a clock is MonotonicClock"),
    ],
)
def test_what_is_no_robot(changes, says):
    with pytest.raises((TypeError, ValueError), match=says):
        Executor(Own(**changes))


@pytest.mark.parametrize("given", [{"rate": "20"}, {"zeros": 1.5}, {"valid_for": math.nan}, {"rate": None}])
def test_what_are_no_rates(given):
    with pytest.raises((TypeError, ValueError), match=f"{next(iter(given))} (is a|must)"):
        Rates(**given)


def test_a_robot_is_driven_by_one_executor_at_a_time():
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    with Executor(robot, clock=clock), pytest.raises(ValueError, match="another executor drives this robot"):
        Executor(robot, clock=clock)
    with Executor(robot, clock=clock) as executor:
        (goal,) = executor.submit(MOVE)
        assert goal.result().succeeded


@pytest.mark.parametrize("task", [None, True, "task"])
def test_a_task_that_cannot_be_followed_stops_the_robot(task):
    clock, robot = VirtualClock(), Own(navigate=lambda goal: task)
    with Executor(robot, clock=clock) as executor:
        (goal,) = executor.submit(NAVIGATE)
        assert (goal.result().state, goal.reason) == (GoalState.ABORTED, Reason.ROBOT_ERROR)
        assert goal.detail.startswith("navigate() of a robot returns a Task, by which it is followed, not ")
        assert robot.stops


class Task:
    reason, progress = "", None

    def __init__(self, *states: str) -> None:
        self.states = list(states)

    @property
    def state(self) -> str:
        return self.states.pop(0) if len(self.states) > 1 else self.states[0]

    def add_done_callback(self, callback): ...


@pytest.mark.parametrize(
    ("last", "ends"),
    [
        ("succeeded", (GoalState.SUCCEEDED, Reason.NONE)),
        ("failed", (GoalState.ABORTED, Reason.ROBOT_ERROR)),
        ("canceled", (GoalState.CANCELED, Reason.CANCELED)),
        ("arrived", (GoalState.ABORTED, Reason.ROBOT_ERROR)),
    ],
)
def test_a_task_may_name_its_state(last, ends):
    clock, robot = VirtualClock(), Own(navigate=lambda goal: Task("running", "running", last))
    with Executor(robot, clock=clock) as executor:
        (goal,) = executor.submit(NAVIGATE)
        assert not goal.done
        assert (goal.result().state, goal.reason) == ends
        assert bool(robot.stops) is (last == "arrived")
        assert last != "arrived" or "the state of a task is one of 'running'" in goal.detail


@pytest.mark.parametrize("handler", [coroutine, AsyncCall(), generator, functools.partial(coroutine)])
def test_a_handler_that_would_not_be_awaited_is_none(handler):
    with pytest.raises(
        TypeError, match=r"the handler of 'wave' is called, and not awaited, but .*run_coroutine_threads"
    ):
        Executor(SimulatedRobot(), handlers={"wave": handler})
    with pytest.raises(TypeError, match="on_event is called, and not awaited"):
        Executor(SimulatedRobot(), on_event=handler if handler is not generator else coroutine)


@pytest.mark.parametrize("function", [coroutine, generator])
def test_a_handler_that_returns_what_nobody_awaits_has_done_nothing(function):
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock, handlers={"wave": lambda action: function(action)}) as executor:
        (goal,) = executor.submit(Custom("wave"))
        assert (goal.result().state, goal.reason) == (GoalState.ABORTED, Reason.HANDLER_ERROR)
        assert "has to be awaited" in goal.detail


def test_a_handler_that_waits_for_a_coroutine_succeeds():
    clock = VirtualClock()
    handlers = {"wave": lambda action: asyncio.run(coroutine())}
    with Executor(SimulatedRobot(clock), clock=clock, handlers=handlers) as executor:
        (goal,) = executor.submit(Custom("wave"))
        assert goal.result().succeeded


@pytest.mark.parametrize("clock", [VirtualClock, MonotonicClock])
@pytest.mark.parametrize("waits", ["everything", "itself", "what waits its turn"])
def test_a_handler_cannot_wait_for_its_own_end(clock, waits):
    time = clock()
    with Executor(SimulatedRobot(time), clock=time) as executor:

        def wave(action, context):
            if waits == "everything":
                executor.wait()
            behind = executor.submit(Move(0.5, 0.01, 0.02), policy="queue")
            (context.goal if waits == "itself" else behind[0]).result()

        executor.register("wave", wave)
        (goal,) = executor.submit(Custom("wave"))
        assert (goal.result(60.0).state, goal.reason) == (GoalState.ABORTED, Reason.HANDLER_ERROR)
        assert "would wait for its own end" in goal.detail


def test_a_handler_may_wait_for_what_it_submits():
    with Executor(SimulatedRobot()) as executor:
        ends = []

        def wave(action):
            (move,) = executor.submit(Move(0.5, 0.01, 0.02))  # in its own place
            ends.append(move.result(60.0).succeeded)
            executor.wait()
            ends.append(executor.wait(timeout=0.0))

        executor.register("wave", wave)
        executor.submit(Custom("wave"))[0].add_done_callback(lambda goal: ends.append(goal.reason))
        while len(ends) < 3:
            executor.wait(timeout=60.0)
        assert sorted(map(str, ends)) == ["True", "True", "preempted"]


@pytest.mark.parametrize("timeout", ["5", True, math.nan, [1.0]])
def test_a_timeout_is_a_number(timeout):
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        (goal,) = executor.submit(MOVE)
        for wait in (executor.wait, goal.result, executor.settle):
            with pytest.raises((TypeError, ValueError), match="timeout"):
                wait(timeout=timeout)
        assert not executor.wait(timeout=-1.0)  # what is left of a time that has run out
        assert executor.wait(timeout=math.inf)


@pytest.mark.parametrize(
    ("policies", "says"),
    [
        ({"navigat": "queue"}, "policies: there is no action 'navigat'; did you mean 'navigate'"),
        ({"Move": "queue"}, "did you mean 'move'"),
        ({Navigate: "queue"}, "policies are by the name of an action, as 'navigate', not by <class"),
        ({5: "queue"}, "policies are by the name of an action, as 'navigate', not by 5"),
    ],
)
def test_policies_are_of_actions_that_there_are(policies, says):
    with pytest.raises((TypeError, ValueError), match=says):
        Executor(SimulatedRobot(), policies=policies)


def test_policies_are_also_of_actions_of_ones_own():
    clock = VirtualClock()
    policies = {"brew": "queue", "plate": "queue", "custom": "refuse"}
    with Executor(SimulatedRobot(clock), clock=clock, handlers={"plate": print}, policies=policies) as executor:
        assert executor.idle


@pytest.mark.parametrize("keep", [None, 5])
def test_what_is_no_keep(keep):
    with Executor(SimulatedRobot()) as executor, pytest.raises(TypeError, match="keep is 'distance', 'duration'"):
        executor.submit(MOVE, keep=keep)


def test_a_guard_that_would_not_be_awaited_is_none():
    with Executor(SimulatedRobot()) as executor, pytest.raises(TypeError, match="a guard is called, and not awaited"):
        executor.submit(MOVE, guards=[coroutine])


def test_words_of_another_clock_are_not_acted_on():
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        (goal,) = executor.submit(MOVE, spoken_at=1_795_859_555.0)
        assert (goal.state, goal.reason) == (GoalState.REJECTED, Reason.EXPIRED)
        assert "spoken_at is on the executor's clock, as executor.clock.now() is" in goal.detail
        (goal,) = executor.submit(MOVE, spoken_at=clock.now() + 60.0)  # sound is read faster than it was said
        assert not goal.done


def test_a_robot_that_leaves_the_program_ends_its_goal_alone():
    class Leaves(SimulatedRobot):
        leaves_at = 2

        def velocity(self, linear, angular, valid_for):
            if self.writes + 1 == self.leaves_at:  # the first write is in the thread that submits, and its own affair
                raise SystemExit(1)
            super().velocity(linear, angular, valid_for)

    with Executor(robot := Leaves()) as executor:
        (goal,) = executor.submit(Move(0.5, 0.5, 1.0))
        assert (goal.result(60.0).state, goal.reason) == (GoalState.ABORTED, Reason.ROBOT_ERROR)
        assert goal.detail == "SystemExit: 1"
        assert robot.speed() == (0.0, 0.0)
        assert executor.settle(60.0)
        robot.leaves_at = 0
        (goal,) = executor.submit(Move(0.5, 0.01, 0.02))
        assert goal.result(60.0).succeeded


def test_a_goal_is_its_own_executors():
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as one, Executor(SimulatedRobot(clock), clock=clock) as other:
        (goal,) = one.submit(MOVE)
        for call in (other.cancel, other.wait, lambda goal: other.submit(MOVE, amends=goal)):
            with pytest.raises(ValueError, match=r"takes a goal of this executor, and <Goal .* is another's"):
                call(goal)
        assert goal.result().succeeded


def test_limits_are_not_changed_on_the_way():
    with Executor(SimulatedRobot(), Limits(linear_velocity=1.0)) as executor:
        with pytest.raises(AttributeError, match="limits"):
            executor.limits = Limits(linear_velocity=0.1)
        assert executor.limits == Limits(linear_velocity=1.0)
