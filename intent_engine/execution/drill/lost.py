"""Trials with processes that are really killed and frozen: the program, and the guardian."""

from __future__ import annotations

import json
import math
import os
import random
import signal
import subprocess
import sys
import threading
import time
from dataclasses import asdict
from typing import Any

from intent_engine.actions import from_json, to_json
from intent_engine.execution.drill.load import deaf_to_ctrl_c
from intent_engine.execution.drill.report import Log, Trial, first_zero, result
from intent_engine.execution.drill.stage import long_motion, until
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import Reason
from intent_engine.execution.guardian import Guardian
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Rates
from intent_engine.execution.robots.jsonl import JSONL_SINK, JsonLinesRobot
from intent_engine.execution.robots.robot_file import RobotFile

__all__ = ["drive_until_killed", "loop_killed", "program_lost"]


class _Wire:
    """A pipe into which robots in other processes write lines, and a thread that reads them."""

    def __init__(self) -> None:
        read, self.write = os.pipe()
        os.set_inheritable(self.write, True)
        self.log: Log = []
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


def drive_until_killed(write: int, motion: list[Any], limits: dict[str, Any], rates: dict[str, Any]) -> None:
    """What the process does that is going to be killed or frozen: drive."""
    file = RobotFile("drill", "", limits=Limits(**limits), rates=Rates(**rates))
    executor = _guarded(file, write)
    executor.submit([from_json(each) for each in motion])
    time.sleep(600.0)


def program_lost(what: str, number: signal.Signals, file: RobotFile, runs: int) -> Trial:
    """Kill or freeze a program that drives, and time the guardian's zero; ``what`` is ``killed`` or ``frozen``."""
    limits = {name: value for name, value in asdict(file.limits).items() if name not in ("over", "over_each")}
    call = {
        "motion": [to_json(long_motion(file))],
        "limits": {name: value for name, value in limits.items() if value is not None and math.isfinite(value)},
        "rates": asdict(file.rates),
    }
    code = f"from intent_engine.execution.drill.lost import drive_until_killed; drive_until_killed(WRITE, **{call!r})"
    times, faults = [], []
    for _ in range(runs):
        wire = _Wire()
        with deaf_to_ctrl_c():
            process = subprocess.Popen(
                [sys.executable, "-c", code.replace("WRITE", str(wire.write))],
                pass_fds=(wire.write,),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
            )
        try:
            if not until(wire.moving, 30.0):
                faults.append("the robot never moved")
                continue
            time.sleep(random.uniform(0.2, 0.2 + 2 * file.rates.period))
            begin = time.monotonic()
            process.send_signal(number)
            deadline = file.rates.valid_for + 0.5
            until(lambda wire=wire, begin=begin: math.isfinite(first_zero(wire.log, begin)), deadline)  # type: ignore[misc]
            zero = first_zero(wire.log, begin)
            times.append(zero)
            time.sleep(0.1)
            if any((linear or angular) and at > begin + zero for at, linear, angular in wire.log):
                faults.append("a velocity was written after the zero")
        finally:
            process.kill()
            process.wait()
            wire.close()
    if what == "killed":
        limit, promise = 0.05, "the program is killed (SIGKILL): the guardian writes zero within 50 ms"
    else:
        limit = file.rates.valid_for + 0.02
        promise = f"the program is frozen (SIGSTOP): the guardian writes zero within {limit * 1000:.0f} ms"
    return result(f"program {what}", promise, limit, times, faults)


def loop_killed(file: RobotFile, runs: int) -> tuple[Trial, bool]:
    """Kill the guardian and time the program's own stop; also whether the guardian had SCHED_FIFO."""
    wire = _Wire()
    times, faults = [], []
    with _guarded(file, wire.write) as executor:
        guardian: Any = executor.loop
        real_time = bool(guardian.real_time)
        for _ in range(runs):
            wire.log.clear()
            (goal,) = executor.submit(long_motion(file))
            until(wire.moving)
            begin = time.monotonic()
            os.kill(guardian.pid, signal.SIGKILL)
            until(lambda begin=begin: math.isfinite(first_zero(wire.log, begin)), 1.0)  # type: ignore[misc]
            times.append(first_zero(wire.log, begin))
            until(lambda goal=goal: goal.done, 1.0)  # type: ignore[misc]
            if goal.reason is not Reason.VELOCITY_LOOP:
                faults.append(f"the goal ended as {goal.state.value} ({goal.reason.value})")
            executor.reset()
    wire.close()
    promise = "the guardian is killed: the program stops the robot by its own stop within 100 ms, and says so"
    return result("guardian killed", promise, 0.1, times, faults), real_time
