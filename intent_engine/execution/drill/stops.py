"""Trials within one process: stops under load and in a flood, a robot that raises or hangs, late writes."""

from __future__ import annotations

import random
import threading
import time

from intent_engine.execution.drill.report import Log, Trial, first_zero, result
from intent_engine.execution.drill.stage import long_motion, until
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import Goal, GoalState, Reason
from intent_engine.execution.robots.robot_file import RobotFile
from intent_engine.execution.robots.simulated import SimulatedRobot

__all__ = ["flood", "late_writes", "robot_hangs", "robot_raises", "stop_under_load"]


class _Recorder(SimulatedRobot):
    """Takes velocities in and remembers them; its faults are set from outside."""

    def __init__(self) -> None:
        super().__init__()
        self.log: Log = []
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


def _make(file: RobotFile) -> tuple[_Recorder, Executor]:
    robot = _Recorder()
    options = file.executor_options() | {"policies": {}}
    return robot, Executor(robot, handle_sigterm=False, **options)


def _drive(robot: _Recorder, executor: Executor, file: RobotFile) -> Goal:
    """Begin a motion and wait until the robot feels it."""
    robot.log.clear()
    (goal,) = executor.submit(long_motion(file))
    until(lambda: any(linear or angular for _, linear, angular in list(robot.log)))
    return goal


def _stop(robot: _Recorder, executor: Executor, file: RobotFile, faults: list[str]) -> float:
    """Stop, and time the zero, in s; a velocity that is written after the stop has returned is a fault."""
    begin = time.monotonic()
    executor.stop()
    returned = time.monotonic()
    time.sleep(3.0 * file.rates.period)
    if any((linear or angular) and at > returned for at, linear, angular in robot.log):
        faults.append("a velocity was written after stop() had returned")
    return first_zero(robot.log, begin)


def stop_under_load(file: RobotFile, runs: int) -> Trial:
    """Stop while the robot drives, on a busy machine, and time the zero."""
    robot, executor = _make(file)
    times: list[float] = []
    faults: list[str] = []
    with executor:
        for _ in range(runs):
            goal = _drive(robot, executor, file)
            time.sleep(random.uniform(0.0, 2.0 * file.rates.period))
            times.append(_stop(robot, executor, file, faults))
            if goal.reason is not Reason.STOP:
                faults.append(f"the goal ended as {goal.state.value}")
    promise = "stop() writes zero at once while every core and two threads are busy"
    return result("stop under load", promise, 0.05, times, faults)


def flood(file: RobotFile, commands: int) -> Trial:
    """Submit commands from four threads at once, stop, and time the zero."""
    robot, executor = _make(file)
    goals: list[Goal] = []
    lock = threading.Lock()

    def shout(count: int) -> None:
        for _ in range(count):
            new = executor.submit([long_motion(file), long_motion(file, 1.0)])
            with lock:
                goals.extend(new)

    faults: list[str] = []
    with executor:
        begin = time.monotonic()
        threads = [threading.Thread(target=shout, args=(commands // 4,)) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        each = (time.monotonic() - begin) / commands
        time_to_zero = _stop(robot, executor, file, faults)
        left = [goal for goal in goals if not goal.done]
        if left:
            faults.append(f"{len(left)} goals never ended")
        if not executor.idle:
            faults.append("the executor is not idle after stop()")
    promise = f"{commands} commands from 4 threads at once, and then stop() still stops at once"
    return result("flood", promise, 0.05, [time_to_zero], faults, f"{each * 1e6:.0f} us a command")


def robot_raises(file: RobotFile, runs: int) -> Trial:
    """Let the robot raise while it drives, and time the zero that follows."""
    robot, executor = _make(file)
    times, faults = [], []
    with executor:
        for _ in range(runs):
            goal = _drive(robot, executor, file)
            begin = time.monotonic()
            robot.broken = True
            if not until(lambda goal=goal: goal.done, 2.0):  # type: ignore[misc]
                faults.append("the goal never ended")
            robot.broken = False
            times.append(first_zero(robot.log, begin))
            if (goal.state, goal.reason) != (GoalState.ABORTED, Reason.ROBOT_ERROR):
                faults.append(f"the goal ended as {goal.state.value}")
    promise = "a robot that raises is sent zero at its next tick, and the executor lives on"
    return result("robot raises", promise, file.rates.period + 0.05, times, faults)


def robot_hangs(file: RobotFile, runs: int) -> Trial:
    """Stop while a write hangs in the robot, and time the zero."""
    robot, executor = _make(file)
    times, faults = [], []
    with executor:
        for _ in range(runs):
            _drive(robot, executor, file)
            robot.hang = 0.2
            time.sleep(file.rates.period * 1.5)
            begin = time.monotonic()
            executor.stop()
            times.append(first_zero(robot.log, begin))
            robot.hang = 0.0
            time.sleep(0.25)
            last = robot.log[-1]
            if last[1] or last[2]:
                faults.append("the write that hung was the last one")
    promise = "stop() passes a write that hangs, and zero follows that write when it comes through"
    return result("robot hangs", promise, 0.05, times, faults)


def late_writes(file: RobotFile, runs: int) -> Trial:
    """Stop as two threads submit, and look for velocities that are written after it has returned."""
    robot, executor = _make(file)
    faults = []
    chance = random.Random(5)
    with executor:
        for _ in range(runs):
            robot.log.clear()
            racers = [threading.Thread(target=executor.submit, args=([long_motion(file)],)) for _ in range(2)]
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
    trial = result("late writes", "no velocity but zero is written after stop() has returned", None, [], faults)
    return Trial(trial.name, trial.promise, None, None, None, runs, trial.passed, trial.detail)
