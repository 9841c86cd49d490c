"""What goes wrong around the executor: robots that cannot begin or stop, handlers and listeners that exit or hang."""

from __future__ import annotations

import asyncio
import math
import os
import subprocess
import sys
import threading
from types import SimpleNamespace

import pytest

from intent_engine.actions import Custom, Move, Navigate, Place, Stop
from intent_engine.errors import RobotError
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.events import EventKind
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Motion, Travel
from intent_engine.execution.robots.robot import Capability, TaskState
from intent_engine.execution.robots.simulated import SimulatedRobot
from intent_engine.execution.runs import TaskRun
from intent_engine.testing import RecordingRobot

FORWARD = Move(0.5, 1.0, 2.0)
KITCHEN = Navigate("kitchen", 5.0, 2.0, 0.0)


def fail(*_) -> None:
    raise OSError("the bus is off")


def test_a_task_that_cannot_begin_ends_its_goal_and_the_next_one_is_done(stage):
    s = stage()
    s.robot.navigate = fail
    goals = s.executor.submit([KITCHEN, FORWARD])
    s.executor.run_until_idle()
    assert (goals[0].state, goals[0].reason) == (GoalState.ABORTED, Reason.ROBOT_ERROR)
    assert "the bus is off" in goals[0].detail
    assert goals[1].state is GoalState.CANCELED
    assert s.executor.submit(FORWARD)[0].result().succeeded


def test_a_robot_whose_stop_fails_has_its_task_cancelled_by_name(stage):
    s = stage()
    (goal,) = s.executor.submit(KITCHEN)
    s.clock.advance(2.0)
    s.robot.stop = fail
    s.executor.stop()
    where = s.robot.pose()
    s.clock.advance(3.0)
    assert goal.reason is Reason.STOP
    assert s.robot.pose() == where


@pytest.mark.parametrize("robot", [None, 5, object()], ids=["None", "5", "object"])
def test_what_is_no_robot_is_named_with_what_it_lacks(robot):
    with pytest.raises(TypeError, match=r"is none: it has no capabilities, velocity, stop, pose$"):
        Executor(robot)


def test_a_class_is_no_robot():
    with pytest.raises(TypeError, match="not the class SimulatedRobot: pass an instance"):
        Executor(SimulatedRobot)


def test_a_robot_needs_the_methods_of_what_it_can_do():
    class Base:
        capabilities = frozenset({Capability.MOVE})

        def velocity(self, linear: float, angular: float, valid_for: float) -> None: ...

        def stop(self) -> None: ...

        def pose(self) -> None: ...

    class Guide(Base):
        capabilities = frozenset({Capability.MOVE, Capability.NAVIGATE})

    Executor(Base(), clock=VirtualClock(), handle_sigterm=False).close()
    with pytest.raises(TypeError, match=r"it has no navigate, cancel$"):
        Executor(Guide())


class BrokenLoop:
    """A velocity loop that fails whenever it is asked; at last it gives up, so that a broken test ends."""

    moving = False
    written = (0.0, 0.0)

    def __init__(self) -> None:
        self.asked = 0

    def start(self, motion: Motion, now: float) -> float:
        return now + motion.duration

    def brake(self, now: float) -> Travel:
        return Travel()

    def halt(self, now: float, write: bool = True) -> Travel:
        return Travel()

    def silence(self) -> None: ...

    def travel(self, now: float) -> Travel:
        return Travel()

    def due(self) -> float | None:
        return 0.0 if self.asked < 1000 else None

    def step(self, now: float) -> None:
        self.asked += 1
        if self.asked < 1000:
            raise RobotError("the robot is gone")


def test_a_loop_that_fails_and_fails_is_asked_no_more():
    told: list = []
    loop = BrokenLoop()
    with Executor(SimulatedRobot(), loop=loop, on_event=told.append, handle_sigterm=False) as executor:
        (goal,) = executor.submit(FORWARD)
        assert goal.result(30.0).reason is Reason.ROBOT_ERROR
        executor.stop()
    assert loop.asked <= 4  # twice before there was a goal, and twice after it
    assert len([event for event in told if event.kind is EventKind.ERROR]) <= 1


def test_a_robot_that_raises_is_stopped_at_that_very_time(stage):
    s = stage()
    (goal,) = s.executor.submit(FORWARD)
    s.clock.advance(0.5)
    stops: list[float] = []
    stop = s.robot.stop
    s.robot.stop = lambda: (stops.append(s.clock.now()), stop())
    s.robot.velocity = fail
    s.clock.advance(0.05)
    assert stops == [goal.times.ended]
    assert s.robot.speed() == (0.0, 0.0)


def test_a_spoken_stop_stops_at_once(stage):
    s = stage()
    (goal,) = s.executor.submit(FORWARD)
    s.clock.advance(0.5)
    (stop,) = s.executor.submit(Stop())
    assert s.robot.speed() == (0.0, 0.0)
    assert (goal.reason, stop.state) == (Reason.STOP, GoalState.SUCCEEDED)


@pytest.mark.parametrize("wrong", [{"spoken_at": math.nan}, {"keep": "both"}, {"keep": ["distance"] * 3}])
def test_a_stop_stops_whatever_else_is_wrong(stage, wrong):
    s = stage()
    s.executor.submit(FORWARD)
    s.clock.advance(0.5)
    with pytest.raises(ValueError, match=r"keep|spoken_at|Keep"):
        s.executor.submit([Stop(), FORWARD], **wrong)
    assert s.executor.idle
    assert s.robot.speed() == (0.0, 0.0)


def test_what_comes_in_a_pause_waits_for_the_end_of_it(stage):
    s = stage()
    s.executor.pause()
    (goal,) = s.executor.submit(FORWARD)
    s.clock.advance(5.0)
    assert (goal.state, s.robot.speed()) == (GoalState.ACCEPTED, (0.0, 0.0))
    s.executor.resume()
    assert goal.result().succeeded


def test_a_task_that_takes_too_long_is_cancelled_by_name(stage):
    s = stage(Limits(task_duration=5.0))
    cancelled: list = []
    cancel = s.robot.cancel
    s.robot.cancel = lambda task: (cancelled.append(s.clock.now()), cancel(task))
    task = s.executor.submit(Navigate("far", 100.0, 0.0, 0.0))[0]
    s.executor.wait(task)
    assert (task.state, task.reason) == (GoalState.ABORTED, Reason.TIMEOUT)
    assert cancelled == [5.0]
    assert s.robot.speed() == (0.0, 0.0)


@pytest.mark.parametrize("command", ["stop", "hold", "estop"])
def test_the_gate_is_shut_before_anything_is_waited_for(command):
    """The robot's own stop, which comes past a lock that hangs, must be the last word."""
    through: list[bool] = []

    class Curious(SimulatedRobot):
        def stop(self) -> None:
            through.append(executor._books._gate._opened == executor._books._gate._generation)

    executor = Executor(Curious(), handle_sigterm=False)
    with executor:
        executor.submit(Move(0.5, 50.0, 100.0))
        with executor._books.lock:
            thread = threading.Thread(target=getattr(executor, command), daemon=True)
            thread.start()
            for _ in range(3000):
                if through:
                    break
                thread.join(0.01)
        thread.join(30.0)
    assert through[0] is False


def hanging(executor: Executor) -> tuple[threading.Thread, threading.Event, threading.Event]:
    """A thread that holds the lock of an executor up when it is started: it tells when it has it, and is told when to
    let go."""
    taken, go = threading.Event(), threading.Event()

    def hang() -> None:
        with executor._books.lock:
            taken.set()
            go.wait(30.0)

    return threading.Thread(target=hang), taken, go


def test_a_hold_outlives_a_stop_that_came_before_it_and_could_not_be_entered(stage):
    s = stage()
    s.executor._books.LATER = 0.01
    thread, taken, go = hanging(s.executor)
    thread.start()
    assert taken.wait(30.0)
    s.executor.stop()
    go.set()
    thread.join(30.0)
    s.executor.hold()
    (goal,) = s.executor.submit(FORWARD)
    s.clock.advance(1.0)
    assert (goal.state, s.robot.speed(), s.executor.snapshot().held) == (GoalState.ACCEPTED, (0.0, 0.0), True)
    assert [event.kind for event in s.events if event.kind is not EventKind.GOAL] == [EventKind.STOP, EventKind.HOLD]
    s.executor.release()
    assert goal.result().succeeded


def test_closing_ends_the_goals_of_a_robot_that_hangs_longer_than_a_stop_waits(stage):
    s = stage()
    s.executor._books.LATER = 0.01
    (goal,) = s.executor.submit(FORWARD)
    thread, taken, go = hanging(s.executor)
    shut, later = s.executor._books._gate.shut, s.executor._books.poke

    def shut_and_hang() -> None:
        shut()
        s.executor._books._gate.shut = shut
        thread.start()
        assert taken.wait(30.0)

    s.executor._books._gate.shut = shut_and_hang
    s.executor._books.poke = lambda: (go.set(), later())
    s.executor.close()
    thread.join(30.0)
    assert (goal.state, goal.reason) == (GoalState.CANCELED, Reason.CLOSED)


def test_a_handler_that_exits_ends_its_goal_alone():
    with Executor(SimulatedRobot(), handlers={"exit": lambda action: sys.exit(3)}, handle_sigterm=False) as executor:
        (goal,) = executor.submit(Custom("exit"))
        assert executor.wait(goal, 30.0)
        assert (goal.state, goal.reason) == (GoalState.ABORTED, Reason.HANDLER_ERROR)
        assert executor.submit(Move(0.5, 0.05, 0.1))[0].result(30.0).succeeded


def test_a_handler_may_stop_the_executor():
    with Executor(SimulatedRobot(), handle_sigterm=False) as executor:
        executor.register("halt", lambda action: executor.stop())
        (goal,) = executor.submit(Custom("halt"))
        assert executor.wait(goal, 30.0)
        assert goal.reason is Reason.STOP


def test_listeners_that_hang_or_exit_hold_up_no_result_and_no_other_listener(caplog):
    go, heard = threading.Event(), threading.Event()
    with Executor(SimulatedRobot(), on_event=lambda event: go.wait(30.0), handle_sigterm=False) as executor:
        executor.subscribe(lambda event: sys.exit(1))
        executor.subscribe(lambda event: heard.set() if event.state is GoalState.SUCCEEDED else None)
        (goal,) = executor.submit(Move(0.5, 0.05, 0.1))
        assert goal.future().result(30.0) is goal
        assert heard.wait(30.0)
        go.set()
    assert "a listener raised" in caplog.text


def test_one_who_gives_up_waiting_takes_nothing_from_the_others():
    async def wait(executor: Executor) -> None:
        (goal,) = executor.submit(Move(0.5, 50.0, 100.0))
        with pytest.raises(asyncio.TimeoutError):
            await asyncio.wait_for(goal, 0.01)
        given_up = asyncio.ensure_future(asyncio.wait_for(goal, 30.0))
        await asyncio.sleep(0.01)
        given_up.cancel()
        with pytest.raises(asyncio.CancelledError):
            await given_up
        assert not goal.done
        executor.stop()
        assert (await goal).reason is Reason.STOP

    with Executor(SimulatedRobot(), handle_sigterm=False) as executor:
        asyncio.run(wait(executor))


FORKING = """
import os, sys, time
from intent_engine.actions import Move
from intent_engine.execution.executor import Executor
from intent_engine.execution.robots.jsonl import JsonLinesRobot
executor = Executor(JsonLinesRobot(1))
(goal,) = executor.submit(Move(0.5, 0.1, 0.2))
if os.fork() == 0:
    (mine,) = executor.submit(Move(0.25, 0.1, 0.4))
    print(mine.result(30).reason, file=sys.stderr)
    sys.exit(0)
os.wait()
print(goal.result(30).state, file=sys.stderr)
"""


def test_a_forked_child_drives_nothing_and_its_end_stops_nothing():
    if not hasattr(os, "fork"):  # Windows: there is no such child, and the executor asks to be told of none
        assert not hasattr(os, "register_at_fork")
        return
    # Python 3.12 and later warn of any fork beside threads.
    command = [sys.executable, "-W", "ignore", "-c", FORKING]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.stderr.splitlines()[-2:] == ["closed", "succeeded"]
    assert '"linear": 0.25' not in done.stdout
    lines = done.stdout.splitlines()
    driven = max(index for index, line in enumerate(lines) if '"linear": 0.5' in line)
    assert not [line for line in lines[:driven] if "stop" in line]


def test_a_close_that_was_interrupted_is_made_good_at_the_end_of_the_process():
    program = """
from intent_engine.actions import Move
from intent_engine.execution.executor import Executor
from intent_engine.execution.robots.jsonl import JsonLinesRobot
executor = Executor(JsonLinesRobot(1))
executor.submit(Move(0.5, 50.0, 100.0))
def interrupted(*_): raise KeyboardInterrupt
executor._stop = interrupted
try:
    executor.close()
except KeyboardInterrupt:
    pass
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert '"linear": 0.5' in done.stdout
    assert "stop" in done.stdout.splitlines()[-1]


def test_a_simulated_task_tells_its_end_to_who_asks_late(stage):
    s = stage()
    task = s.robot.navigate(s.robot.pose())
    s.clock.advance(0.1)
    told: list = []
    task.add_done_callback(told.append)
    assert (told, task.state) == ([task], TaskState.SUCCEEDED)


def test_a_task_that_tells_nothing_of_itself_is_logged_once(stage, caplog):
    class Mute:
        state, reason = TaskState.RUNNING, ""
        progress = property(fail)

        def add_done_callback(self, callback):
            pass

    s = stage()
    s.robot.navigate = lambda goal: Mute()
    s.executor.submit(KITCHEN)
    s.clock.advance(1.0)
    assert len([record for record in caplog.records if "no feedback of goal" in record.getMessage()]) == 1


@pytest.mark.parametrize(
    ("said", "told"),
    [(math.nan, None), (math.inf, None), ("half", None), (True, None), (-1, 0.0), (50, 1.0), (0.5, 0.5)],
)
def test_progress_is_0_to_1_or_not_known(stage, said, told):
    s = stage()
    task = SimpleNamespace(state="running", reason="", progress=said, add_done_callback=lambda callback: None)
    s.robot.navigate = lambda goal: task
    (goal,) = s.executor.submit(KITCHEN)
    s.clock.advance(0.5)
    assert goal.feedback.progress == told


@pytest.mark.parametrize("rest", ["hold", "pause"])
def test_a_task_that_took_too_long_is_not_given_again_after_a_rest(stage, rest):
    s = stage(Limits(task_duration=5.0))
    s.robot.cancel = lambda task: None  # it confirms no cancellation
    (goal,) = s.executor.submit(KITCHEN)
    s.clock.advance(5.5)
    getattr(s.executor, rest)()
    s.clock.advance(0.5)
    s.executor.release() if rest == "hold" else s.executor.resume()
    s.executor.run_until_idle()
    assert (goal.state, goal.reason) == (GoalState.ABORTED, Reason.TIMEOUT)
    assert goal.times.ended <= 5.0 + TaskRun.CANCEL_TIMEOUT


@pytest.mark.parametrize("rest", ["hold", "pause"])
def test_a_task_that_is_done_as_a_rest_begins_is_not_done_again(rest):
    """The robot has told of its end, and the executor has not looked yet."""
    clock = VirtualClock()
    robot = RecordingRobot(clock, finish_tasks=False)
    with Executor(robot, clock=clock, handle_sigterm=False) as executor:
        (goal,) = executor.submit(Place("cup", "table"))
        robot.tasks[-1].succeed()
        getattr(executor, rest)()
        executor.release() if rest == "hold" else executor.resume()
        executor.run_until_idle()
        assert goal.succeeded, goal
        assert robot.names.count("place") == 1
