"""Execution: is an action as long as it was asked to be, and how long does a stop take?

Idle, and with every core busy, and with busy Python threads in the program too; beside a chain of sleeps (what the
tutorials write) and beside ``asyncio.sleep``, at the same time in the same run.
"""

from __future__ import annotations

import asyncio
import json
import logging
import math
import os
import random
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

from intent_engine.actions import Move
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.drill import Trial, busy, loop_killed, program_lost
from intent_engine.execution.drill.lost import JSONL_SINK
from intent_engine.execution.executor import Executor
from intent_engine.execution.guardian import Guardian
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Rates
from intent_engine.execution.robots.jsonl import JsonLinesRobot
from intent_engine.execution.robots.robot_file import RobotFile
from intent_engine.execution.robots.simulated import SimulatedRobot

RATE = 20.0
ACTION = Move(0.5, 1.0, 2.0)
LOADS: dict[str, tuple[int, int]] = {
    "idle": (0, 0),
    "every core busy": (os.cpu_count() or 1, 0),
    "every core and 2 own threads busy": (os.cpu_count() or 1, 2),
}
Writes = list[tuple[float, float]]


def run(quick: bool) -> Iterator[list[dict[str, Any]]]:
    """The rows of this benchmark."""
    logging.getLogger("intent_engine.execution").setLevel(logging.CRITICAL)  # what is killed on purpose is no news
    for load, (processes, threads) in LOADS.items():
        with busy(processes, threads):
            rows = [*timing(load, 2 if quick else 12), *stopping(load, 50 if quick else 200)]
        yield rows
    file = RobotFile("benchmark", "")
    for load in ("idle", "every core and 2 own threads busy"):
        with busy(*LOADS[load]):
            rows = [
                trial_row(load, program_lost("killed", signal.SIGKILL, file, 3 if quick else 15)),
                trial_row(load, program_lost("frozen", signal.SIGSTOP, file, 3 if quick else 8)),
                trial_row(load, loop_killed(file, 3 if quick else 10)[0]),
            ]
        yield rows
    yield [virtual(2_000 if quick else 100_000)]
    yield [interleavings(quick)]


# -- action times --------------------------------------------------------------------------------------------------


class Recorder(SimulatedRobot):
    """A simulated robot that notes when it was written to."""

    def __init__(self) -> None:
        super().__init__()
        self.log: Writes = []

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        super().velocity(linear, angular, valid_for)
        self.log.append((time.monotonic(), linear))

    def stop(self) -> None:
        super().stop()
        self.log.append((time.monotonic(), 0.0))


def timing(load: str, rounds: int) -> list[dict[str, Any]]:
    """2 s actions by four ways, all at the same time, ``rounds`` times."""
    ways: dict[str, Callable[[], tuple[Writes, float | None]]] = {}
    own = Recorder()
    executor = Executor(own, rates=Rates(rate=RATE), handle_sigterm=False)

    def in_process() -> tuple[Writes, float | None]:
        own.log.clear()
        before = own.pose().x
        executor.submit(ACTION)[0].result()
        time.sleep(0.01)
        return list(own.log), own.pose().x - before

    read, write = os.pipe()
    os.set_inheritable(write, True)
    wire: Writes = []

    def listen() -> None:
        with os.fdopen(read) as lines:
            for line in lines:
                message = json.loads(line)
                wire.append((message["time"], message.get("velocity", {"linear": 0.0})["linear"]))

    threading.Thread(target=listen, daemon=True).start()
    guardian = Guardian(JSONL_SINK, {"out": write}, rates=Rates(rate=RATE), pass_fds=(write,))
    guarded = Executor(JsonLinesRobot(write), loop=guardian, rates=Rates(rate=RATE), handle_sigterm=False)

    def in_guardian() -> tuple[Writes, float | None]:
        wire.clear()
        guarded.submit(ACTION)[0].result()
        time.sleep(0.01)
        writes = list(wire)
        covered = sum(v * (later - at) for (at, v), (later, _) in pairwise(writes))
        return writes, covered

    def chain() -> tuple[Writes, float | None]:
        robot = Recorder()
        for _ in range(round(ACTION.duration * RATE)):
            robot.velocity(ACTION.linear_velocity, 0.0, 10.0)
            time.sleep(1.0 / RATE)
        robot.velocity(0.0, 0.0, 10.0)
        return robot.log, robot.pose().x

    def with_asyncio() -> tuple[Writes, float | None]:
        robot = Recorder()

        async def drive() -> None:
            for _ in range(round(ACTION.duration * RATE)):
                robot.velocity(ACTION.linear_velocity, 0.0, 10.0)
                await asyncio.sleep(1.0 / RATE)
            robot.velocity(0.0, 0.0, 10.0)

        asyncio.run(drive())
        return robot.log, robot.pose().x

    ways = {"guardian": in_guardian, "in process": in_process, "sleep chain": chain, "asyncio.sleep": with_asyncio}
    ends: dict[str, list[float]] = {way: [] for way in ways}
    gaps: dict[str, list[float]] = {way: [] for way in ways}
    metres: dict[str, list[float]] = {way: [] for way in ways}

    def one(way: str) -> None:
        writes, covered = ways[way]()
        first = next(at for at, linear in writes if linear)
        zero = next(at for at, linear in writes if not linear and at > first)
        ends[way].append(abs(zero - first - ACTION.duration))
        moving = [at for at, linear in writes if linear]
        gaps[way] += [abs(b - a - 1.0 / RATE) for a, b in pairwise(moving)]
        if covered is not None:
            metres[way].append(abs(covered - ACTION.distance))

    for _ in range(rounds):
        threads = [threading.Thread(target=one, args=(way,)) for way in ways]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    executor.close()
    guarded.close()
    os.close(write)
    rows = []
    for way in ("guardian", "in process"):
        for share, name, peer in (
            (0.5, "p50", "sleep chain"),
            (0.99, "p99", "sleep chain"),
            (0.99, "p99", "asyncio.sleep"),
            (1.0, "max", "sleep chain"),
        ):
            figure = f"end error of a 2 s action, {way}, {load}, {name}"
            rows.append(_row(figure, ends[way], share, 1000.0, "ms", peer, ends[peer]))
        for share, name in ((0.5, "p50"), (0.99, "p99")):
            figure = f"distance error of 1 m, {way}, {load}, {name}"
            rows.append(_row(figure, metres[way], share, 1000.0, "mm", "sleep chain", metres["sleep chain"]))
        figure = f"jitter between two writes at 20 Hz, {way}, {load}, p99"
        rows.append(_row(figure, gaps[way], 0.99, 1000.0, "ms", "sleep chain", gaps["sleep chain"]))
    return rows


# -- stop ----------------------------------------------------------------------------------------------------------


def stopping(load: str, runs: int) -> list[dict[str, Any]]:
    """From the call of stop() to the zero; beside a flag that a 20 Hz loop looks at."""
    robot = Recorder()
    chance = random.Random(3)
    times, flags = [], []
    with Executor(robot, rates=Rates(rate=100.0), handle_sigterm=False) as executor:
        for _ in range(runs):
            robot.log.clear()
            executor.submit(Move(0.5, 50.0, 100.0))
            while not robot.log:
                time.sleep(0.001)
            time.sleep(chance.uniform(0.0, 0.02))
            begin = time.monotonic()
            executor.stop()
            # A zero of the stop before may come late.
            times.append(next(at for at, linear in robot.log if not linear and at >= begin) - begin)
    for _ in range(max(runs // 5, 10)):
        flags.append(_polled_flag(chance.uniform(0.05, 0.15)))
    rows = []
    for share, name in ((0.5, "p50"), (0.99, "p99"), (1.0, "max")):
        rows.append(
            _row(f"stop() to zero, {load}, {name}", times, share, 1000.0, "ms", "a flag polled at 20 Hz", flags)
        )
    return rows


def _polled_flag(after: float) -> float:
    """What the usual loop does: drive until somebody sets a flag."""
    flag, zero = threading.Event(), []

    def loop() -> None:
        while not flag.is_set():
            time.sleep(1.0 / RATE)
        zero.append(time.monotonic())

    thread = threading.Thread(target=loop)
    thread.start()
    time.sleep(after)
    begin = time.monotonic()
    flag.set()
    thread.join()
    return zero[0] - begin


# -- promises --------------------------------------------------------------------------------------------------------


def trial_row(load: str, trial: Trial) -> dict[str, Any]:
    """A trial of the drill as a row; nobody else has one to compare with."""
    if not trial.passed or trial.worst is None or trial.median is None:
        raise AssertionError(f"{trial.name}, {load}: {trial.detail}")
    return {
        "figure": f"{trial.name}: to zero velocity, {load}, worst",
        "value": 1000.0 * trial.worst,
        "unit": "ms",
        "peer": None,
        "peer_value": None,
        "ratio": None,
        "spread": [1000.0 * trial.median, 1000.0 * trial.worst],
        "runs": trial.runs,
        "command": _COMMAND,
    }


def virtual(actions: int) -> dict[str, Any]:
    """The largest end error of many actions on the virtual clock."""
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    chance = random.Random(1)
    worst = 0.0
    with Executor(robot, Limits(), rates=Rates(rate=RATE), handle_sigterm=False) as executor:
        for _ in range(actions):
            duration = chance.uniform(0.01, 0.5)
            begin = clock.now()
            (goal,) = executor.submit(Move(0.5, 0.5 * duration, duration))
            executor.wait(goal)
            assert goal.times.ended is not None
            worst = max(worst, abs(goal.times.ended - (begin + duration)))
            robot.trace.clear()
    return {
        "figure": f"end error on the virtual clock over {actions:,} actions, max",
        "value": 1000.0 * worst,
        "unit": "ms",
        "peer": None,
        "peer_value": None,
        "ratio": None,
        "spread": None,
        "runs": actions,
        "command": _COMMAND,
    }


def interleavings(quick: bool) -> dict[str, Any]:
    """Non-zero writes after a stop, with threads that hold, release, pause and move time: the test that counts them."""
    tests = Path(__file__).resolve().parent.parent / "tests" / "execution" / "test_interleavings.py"
    which = "whoever_else_is_at_it" if quick else "100_000"
    python = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider"]
    command = [*python, "-m", "slow or not slow", str(tests), "-k", which]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return {
        "figure": "velocities other than zero after stop(), in random interleavings of threads",
        "value": 0,
        "unit": "",
        "peer": None,
        "peer_value": None,
        "ratio": None,
        "spread": None,
        "runs": 2_000 if quick else 100_000,
        "command": "python -m pytest -m slow tests/execution/test_interleavings.py",
    }


_COMMAND = "python -m benchmarks --only execution"


def _at(values: list[float], share: float) -> float:
    ordered = sorted(values)
    return ordered[min(math.ceil(share * len(ordered)) - 1, len(ordered) - 1)]


def _row(
    figure: str, values: list[float], share: float, scale: float, unit: str, peer: str, peer_values: list[float]
) -> dict[str, Any]:
    value, peer_value = _at(values, share) * scale, _at(peer_values, share) * scale
    return {
        "figure": figure,
        "value": value,
        "unit": unit,
        "peer": peer,
        "peer_value": peer_value,
        "ratio": peer_value / value if value else None,
        "spread": [min(values) * scale, max(values) * scale],
        "runs": len(values),
        "command": _COMMAND,
    }
