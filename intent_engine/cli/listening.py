"""``intent-engine run`` and ``intent-engine listen``: from sound to a moving robot."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from intent_engine.cli.guard import EXIT_NOT_ACCEPTED, verb
from intent_engine.cli.options import Grammars, Json, Language, Locations, load_engine
from intent_engine.errors import AudioError

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine
    from intent_engine.execution.clock import Clock
    from intent_engine.speech.audio import AudioSource

__all__ = ["run"]

Model = Annotated[str, typer.Option("--model", "-m", help="Whisper model: a name (tiny.en, base, ...) or a folder.")]


@verb
def run(
    file: Annotated[Path, typer.Argument(help="A recording: WAV or FLAC, any rate, mono or stereo.")],
    grammar: Grammars = None,
    locations: Locations = None,
    language: Language = None,
    model: Model = "tiny.en",
    realtime: Annotated[
        bool, typer.Option("--realtime", help="Play at the speed of the recording, not as fast as possible.")
    ] = False,
    as_json: Json = False,
) -> int:
    """Play a recording to a simulated robot, and tell what is heard, understood and done."""
    from intent_engine.execution.clock import MonotonicClock, VirtualClock
    from intent_engine.speech.sources.file import FileSource

    source = FileSource(file, realtime=realtime)
    engine = load_engine(grammar, locations, language)
    clock: Clock = MonotonicClock() if realtime else VirtualClock()
    return _session(engine, source, clock, str(file), model=model, as_json=as_json)


def _session(engine: IntentEngine, source: AudioSource, clock: Clock, name: str, *, model: str, as_json: bool) -> int:
    from intent_engine.cli.reporter import Reporter
    from intent_engine.execution.executor import Executor
    from intent_engine.execution.robots.simulated import SimulatedRobot
    from intent_engine.runtime import Runtime
    from intent_engine.speech.whisper import WhisperRecognizer

    recognizer = WhisperRecognizer(model)
    robot = SimulatedRobot(clock)
    reporter = Reporter(robot, as_json=as_json)
    with Executor(robot, clock=clock, on_event=reporter.executed) as executor:
        runtime = Runtime(engine, executor, recognizer, on_event=reporter.heard)
        reporter.start = clock.now()
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
        reporter.end(summary, clock.now())
    return 0 if summary.accepted and not reporter.failed else EXIT_NOT_ACCEPTED
