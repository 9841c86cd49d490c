"""The executor with its thread: robots that hang or raise, handlers that wait, the end of the process."""

from __future__ import annotations

import itertools
import signal
import subprocess
import sys
import threading
import time

import pytest
from execution_stage import until

from intent_engine.actions import Custom, Move, Navigate
from intent_engine.execution import goal
from intent_engine.execution.events import Dispatcher, Event, EventKind, _Lane
from intent_engine.execution.executor import Executor
from intent_engine.execution.gate import Gate
from intent_engine.execution.goal import GoalState, Reason, Times
from intent_engine.execution.limits import Limits
from intent_engine.execution.robots.robot import Pose, TaskState
from intent_engine.execution.robots.simulated import SimulatedRobot

LONG = Move(0.5, 50.0, 100.0)


class Log(SimulatedRobot):
    """Remembers its writes; can be made to hang or raise in them."""

    def __init__(self) -> None:
        super().__init__()
        self.written: list[float] = []
        self.hanging = threading.Event()
        self.go = threading.Event()
        self.moved = threading.Event()
        self.stop_raises = False

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        if linear and self.hanging.is_set():
            self.moved.set()
            self.go.wait(30.0)
        self.written.append(linear)
        if linear:
            self.moved.set()

    def stop(self) -> None:
        self.written.append(0.0)
        if self.stop_raises:
            raise OSError("the bus is off")


@pytest.fixture
def robot():
    return Log()


@pytest.fixture
def executor(robot):
    with Executor(robot, handle_sigterm=False) as made:
        yield made


def test_stop_does_not_wait_for_a_robot_that_hangs(executor, robot):
    robot.hanging.set()
    done = threading.Event()
    goals: list = []

    def submit() -> None:
        goals.extend(executor.submit(LONG))
        done.set()

    threading.Thread(target=submit, daemon=True).start()
    assert robot.moved.wait(30.0)
    executor._books.LATER = 0.01
    executor.stop()
    assert robot.written == [0.0]
    robot.hanging.clear()
    robot.go.set()
    assert done.wait(30.0)
    assert goals[0].result(30.0).reason is Reason.STOP
    assert robot.written[1:3] == [0.5, 0.0]
    assert 0.5 not in robot.written[2:]
    (after,) = executor.submit(Move(0.5, 0.01, 0.02))
    assert after.result(30.0).succeeded


def test_a_robot_that_raises_in_stop_is_sent_zero(executor, robot, caplog):
    executor.submit(LONG)
    assert robot.moved.wait(30.0)
    robot.stop_raises = True
    executor.stop()
    assert robot.written[-1] == 0.0
    assert executor.idle
    assert "raised in stop()" in caplog.text
    robot.stop_raises = False


@pytest.mark.parametrize("raised", [KeyboardInterrupt, SystemExit])
def test_who_is_broken_off_in_a_write_leaves_a_robot_that_is_stopped(executor, robot, raised):
    """Ctrl-C in the thread that submits, and that has just written the first velocity."""
    velocity = robot.velocity

    def broken_off(linear: float, angular: float, valid_for: float) -> None:
        velocity(linear, angular, valid_for)
        if linear:
            robot.velocity = velocity
            raise raised

    robot.velocity = broken_off
    with pytest.raises(raised):
        executor.submit(LONG)
    assert robot.written[:2] == [0.5, 0.0]
    assert executor.idle
    assert executor.run_until_idle()
    (after,) = executor.submit(Move(0.5, 0.01, 0.02))
    assert after.result(30.0).succeeded


@pytest.mark.parametrize("command", [Move(0.5, 50.0, 100.0), Navigate("kitchen", 5.0, 2.0, 0.0)], ids=["move", "task"])
def test_a_signal_handler_may_stop_while_a_goal_begins(stage, monkeypatch, command):
    s = stage()
    calls = itertools.count()

    def interrupted(*times: float | None) -> Times:
        if next(calls) == 2:  # submitted, accepted, begun
            signal.raise_signal(signal.SIGUSR1)
        return Times(*times)

    before = signal.signal(signal.SIGUSR1, lambda number, frame: s.executor.stop())
    try:
        with monkeypatch.context() as patch:
            patch.setattr(goal, "Times", interrupted)
            (submitted,) = s.executor.submit(command)
    finally:
        signal.signal(signal.SIGUSR1, before)
    assert s.executor.run_until_idle()
    assert s.executor.idle
    assert not any(write.linear for write in s.robot.written)
    assert s.robot.pose() == Pose(0.0, 0.0, 0.0)
    assert (submitted.state, submitted.reason) == (GoalState.CANCELED, Reason.STOP)
    assert submitted.times.ended is not None


def test_a_handler_does_not_block_and_hears_that_it_is_not_wanted(executor):
    began, left = threading.Event(), threading.Event()

    def wait(action, context):
        context.progress = 0.5
        began.set()
        assert context.cancelled.wait(30.0)
        left.set()

    executor.register("wait", wait)
    (goal,) = executor.submit(Custom("wait"))
    assert began.wait(30.0)
    executor.stop()
    assert goal.reason is Reason.STOP
    assert left.wait(30.0)


def test_a_handler_that_takes_too_long_is_given_up(robot):
    over = threading.Event()
    with Executor(
        robot, Limits(task_duration=0.05), handlers={"wait": lambda action: over.wait(30.0)}, handle_sigterm=False
    ) as executor:
        (goal,) = executor.submit(Custom("wait"))
        goal.result(30.0)
        assert (goal.state, goal.reason) == (GoalState.ABORTED, Reason.TIMEOUT)
        over.set()


class Stubborn:
    """A task that does not confirm its cancellation."""

    state = TaskState.RUNNING
    reason = ""
    progress = None

    def add_done_callback(self, callback) -> None:
        pass


def test_a_robot_that_never_confirms_a_cancellation_is_stopped(stage):
    s = stage(Limits(task_duration=5.0))
    s.robot.navigate = lambda goal: Stubborn()
    (goal,) = s.executor.submit(Navigate("kitchen", 5.0, 2.0, 0.0))
    s.executor.wait(goal)
    assert (goal.state, goal.reason, goal.times.ended) == (GoalState.ABORTED, Reason.TIMEOUT, 7.0)
    (first,) = s.executor.submit(Navigate("kitchen", 5.0, 2.0, 0.0))
    (second,) = s.executor.submit(Move(0.5, 1.0, 2.0))
    s.executor.wait(second)
    assert (first.reason, second.state) == (Reason.PREEMPTED, GoalState.SUCCEEDED)


def test_goals_can_be_waited_for_in_many_ways(executor):
    told = threading.Event()
    (goal,) = executor.submit(Move(1.0, 0.02, 0.02))
    goal.add_done_callback(lambda goal: told.set())
    assert goal.future().result(30.0) is goal
    assert told.wait(30.0)
    assert goal.result() is goal
    assert executor.wait(goal, timeout=0.0)
    (long,) = executor.submit(LONG)
    assert not executor.wait(long, timeout=0.01)


def test_many_threads_may_command_at_once(executor, robot):
    goals: list = []

    def shout() -> None:
        for _ in range(50):
            goals.extend(executor.submit([LONG, LONG]))

    threads = [threading.Thread(target=shout) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    executor.stop()
    assert len(goals) == 400
    assert all(goal.done for goal in goals)
    assert sum(goal.reason is Reason.STOP for goal in goals) == 2


def test_the_gate_follows_a_write_that_was_on_its_way_with_a_stop(robot):
    gate = Gate(robot)
    gate.open()
    robot.hanging.set()
    thread = threading.Thread(target=gate.velocity, args=(0.5, 0.0, 0.3))
    thread.start()
    assert robot.moved.wait(30.0)
    gate.shut()
    robot.go.set()
    thread.join(30.0)
    assert robot.written == [0.5, 0.0]
    gate.velocity(0.5, 0.0, 0.3)
    assert robot.written == [0.5, 0.0]


PROGRAM = """
import os, sys, time
from intent_engine.actions import Move
from intent_engine.execution.events import Dispatcher, Event, EventKind, _Lane
from intent_engine.execution.executor import Executor
from intent_engine.execution.robots.jsonl import JsonLinesRobot
executor = Executor(JsonLinesRobot(1))
executor.submit(Move(0.5, 50.0, 100.0))
time.sleep(0.12)
{end}
"""


@pytest.mark.parametrize(
    ("end", "code"),
    [
        ("", 0),
        ("raise SystemExit(3)", 3),
        ("raise KeyError('x')", 1),
        ("os.kill(os.getpid(), 15); time.sleep(60)", -15),
        ("os.kill(os.getpid(), 1); time.sleep(60)", -1),
    ],
    ids=["end", "exit", "error", "SIGTERM", "SIGHUP"],
)
def test_every_way_out_of_the_process_writes_zeros_and_is_silent(end, code):
    done = subprocess.run([sys.executable, "-c", PROGRAM.format(end=end)], capture_output=True, text=True, timeout=60)
    assert done.returncode == code
    lines = done.stdout.splitlines()
    assert '"linear": 0.5' in lines[0]
    assert all("stop" in line or '"linear": 0.0' in line for line in lines[-3:])


def test_a_signal_handler_of_the_programs_own_is_left_alone():
    program = "import signal; signal.signal(15, lambda *_: print('mine', flush=True))\n" + PROGRAM.format(
        end="os.kill(os.getpid(), 15)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert "mine" in done.stdout
    assert done.returncode == 0


def test_closing_leaves_no_thread(robot):
    before = threading.active_count()
    executor = Executor(robot, handle_sigterm=False)
    executor.submit(LONG)
    executor.close()
    end = time.monotonic() + 30.0
    while threading.active_count() > before:
        assert time.monotonic() < end
        time.sleep(0.001)


def test_who_waits_for_the_robot_waits_for_no_listener_unless_asked(robot):
    heard, go = [], threading.Event()

    def slow(event: Event) -> None:
        go.wait(30.0)
        heard.append(event.state)

    with Executor(robot, on_event=slow, handle_sigterm=False) as executor:
        executor.submit(Move(0.5, 0.01, 0.02))
        assert executor.wait(timeout=30.0)
        assert not executor.settle(0.01)
        assert not heard
        threading.Timer(0.01, go.set).start()
        assert executor.settle(30.0)
        assert heard[-1] is GoalState.SUCCEEDED


def test_a_listener_may_wait_for_the_others(robot):
    """Not for itself."""
    settled = []

    with Executor(robot, handle_sigterm=False) as executor:
        executor.subscribe(lambda event: settled.append(executor.settle(30.0)))
        executor.stop()
        assert executor.settle(30.0)
    assert settled[0]


def test_an_interrupted_subscription_is_none(monkeypatch):
    events, heard = Dispatcher(lambda: 0.0, threaded=True), []
    before, begin = threading.active_count(), _Lane.begin

    def interrupted(lane: _Lane) -> None:
        begin(lane)
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(_Lane, "begin", interrupted)
        with pytest.raises(KeyboardInterrupt):
            events.subscribe(heard.append)
    events.tell(EventKind.RESET)
    assert events.settle(30.0)
    assert heard == []
    until(lambda: threading.active_count() == before)
    events.close()
