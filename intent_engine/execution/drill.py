"""The safety promises, tried on this machine with this robot's file: ``intent-engine drill``.

Nothing here drives a real robot. The executor, the guardian process and the timing are the real ones; at the end of
the line stands a recorder instead of a robot, with the limits and rates of the robot file. Processes are really killed
and frozen. What is measured is the time from the event to the zero that the robot would have received.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import random
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from typing import Any

from intent_engine.actions import Action, Move, Turn
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import Goal, GoalState, Reason
from intent_engine.execution.guardian import Guardian
from intent_engine.execution.robots.jsonl import JsonLinesRobot
from intent_engine.execution.robots.robot import Capability
from intent_engine.execution.robots.robot_file import RobotFile
from intent_engine.execution.robots.simulated import SimulatedRobot

__all__ = ["DrillReport", "Trial", "busy", "drill", "loop_killed", "program_lost"]

JSONL_SINK = "intent_engine.execution.robots.jsonl:JsonLinesRobot"


@dataclass(frozen=True, slots=True)
class Trial:
    """One promise and what came of it."""

    name: str
    promise: str
    """In words."""
    limit: float | None
    """s that the promise allows; None where it is not a matter of time"""
    worst: float | None
    """s, the slowest of all runs"""
    median: float | None
    """s"""
    runs: int
    passed: bool
    detail: str = ""


@dataclass(frozen=True, slots=True)
class DrillReport:
    """All trials of one drill."""

    robot: str
    trials: tuple[Trial, ...]
    real_time: bool
    """Whether the system gave the guardian SCHED_FIFO."""
    notes: tuple[str, ...] = ()

    @property
    def passed(self) -> bool:
        return all(trial.passed for trial in self.trials)

    def to_json(self) -> dict[str, Any]:
        """A plain dictionary."""
        return {**asdict(self), "passed": self.passed}


class _Recorder(SimulatedRobot):
    """Takes velocities in and remembers them; its faults are set from outside."""

    def __init__(self) -> None:
        super().__init__()
        self.log: list[tuple[float, float, float]] = []
        self.hang = 0.0
        """s that a write takes"""
        self.broken = False

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        if self.broken and (linear or angular):
            raise OSError("the motor driver does not answer")
        if self.hang and (linear or angular):
            time.sleep(self.hang)
        self.log.append((time.monotonic(), linear, angular))

    def stop(self) -> None:
        self.log.append((time.monotonic(), 0.0, 0.0))


def drill(
    file: RobotFile | None = None, *, quick: bool = False, on_trial: Callable[[Trial], object] | None = None
) -> DrillReport:
    """Try every promise and measure.

    Args:
        file: the robot whose limits and rates are used; None: a robot without limits at 20 Hz.
        quick: fewer runs of each (about a quarter of the time).
        on_trial: called with each result as it comes.
    """
    file = file or RobotFile("unlimited", "")
    runs = 5 if quick else 20
    guardian_runs = 3 if quick else 10
    trials: list[Trial] = []
    real_time = False

    def add(trial: Trial) -> None:
        trials.append(trial)
        if on_trial is not None:
            on_trial(trial)

    with busy(processes=os.cpu_count() or 1, threads=2):
        add(_stop_under_load(file, runs))
        add(_flood(file, 500 if quick else 2000))
        add(program_lost("killed", signal.SIGKILL, file, guardian_runs))
        add(program_lost("frozen", signal.SIGSTOP, file, guardian_runs))
        trial, real_time = loop_killed(file, guardian_runs)
        add(trial)
    add(_robot_raises(file, runs))
    add(_robot_hangs(file, runs))
    add(_late_writes(file, 100 if quick else 400))
    notes = ["the base still needs a command timeout of its own: no program stops a robot whose computer is gone"]
    if not real_time:
        notes.append("no SCHED_FIFO here (root, CAP_SYS_NICE or an rtprio limit would allow it)")
    return DrillReport(file.name, tuple(trials), real_time, tuple(notes))


# -- load ------------------------------------------------------------------------------------------------------------


@contextlib.contextmanager
def busy(processes: int = 0, threads: int = 0) -> Iterator[None]:
    """Keep the machine busy: with processes beside this one, and with Python threads inside it."""
    others = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(processes)]
    done = threading.Event()

    def spin() -> None:
        value = 0
        while not done.is_set():
            for _ in range(10_000):
                value = (value * 31 + 7) % 1_000_003

    own = [threading.Thread(target=spin, daemon=True) for _ in range(threads)]
    for thread in own:
        thread.start()
    try:
        if others:
            time.sleep(0.3)  # until they have started, they load the disk and not the processor
        yield
    finally:
        done.set()
        for process in others:
            process.kill()
            process.wait()
        for thread in own:
            thread.join()


# -- trials in one process ---------------------------------------------------------------------------------------------


def _motion(file: RobotFile, seconds: float = 30.0) -> Action:
    """A long motion that this robot's limits allow."""
    limits = file.limits
    if Capability.MOVE in file.capabilities or Capability.TURN not in file.capabilities:
        speed = min(0.5, limits.linear_velocity)
        duration = min(seconds, limits.duration, limits.distance / speed)
        return Move(speed, speed * duration, duration)
    speed = min(0.5, limits.angular_velocity)
    duration = min(seconds, limits.duration, limits.angle / speed)
    return Turn(speed * duration, speed, duration)


def _make(file: RobotFile) -> tuple[_Recorder, Executor]:
    robot = _Recorder()
    options = file.executor_options() | {"policies": {}}
    return robot, Executor(robot, handle_sigterm=False, **options)


def _until(condition: Callable[[], bool], seconds: float = 10.0) -> bool:
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.001)
    return True


def _drive(robot: _Recorder, executor: Executor, file: RobotFile) -> Goal:
    """Begin a motion and wait until the robot feels it."""
    robot.log.clear()
    (goal,) = executor.submit(_motion(file))
    _until(lambda: any(linear or angular for _, linear, angular in list(robot.log)))
    return goal


def _first_zero(log: list[tuple[float, float, float]], since: float) -> float:
    return next((at - since for at, linear, angular in log if at >= since and not linear and not angular), math.inf)


def _result(
    name: str, promise: str, limit: float | None, times: list[float], faults: list[str], detail: str = ""
) -> Trial:
    ordered = sorted(times)
    worst = ordered[-1] if ordered else None
    if limit is not None and worst is not None and worst > limit:
        faults = [f"the slowest of {len(times)} took {worst * 1000:.1f} ms", *faults]
    median = ordered[len(ordered) // 2] if ordered else None
    return Trial(name, promise, limit, worst, median, len(times), not faults, "; ".join(faults[:3]) or detail)


def _stop_under_load(file: RobotFile, runs: int) -> Trial:
    robot, executor = _make(file)
    times, faults = [], []
    with executor:
        for _ in range(runs):
            goal = _drive(robot, executor, file)
            time.sleep(random.uniform(0.0, 2.0 * file.rates.period))
            begin = time.monotonic()
            executor.stop()
            returned = time.monotonic()
            time.sleep(3.0 * file.rates.period)
            times.append(_first_zero(robot.log, begin))
            if any((linear or angular) and at > returned for at, linear, angular in robot.log):
                faults.append("a velocity was written after stop() had returned")
            if goal.reason is not Reason.STOP:
                faults.append(f"the goal ended as {goal.state.value}")
    promise = "stop() writes zero at once while every core and two threads are busy"
    return _result("stop under load", promise, 0.05, times, faults)


def _flood(file: RobotFile, commands: int) -> Trial:
    robot, executor = _make(file)
    goals: list[Goal] = []
    lock = threading.Lock()

    def shout(count: int) -> None:
        for _ in range(count):
            new = executor.submit([_motion(file), _motion(file, 1.0)])
            with lock:
                goals.extend(new)

    faults = []
    with executor:
        begin = time.monotonic()
        threads = [threading.Thread(target=shout, args=(commands // 4,)) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        each = (time.monotonic() - begin) / commands
        stopped = time.monotonic()
        executor.stop()
        returned = time.monotonic()
        time.sleep(3.0 * file.rates.period)
        if any((linear or angular) and at > returned for at, linear, angular in robot.log):
            faults.append("a velocity was written after stop() had returned")
        left = [goal for goal in goals if not goal.done]
        if left:
            faults.append(f"{len(left)} goals never ended")
        if not executor.idle:
            faults.append("the executor is not idle after stop()")
        time_to_zero = _first_zero(robot.log, stopped)
    promise = f"{commands} commands from 4 threads at once, and then stop() still stops at once"
    return _result("flood", promise, 0.05, [time_to_zero], faults, f"{each * 1e6:.0f} us a command")


def _robot_raises(file: RobotFile, runs: int) -> Trial:
    robot, executor = _make(file)
    times, faults = [], []
    with executor:
        for _ in range(runs):
            goal = _drive(robot, executor, file)
            begin = time.monotonic()
            robot.broken = True
            if not _until(lambda goal=goal: goal.done, 2.0):  # type: ignore[misc]
                faults.append("the goal never ended")
            robot.broken = False
            times.append(_first_zero(robot.log, begin))
            if (goal.state, goal.reason) != (GoalState.ABORTED, Reason.ROBOT_ERROR):
                faults.append(f"the goal ended as {goal.state.value}")
    promise = "a robot that raises is sent zero at its next tick, and the executor lives on"
    return _result("robot raises", promise, file.rates.period + 0.05, times, faults)


def _robot_hangs(file: RobotFile, runs: int) -> Trial:
    robot, executor = _make(file)
    times, faults = [], []
    with executor:
        for _ in range(runs):
            _drive(robot, executor, file)
            robot.hang = 0.2
            time.sleep(file.rates.period * 1.5)
            begin = time.monotonic()
            executor.stop()
            times.append(_first_zero(robot.log, begin))
            robot.hang = 0.0
            time.sleep(0.25)
            last = robot.log[-1]
            if last[1] or last[2]:
                faults.append("the write that hung was the last one")
    promise = "stop() passes a write that hangs, and zero follows that write when it comes through"
    return _result("robot hangs", promise, 0.05, times, faults)


def _late_writes(file: RobotFile, runs: int) -> Trial:
    robot, executor = _make(file)
    faults = []
    chance = random.Random(5)
    with executor:
        for _ in range(runs):
            robot.log.clear()
            racers = [threading.Thread(target=executor.submit, args=([_motion(file)],)) for _ in range(2)]
            for racer in racers:
                racer.start()
            time.sleep(chance.uniform(0.0, 0.004))
            for racer in racers:
                racer.join()
            executor.stop()
            returned = time.monotonic()
            time.sleep(chance.uniform(0.0, 1.5 * file.rates.period))
            late = [entry for entry in robot.log if (entry[1] or entry[2]) and entry[0] > returned]
            if late:
                faults.append(f"a velocity {1000 * (late[0][0] - returned):.2f} ms after stop() had returned")
    trial = _result("late writes", "no velocity but zero is written after stop() has returned", None, [], faults)
    return Trial(trial.name, trial.promise, None, None, None, runs, trial.passed, trial.detail)


# -- trials with processes that are killed -----------------------------------------------------------------------------


class _Wire:
    """A pipe into which robots in other processes write lines, and a thread that reads them."""

    def __init__(self) -> None:
        read, self.write = os.pipe()
        os.set_inheritable(self.write, True)
        self.log: list[tuple[float, float, float]] = []
        self._thread = threading.Thread(target=self._read, args=(read,), daemon=True)
        self._thread.start()

    def _read(self, read: int) -> None:
        with os.fdopen(read) as lines:
            for line in lines:
                message = json.loads(line)
                velocity = message.get("velocity", {"linear": 0.0, "angular": 0.0})
                self.log.append((message["time"], velocity["linear"], velocity["angular"]))

    def moving(self) -> bool:
        return bool(self.log) and bool(self.log[-1][1] or self.log[-1][2])

    def close(self) -> None:
        os.close(self.write)
        self._thread.join(5.0)


def _guarded(file: RobotFile, write: int) -> Executor:
    guardian = Guardian(JSONL_SINK, {"out": write}, limits=file.limits, rates=file.rates, pass_fds=(write,))
    options = file.executor_options() | {"policies": {}}
    return Executor(JsonLinesRobot(write), loop=guardian, **options)


def _parent_main(write: int, motion: list[Any], limits: dict[str, Any], rates: dict[str, Any]) -> None:
    """What the process does that is going to be killed or frozen: drive, and tell the guardian's number."""
    from intent_engine.actions import from_json
    from intent_engine.execution.limits import Limits
    from intent_engine.execution.motion import Rates

    file = RobotFile("drill", "", limits=Limits(**limits), rates=Rates(**rates))
    executor = _guarded(file, write)
    executor.submit([from_json(each) for each in motion])
    print("driving", flush=True)
    time.sleep(600.0)


def program_lost(what: str, number: signal.Signals, file: RobotFile, runs: int) -> Trial:
    """Kill or freeze a program that drives, and time the guardian's zero; ``what`` is ``killed`` or ``frozen``."""
    from intent_engine.actions import to_json

    limits = {name: value for name, value in asdict(file.limits).items() if name not in ("over", "over_each")}
    call = {
        "motion": [to_json(_motion(file))],
        "limits": {name: value for name, value in limits.items() if value is not None and math.isfinite(value)},
        "rates": asdict(file.rates),
    }
    code = f"from intent_engine.execution.drill import _parent_main; _parent_main(WRITE, **{call!r})"
    times, faults = [], []
    for _ in range(runs):
        wire = _Wire()
        process = subprocess.Popen(
            [sys.executable, "-c", code.replace("WRITE", str(wire.write))],
            pass_fds=(wire.write,),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
        )
        try:
            if not _until(wire.moving, 30.0):
                faults.append("the robot never moved")
                continue
            time.sleep(random.uniform(0.2, 0.2 + 2 * file.rates.period))
            begin = time.monotonic()
            process.send_signal(number)
            deadline = file.rates.valid_for + 0.5
            _until(lambda wire=wire, begin=begin: math.isfinite(_first_zero(wire.log, begin)), deadline)  # type: ignore[misc]
            zero = _first_zero(wire.log, begin)
            times.append(zero)
            time.sleep(0.1)
            if any((linear or angular) and at > begin + zero for at, linear, angular in wire.log):
                faults.append("a velocity was written after the zero")
        finally:
            process.kill()
            process.wait()
            if process.stdout is not None:
                process.stdout.close()
            wire.close()
    if what == "killed":
        limit, promise = 0.05, "the program is killed (SIGKILL): the guardian writes zero within 50 ms"
    else:
        limit = file.rates.valid_for + 0.02
        promise = f"the program is frozen (SIGSTOP): the guardian writes zero within {limit * 1000:.0f} ms"
    return _result(f"program {what}", promise, limit, times, faults)


def loop_killed(file: RobotFile, runs: int) -> tuple[Trial, bool]:
    """Kill the guardian and time the program's own stop; also whether the guardian had SCHED_FIFO."""
    wire = _Wire()
    times, faults = [], []
    with _guarded(file, wire.write) as executor:
        guardian: Any = executor.loop
        real_time = bool(guardian.real_time)
        for _ in range(runs):
            wire.log.clear()
            (goal,) = executor.submit(_motion(file))
            _until(wire.moving)
            begin = time.monotonic()
            os.kill(guardian.pid, signal.SIGKILL)
            _until(lambda begin=begin: math.isfinite(_first_zero(wire.log, begin)), 1.0)  # type: ignore[misc]
            times.append(_first_zero(wire.log, begin))
            _until(lambda goal=goal: goal.done, 1.0)  # type: ignore[misc]
            if goal.reason is not Reason.VELOCITY_LOOP:
                faults.append(f"the goal ended as {goal.state.value} ({goal.reason.value})")
            executor.reset()
    wire.close()
    promise = "the guardian is killed: the program stops the robot by its own stop within 100 ms, and says so"
    return _result("guardian killed", promise, 0.1, times, faults), real_time
