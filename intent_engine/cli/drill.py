"""``intent-engine drill``: the safety promises, tried on this machine."""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING, Annotated

import typer

from intent_engine.cli.guard import EXIT_NOT_ACCEPTED, Terminated, verb
from intent_engine.cli.options import Json, Robots
from intent_engine.cli.terminal import json_line, note, say, table
from intent_engine.resources import find

if TYPE_CHECKING:
    from intent_engine.execution.drill import DrillReport, Trial

__all__ = ["drill"]


@verb
def drill(
    robot: Robots = "simulated",
    quick: Annotated[bool, typer.Option("--quick", help="Fewer runs of each promise.")] = False,
    as_json: Json = False,
) -> int:
    """Try the safety promises on this machine with a robot's file: stop, flood, killed and frozen processes.

    No robot moves: a recorder stands in its place. The processes are real, and are really killed.
    """
    from intent_engine.execution.drill import DrillReport
    from intent_engine.execution.drill import drill as run
    from intent_engine.execution.robots.robot_file import load_robot

    file = load_robot(find("robots", robot))
    if not as_json:
        note(f"trying {file.name} with every core busy; this takes {'a quarter of a minute' if quick else 'a minute'}")
    executor_log = logging.getLogger("intent_engine.execution")
    before = executor_log.level
    executor_log.setLevel(logging.CRITICAL)  # what the trials break on purpose is no news
    tried: list[Trial] = []
    try:
        report = run(file, quick=quick, on_trial=tried.append)
    except (KeyboardInterrupt, Terminated):
        if tried:
            _show(DrillReport(file.name, tuple(tried), complete=False), as_json)
        raise
    finally:
        executor_log.setLevel(before)
    _show(report, as_json)
    return 0 if report.passed else EXIT_NOT_ACCEPTED


def _show(report: DrillReport, as_json: bool) -> None:
    if as_json:
        json_line(report.to_json())
        return
    columns = ("promise", "allowed ms", "median ms", "worst ms", "runs", "verdict", "what")
    left = "" if report.complete else ", not all of it"
    table(f"drill of {report.robot}{left}", columns, (_row(trial) for trial in report.trials))
    for text in report.notes:
        note(text)
    if report.passed:
        say("every promise was kept", "green")
    elif not all(trial.passed for trial in report.trials):
        say("a promise was broken", "bold red")


def _row(trial: Trial) -> tuple[object, ...]:
    times = [f"{1000 * value:.2f}" if value is not None else "" for value in (trial.median, trial.worst)]
    allowed = f"{1000 * trial.limit:.0f}" if trial.limit is not None else ""
    return (
        trial.name,
        allowed,
        *times,
        trial.runs,
        "kept" if trial.passed else "BROKEN",
        trial.detail or trial.promise,
    )
