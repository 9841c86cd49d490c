"""Threads that command, hold, pause and move time while another one stops: nothing may follow the stop."""

from __future__ import annotations

import logging
import random
import sys
import threading
from collections.abc import Iterator

import pytest
from execution_stage import Stage

from intent_engine.actions import Custom, Move, Navigate, Turn
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Rates

COMMANDS = [
    Move(0.5, 0.2, 0.4),
    Move(-0.3, 5.0, 5.0 / 0.3),
    Turn(1.0, 1.0, 1.0),
    Navigate("kitchen", 5.0, 2.0, 0.0),
    Custom("wave"),
    Custom("broken"),
]


@pytest.fixture(autouse=True)
def unlogged() -> Iterator[None]:
    """Tens of thousands of tracebacks of ``broken``, kept for the report of a test, are most of its time."""
    logging.disable(logging.ERROR)
    yield
    logging.disable(logging.NOTSET)


def broken(action: Custom) -> None:
    raise ValueError("no arm")


def race(trials: int, seed: int) -> int:
    """Stop ``trials`` times in the middle of everything; returns how many goals ended."""
    s = Stage(
        Limits(linear_acceleration=2.0),
        rates=Rates(rate=100.0),
        handlers={"wave": lambda action: None, "broken": broken},
    )
    executor, written = s.executor, s.robot.written
    ended: dict[int, int] = {}
    done = threading.Event()
    trouble: list[BaseException] = []

    def loop(step) -> threading.Thread:
        def run() -> None:
            try:
                while not done.is_set():
                    step()
            except BaseException as error:
                trouble.append(error)

        return threading.Thread(target=run, daemon=True)

    chance = random.Random(seed)
    other = random.Random(seed + 1)
    meddle = [executor.hold, executor.release, executor.pause, executor.resume, executor.release, executor.resume]
    threads = [
        loop(lambda: s.clock.advance(0.007)),
        loop(lambda: other.choice(meddle)()),
    ]
    goals = []
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    try:
        for thread in threads:
            thread.start()
        for _ in range(trials):
            new = executor.submit(chance.choices(COMMANDS, k=chance.randint(1, 3)))
            goals += new
            for goal in new:
                goal.add_done_callback(lambda goal: ended.__setitem__(goal.id, ended.get(goal.id, 0) + 1))
            for _ in range(chance.randint(0, 300)):
                pass
            executor.stop()
            first = len(written)
            for _ in range(chance.randint(0, 300)):
                pass
            late = [write for write in written[first:] if write.linear or write.angular]
            assert late == []
            assert all(goal.done for goal in new)
            written.clear()
            s.events.clear()
            s.robot.trace.clear()
            assert not trouble, trouble
    finally:
        sys.setswitchinterval(before)
        done.set()
        for thread in threads:
            thread.join(10.0)
        executor.close()
    assert all(ended[goal.id] == 1 for goal in goals)
    return len(ended)


def test_nothing_follows_a_stop_whoever_else_is_at_it():
    assert race(2000, seed=1) >= 2000


@pytest.mark.slow
def test_nothing_follows_a_stop_in_100_000_interleavings():
    assert race(100_000, seed=2) >= 100_000
