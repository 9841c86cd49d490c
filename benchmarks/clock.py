"""Clocks for what a sentence costs: processor time of the thread, engines in turns, no garbage collection."""

from __future__ import annotations

import gc
import statistics
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, TypeAlias

Times: TypeAlias = dict[str, list[list[float]]]
"""Engine -> for each round, the seconds of each sentence."""
Parse: TypeAlias = Callable[[str], Any]


@contextmanager
def no_collector() -> Iterator[None]:
    """No garbage collection while the clock runs, for anybody."""
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        gc.enable()


def answered(parse: Parse, sentence: str) -> tuple[float, Any]:
    """Seconds of this thread's processor time, and the answer: what it takes on an idle core, whatever else runs."""
    started = time.thread_time()
    answer = parse(sentence)
    return time.thread_time() - started, answer


def in_turns(engines: Mapping[str, Parse], sentences: Sequence[str], rounds: int, *, warm: bool = True) -> Times:
    """Every sentence by every engine, one after the other, ``rounds`` times.

    In each turn an engine hears something unmeasured first, so that nobody pays for waking up after the others: all
    the sentences, or, where the first time is what is measured (not ``warm``), one of another kind.
    """
    found: Times = {name: [] for name in engines}
    with no_collector():
        for _ in range(rounds):
            for name, parse in engines.items():
                for sentence in sentences if warm else ("stop",):
                    parse(sentence)
                found[name].append([answered(parse, sentence)[0] for sentence in sentences])
    return found


def median(times: list[list[float]]) -> float:
    """us: the median sentence, each by its median over the rounds."""
    return 1e6 * float(statistics.median(statistics.median(each) for each in zip(*times, strict=True)))


def worst(times: list[list[float]]) -> float:
    """us: the slowest sentence, each by its median over the rounds."""
    return 1e6 * max(float(statistics.median(each)) for each in zip(*times, strict=True))


def over_rounds(times: list[list[float]], summary: Callable[[list[list[float]]], float]) -> list[float]:
    """Lowest and highest of a summary over the rounds."""
    each = [summary([one]) for one in times]
    return [min(each), max(each)]
