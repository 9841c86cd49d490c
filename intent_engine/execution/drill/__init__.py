"""The safety promises, tried on this machine with this robot's file: ``intent-engine drill``.

Nothing here drives a real robot. The executor, the guardian process and the timing are the real ones; at the end of
the line stands a recorder instead of a robot, with the limits and rates of the robot file. Processes are really killed
and frozen. What is measured is the time from the event to the zero that the robot would have received.
"""

from __future__ import annotations

import os
import signal
from collections.abc import Callable

from intent_engine.execution.drill.load import busy
from intent_engine.execution.drill.lost import loop_killed, program_lost
from intent_engine.execution.drill.report import DrillReport, Trial
from intent_engine.execution.drill.stops import flood, late_writes, robot_hangs, robot_raises, stop_under_load
from intent_engine.execution.robots.robot_file import RobotFile

__all__ = ["DrillReport", "Trial", "busy", "drill", "loop_killed", "program_lost"]


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
        add(stop_under_load(file, runs))
        add(flood(file, 500 if quick else 2000))
        add(program_lost("killed", signal.SIGKILL, file, guardian_runs))
        add(program_lost("frozen", signal.SIGSTOP, file, guardian_runs))
        trial, real_time = loop_killed(file, guardian_runs)
        add(trial)
    add(robot_raises(file, runs))
    add(robot_hangs(file, runs))
    add(late_writes(file, 100 if quick else 400))
    notes = ["the base still needs a command timeout of its own: no program stops a robot whose computer is gone"]
    if not real_time:
        notes.append("no SCHED_FIFO here (root, CAP_SYS_NICE or an rtprio limit would allow it)")
    return DrillReport(file.name, tuple(trials), real_time, tuple(notes))
