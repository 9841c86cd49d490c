"""What a drill says: a trial for each promise."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import Any

__all__ = ["DrillReport", "Log", "Trial", "first_zero", "result"]

Log = list[tuple[float, float, float]]
"""What a robot was told: s on the machine's clock, m/s, rad/s"""


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
    real_time: bool = False
    """Whether the system gave the guardian SCHED_FIFO."""
    notes: tuple[str, ...] = ()
    complete: bool = True
    """Whether every promise was tried."""

    @property
    def passed(self) -> bool:
        """Whether every promise was tried, and kept."""
        return self.complete and all(trial.passed for trial in self.trials)

    def to_json(self) -> dict[str, Any]:
        """A plain dictionary."""
        return {**asdict(self), "passed": self.passed}


def first_zero(log: Log, since: float) -> float:
    """s from ``since`` to the first zero; infinite if there was none."""
    return next((at - since for at, linear, angular in log if at >= since and not linear and not angular), math.inf)


def result(
    name: str, promise: str, limit: float | None, times: list[float], faults: list[str], detail: str = ""
) -> Trial:
    """A trial of these times (s; infinite: never); it failed if one is over the limit, or if there were faults."""
    ordered = sorted(time for time in times if math.isfinite(time))
    if len(ordered) < len(times):
        faults = [f"zero never came in {len(times) - len(ordered)} of {len(times)} runs", *faults]
    worst = ordered[-1] if ordered else None
    if limit is not None and worst is not None and worst > limit:
        faults = [f"the slowest of {len(times)} took {worst * 1000:.1f} ms", *faults]
    median = ordered[len(ordered) // 2] if ordered else None
    return Trial(name, promise, limit, worst, median, len(times), not faults, "; ".join(faults[:3]) or detail)
