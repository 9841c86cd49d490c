"""``intent-engine run`` and ``intent-engine listen``: from sound to a moving robot."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from intent_engine.cli.guard import EXIT_NOT_ACCEPTED, verb
from intent_engine.cli.options import Grammars, Json, Language, Locations, Robots, load_engine
from intent_engine.cli.terminal import note, say
from intent_engine.errors import AudioError
from intent_engine.resources import find

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine
    from intent_engine.execution.clock import Clock
    from intent_engine.execution.robots.robot_file import RobotFile
    from intent_engine.execution.robots.simulated import SimulatedRobot
    from intent_engine.speech.audio import AudioSource
    from intent_engine.speech.recognizer import Recognizer
    from intent_engine.speech.reflex import Reflex

__all__ = ["run"]

Model = Annotated[str, typer.Option("--model", "-m", help="Whisper model: a name (tiny.en, base, ...) or a folder.")]


Free = Annotated[bool, typer.Option("--free", help="Decode without the help of the grammar, to compare.")]
NoReflex = Annotated[
    bool, typer.Option("--no-reflex", help="Do not hold the robot while a stop word is still being said.")
]
Plot = Annotated[Path | None, typer.Option(help="Draw the way of the robot into this file (PNG, SVG or PDF).")]
Draw = Annotated[bool, typer.Option("--map", help="Draw the way of the robot in the terminal at the end.")]
JournalFile = Annotated[
    Path | None, typer.Option("--journal", help="Add what the robot did to this file, as JSON lines.")
]


@verb
def run(
    file: Annotated[Path, typer.Argument(help="A recording: WAV or FLAC, any rate, mono or stereo.")],
    grammar: Grammars = None,
    locations: Locations = None,
    robot: Robots = "simulated",
    language: Language = None,
    model: Model = "tiny.en",
    free: Free = False,
    no_reflex: NoReflex = False,
    realtime: Annotated[
        bool, typer.Option("--realtime", help="Play at the speed of the recording, not as fast as possible.")
    ] = False,
    as_json: Json = False,
    plot: Plot = None,
    draw: Draw = False,
    journal: JournalFile = None,
) -> int:
    """Play a recording to a simulated robot, and tell what is heard, understood and done."""
    from intent_engine.execution.clock import MonotonicClock, VirtualClock
    from intent_engine.execution.robots.robot_file import load_robot
    from intent_engine.speech.sources.file import FileSource

    source = FileSource(file, realtime=realtime)
    session = _Session(
        engine=load_engine(grammar, locations, language),
        robot=load_robot(find("robots", robot)),
        clock=MonotonicClock() if realtime else VirtualClock(),
        model=model,
        language=language,
        free=free,
        reflex=not no_reflex,
        as_json=as_json,
        plot=plot,
        draw=draw,
        journal=journal,
    )
    return session.play(source, str(file))


@dataclass(frozen=True)
class _Session:
    """A simulated robot that listens to one source."""

    engine: IntentEngine
    robot: RobotFile
    clock: Clock
    model: str
    language: str | None
    free: bool
    reflex: bool
    as_json: bool
    plot: Path | None = None
    draw: bool = False
    journal: Path | None = None

    def play(self, source: AudioSource, name: str) -> int:
        """Listen until the source ends and the robot has done what it was told; returns the exit code."""
        from intent_engine.cli.reporter import Reporter
        from intent_engine.execution.executor import Executor
        from intent_engine.execution.robots.robot import Pose
        from intent_engine.runtime import Runtime

        places = {
            name: Pose(place.x, place.y, place.yaw, place.frame)
            for name, place in (self.engine.locations or {}).items()
        }
        recognizer = self._recognizer()
        robot = self.robot.simulated(self.clock, places)
        reporter = Reporter(robot, as_json=self.as_json)
        options = self.robot.executor_options()
        if self.journal is not None:
            from intent_engine.execution.journal import Journal

            options["journal"] = Journal(self.journal)
        with Executor(robot, clock=self.clock, on_event=reporter.executed, **options) as executor:
            runtime = Runtime(self.engine, executor, recognizer, reflex=self._reflex(), on_event=reporter.heard)
            reporter.start = self.clock.now()
            try:
                summary = runtime.run(source)
            finally:
                reporter.mute_stops()
            if summary.utterances == 0:
                raise AudioError(
                    f"{name}: nobody speaks in it ({summary.seconds:.1f} s)\n"
                    "    listen to it; if there is speech, it is too quiet or buried in noise"
                )
            executor.wait()
            reporter.end(summary, self.clock.now())
        self._draw(robot)
        return 0 if summary.accepted and not reporter.failed else EXIT_NOT_ACCEPTED

    def _draw(self, robot: SimulatedRobot) -> None:
        if self.draw and not self.as_json:
            from intent_engine.execution.robots.path_view import path_text

            say()
            say(path_text(robot))
        if self.plot is not None:
            from intent_engine.execution.robots.path_view import plot_path

            self.plot.parent.mkdir(parents=True, exist_ok=True)
            plot_path(robot, self.plot, title="The way of the robot")
            note(f"the way of the robot is drawn in {self.plot}")

    def _reflex(self) -> Reflex | None:
        if not self.reflex:
            return None
        from intent_engine.execution.clock import SteppedClock
        from intent_engine.speech.reflex import reflex_for

        return reflex_for(self.engine, language=self.language, background=not isinstance(self.clock, SteppedClock))

    def _recognizer(self) -> Recognizer:
        if self.free:
            from intent_engine.speech.whisper import WhisperRecognizer

            return WhisperRecognizer(self.model, language=self.language or self.engine.languages[0])
        from intent_engine.speech.steered import SteeredWhisper

        return SteeredWhisper(self.engine, self.model, language=self.language)
