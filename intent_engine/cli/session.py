"""A robot that listens: what ``run`` and ``listen`` have in common."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from intent_engine.cli.terminal import note, redrawn, say
from intent_engine.errors import ConfigError, Problem, RobotError, WeightsError
from intent_engine.pauses import avoid_pauses

if TYPE_CHECKING:
    from intent_engine.cli.reporter import Reporter
    from intent_engine.engine import IntentEngine
    from intent_engine.execution.clock import Clock
    from intent_engine.execution.events import Event
    from intent_engine.execution.executor import Executor
    from intent_engine.execution.guardian import Guardian
    from intent_engine.execution.robots.jsonl import JsonLinesRobot
    from intent_engine.execution.robots.robot import Robot
    from intent_engine.execution.robots.robot_file import RobotFile
    from intent_engine.execution.robots.simulated import SimulatedRobot
    from intent_engine.runtime.heard import Summary
    from intent_engine.runtime.runtime import Runtime
    from intent_engine.speech.audio import AudioSource, Report
    from intent_engine.speech.endpoint import Settings
    from intent_engine.speech.recognizer import Recognizer
    from intent_engine.speech.reflex import Reflex

__all__ = ["Ended", "Session"]


@dataclass(frozen=True)
class Ended:
    """How a session came out."""

    summary: Summary
    failed: int
    """Goals that the robot could not do."""


@dataclass
class _Loss:
    """Ends listening when the robot is gone, and keeps the reason: nobody is there to be told anything any more."""

    robot: JsonLinesRobot
    reporter: Reporter
    runtime: Runtime
    reason: str = ""

    def __call__(self, event: Event) -> None:
        if not self.reason and self.look():  # once: closing is a stop, which is an event too
            self.reporter.mute_stops()
            self.runtime.close()

    def look(self) -> bool:
        self.reason = self.reason or self.robot.lost
        return bool(self.reason)


@dataclass
class Session:
    """A robot that listens to one source: simulated, or a process that reads its commands. Made -> ``play``, once."""

    engine: IntentEngine
    robot: RobotFile
    clock: Clock
    states: tuple[str, ...] = ()
    """In which the robot is all the time, besides moving."""
    model: str | None = None
    """None: the usual one of the grammar's language."""
    second_model: str | None = None
    language: str | None = None
    free: bool = False
    reflex: bool = True
    denoise: bool = False
    noise_filter: bool = True
    settings: Settings | None = None
    """Waits of the endpoint; None: its own."""
    as_json: bool = False
    plot: Path | None = None
    draw: bool = False
    live: bool = False
    """Draw the way of the robot while it goes, on a terminal."""
    journal: Path | None = None
    drive: Path | None = None
    """Where the commands for another process go; None: the robot is simulated."""
    in_process: bool = False
    """Write the velocities for another process from this one, without a guardian."""
    controls: Callable[[Runtime, Executor], contextlib.AbstractContextManager[object]] | None = None
    """Keys and whatever else a person has in hand while it listens."""
    reporter: Reporter | None = None
    """Set while it plays."""

    def play(self, source: AudioSource, *, check: Callable[[Summary], None] | None = None) -> Ended:
        """Listen until the source ends and the robot has done what it was told.

        Args:
            source: is closed in any case.
            check: may raise on what was heard, before the robot goes on.

        Raises:
            ConfigError: the commands cannot be written where they should.
            RobotError: what read them went away or stood still.
            WeightsError: the recogniser failed at everything that was said.
        """
        from intent_engine.cli.outbox import Outbox
        from intent_engine.cli.reporter import Reporter
        from intent_engine.execution.clock import SteppedClock
        from intent_engine.execution.robots.robot import Pose
        from intent_engine.execution.showing import show_own_actions
        from intent_engine.runtime.runtime import Runtime

        with contextlib.ExitStack() as stack:
            stack.enter_context(contextlib.closing(source))
            places = {
                name: Pose(place.x, place.y, place.yaw, place.frame)
                for name, place in (self.engine.locations or {}).items()
            }
            recognizer = stack.enter_context(contextlib.closing(self._recognizer()))
            reflex = self._reflex(recognizer)
            if reflex is not None:
                stack.enter_context(contextlib.closing(reflex))
            robot: Robot
            loop: Guardian | None = None
            simulated: SimulatedRobot | None = None
            driven: JsonLinesRobot | None = None
            if self.drive is None:
                robot = simulated = self.robot.simulated(self.clock, places)
            else:
                driven, loop = self._driven(stack, self.drive)
                robot = driven
            # Where time does not stand still, nobody who reads what is told may hold up what is done.
            outbox = None if isinstance(self.clock, SteppedClock) else stack.enter_context(Outbox())
            self.reporter = reporter = Reporter(robot, as_json=self.as_json, outbox=outbox)
            executor = self._executor(stack, robot, loop, reporter)
            if simulated is not None:
                show_own_actions(executor)
            runtime = Runtime(
                self.engine,
                executor,
                recognizer,
                reflex=reflex,
                settings=self.settings,
                noise_filter="auto" if self.noise_filter else None,
                on_event=reporter.heard,
                state=lambda: self.states,
            )
            if outbox is not None:
                outbox.on_failure = runtime.close
            loss = _Loss(driven, reporter, runtime) if driven is not None else None
            if loss is not None:
                executor.subscribe(loss)
            avoid_pauses()
            reporter.start = self.clock.now()
            if self.live and simulated is not None and not self.as_json:
                from intent_engine.execution.robots.path_view import LiveView

                stack.enter_context(redrawn(LiveView(simulated)))
            if self.controls is not None:
                stack.enter_context(self.controls(runtime, executor))
                reporter.start = self.clock.now()
            try:
                summary = runtime.run(source)
                executor.settle()  # a stop that was said is news
            except KeyboardInterrupt:
                executor.stop()
                self._draw(simulated)
                raise
            finally:
                reporter.mute_stops()
            if outbox is not None:
                outbox.settle(0.0)  # who ended listening since nobody reads has heard nothing to complain about
            if check is not None:
                check(summary)
            executor.wait()
            executor.settle()  # the end is told after what was done
            if loss is not None and loss.look():
                raise RobotError(f"{self.drive}: {loss.reason}\n    start what reads the commands again, and listen")
            reporter.end(summary, self.clock.now())
        self._draw(simulated)
        _check_heard(summary, reporter.error)
        return Ended(summary, reporter.failed)

    def report(self, report: Report) -> None:
        """What a source tells; for its ``on_report``."""
        if self.reporter is not None:
            self.reporter.source(report)

    def _executor(
        self, stack: contextlib.ExitStack, robot: Robot, loop: Guardian | None, reporter: Reporter
    ) -> Executor:
        """What drives the robot, within what its file says, and writes the journal."""
        from intent_engine.execution.executor import Executor
        from intent_engine.execution.journal import Journal

        options = self.robot.executor_options()
        if self.journal is not None:
            options["journal"] = stack.enter_context(Journal(self.journal))
        return stack.enter_context(Executor(robot, clock=self.clock, loop=loop, on_event=reporter.executed, **options))

    def _driven(self, stack: contextlib.ExitStack, target: Path) -> tuple[JsonLinesRobot, Guardian | None]:
        """A robot behind a file or pipe, and the process that writes its velocities.

        Raises:
            ConfigError: nothing can be written there.
        """
        from intent_engine.execution.guardian import Guardian
        from intent_engine.execution.robots.jsonl import JSONL_SINK, JsonLinesRobot

        try:
            out = os.open(target, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o644)
        except OSError as error:
            why = (error.strerror or str(error)).lower()
            hint = "give a file or a pipe that the robot's program reads: listen --drive >(python robot.py)"
            raise ConfigError(Problem(f"--drive: {target} cannot be written: {why}", hint=hint)) from None
        stack.callback(os.close, out)
        os.set_blocking(out, False)  # two processes write there, and neither may wait for a reader that stands still
        robot = JsonLinesRobot(out, capabilities=self.robot.capabilities)
        if self.in_process:
            return robot, None
        limits, rates = self.robot.limits, self.robot.rates
        guardian = Guardian(JSONL_SINK, {"out": out}, limits=limits, rates=rates, pass_fds=(out,))
        return robot, stack.enter_context(contextlib.closing(guardian))

    def _draw(self, robot: SimulatedRobot | None) -> None:
        if robot is None:
            return
        if self.draw and not self.as_json:
            from intent_engine.execution.robots.path_view import path_text

            say()
            say(path_text(robot))
        if self.plot is not None:
            from intent_engine.execution.robots.path_view import plot_path

            self.plot.parent.mkdir(parents=True, exist_ok=True)
            plot_path(robot, self.plot, title="The way of the robot")
            note(f"the way of the robot is drawn in {self.plot}")

    def _reflex(self, beside: Recognizer) -> Reflex | None:
        if not self.reflex:
            return None
        from intent_engine.execution.clock import SteppedClock
        from intent_engine.speech.reflex import reflex_for

        background = not isinstance(self.clock, SteppedClock)
        return reflex_for(self.engine, language=self.language, background=background, beside=beside)

    def _recognizer(self) -> Recognizer:
        from intent_engine.speech.free import free_recognizer
        from intent_engine.speech.models import recognizer_for

        recognizer: Recognizer
        if self.free:
            recognizer = free_recognizer(self.model, language=self.language or self.engine.languages[0], tell=note)
        else:
            recognizer = recognizer_for(
                self.engine, self.model, second=self.second_model, language=self.language, tell=note
            )
        if self.denoise:
            from intent_engine.speech.denoise import DenoisedRecognizer

            return DenoisedRecognizer(recognizer)
        return recognizer


def _check_heard(summary: Summary, last: str) -> None:
    """See that the recogniser did not fail at everything.

    Raises:
        WeightsError: it did; ``last`` is why it did so last.
    """
    if summary.errors and not summary.utterances:
        raise WeightsError(
            f"nothing of what was said could be recognised ({summary.errors} "
            f"failure{'s' * (summary.errors != 1)}; the last: {last})\n"
            "    look at this machine with intent-engine doctor, or take another model: --model base"
        )
