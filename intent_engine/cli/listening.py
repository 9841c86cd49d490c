"""``intent-engine run`` and ``intent-engine listen``: from sound to a moving robot."""

from __future__ import annotations

import contextlib
import functools
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, BinaryIO

import typer

from intent_engine.cli.guard import EXIT_NOT_ACCEPTED, verb
from intent_engine.cli.options import Grammars, Json, Language, Locations, Robots, load_engine
from intent_engine.cli.terminal import json_line, note, table
from intent_engine.cli.watching import Watch, watched
from intent_engine.errors import AudioError, ConfigError, DeviceError, Problem
from intent_engine.resources import find

if TYPE_CHECKING:
    from intent_engine.cli.session import Session
    from intent_engine.execution.executor import Executor
    from intent_engine.runtime import Runtime, Summary
    from intent_engine.speech.audio import AudioSource

__all__ = ["listen", "run"]

Model = Annotated[str, typer.Option("--model", "-m", help="Whisper model: a name (tiny.en, base, ...) or a folder.")]
Free = Annotated[bool, typer.Option("--free", help="Decode without the help of the grammar, to compare.")]
NoReflex = Annotated[
    bool, typer.Option("--no-reflex", help="Do not hold the robot while a stop word is still being said.")
]
WakeWord = Annotated[
    list[str] | None,
    typer.Option("--wake-word", help='A command must begin with it, "stop" never must; may be repeated.'),
]
Denoise = Annotated[
    bool, typer.Option("--denoise", help="Reduce noise before recognising; seldom better, see the docs on speech.")
]
Plot = Annotated[Path | None, typer.Option(help="Draw the way of the robot into this file (PNG, SVG or PDF).")]
Draw = Annotated[bool, typer.Option("--map", help="Draw the way of the robot in the terminal at the end.")]
Live = Annotated[bool, typer.Option("--live", help="Draw the way of the robot in the terminal while it goes.")]
JournalFile = Annotated[
    Path | None, typer.Option("--journal", help="Add what the robot did to this file, as JSON lines.")
]
Rate = Annotated[int, typer.Option(help="Samples a second, of raw samples.")]
Format = Annotated[str, typer.Option(help="Format of raw samples, as ffmpeg or ALSA names it: s16le, f32le, ...")]
Channels = Annotated[int, typer.Option(help="Interleaved channels of raw samples.")]


@verb
def run(
    file: Annotated[
        Path, typer.Argument(help="A recording: WAV or FLAC, any rate, mono or stereo; - reads raw samples or WAV.")
    ],
    grammar: Grammars = None,
    locations: Locations = None,
    robot: Robots = "simulated",
    language: Language = None,
    model: Model = "tiny.en",
    free: Free = False,
    no_reflex: NoReflex = False,
    wake_word: WakeWord = None,
    denoise: Denoise = False,
    realtime: Annotated[
        bool, typer.Option("--realtime", help="Play at the speed of the recording, not as fast as possible.")
    ] = False,
    rate: Rate = 16_000,
    format: Format = "s16le",
    channels: Channels = 1,
    as_json: Json = False,
    plot: Plot = None,
    draw: Draw = False,
    live: Live = False,
    journal: JournalFile = None,
    watch: Watch = False,
) -> int:
    """Play a recording to a simulated robot, and tell what is heard, understood and done."""
    from intent_engine.cli.session import Session
    from intent_engine.execution.clock import MonotonicClock, VirtualClock
    from intent_engine.execution.robots.robot_file import load_robot
    from intent_engine.speech.sources.file import FileSource

    if watch and not realtime:
        raise typer.BadParameter("--watch needs --realtime: without it the recording is over before anyone could edit")
    if live and not realtime:
        raise typer.BadParameter("--live needs --realtime: without it all is over at once; --map draws the whole way")
    source: AudioSource
    if str(file) == "-":
        source, name = _pcm("-", rate, format, channels, live=realtime), "standard input"
    else:
        source, name = FileSource(file, realtime=realtime), str(file)
    session = Session(
        engine=load_engine(grammar, locations, language, wake_word),
        robot=load_robot(find("robots", robot)),
        clock=MonotonicClock() if realtime else VirtualClock(),
        model=model,
        language=language,
        free=free,
        reflex=not no_reflex,
        denoise=denoise,
        as_json=as_json,
        plot=plot,
        draw=draw,
        live=live,
        journal=journal,
    )

    def somebody_spoke(summary: Summary) -> None:
        if summary.utterances == 0:
            raise AudioError(
                f"{name}: nobody speaks in it ({summary.seconds:.1f} s)\n"
                "    listen to it; if there is speech, it is too quiet or buried in noise"
            )

    with watched(session.engine, watch):
        ended = session.play(source, check=somebody_spoke)
    return 0 if ended.summary.accepted and not ended.failed else EXIT_NOT_ACCEPTED


@verb
def listen(
    device: Annotated[
        str | None, typer.Option(help="Microphone: its number, name, or a part of the name.", show_default="default")
    ] = None,
    list_devices: Annotated[bool, typer.Option("--list-devices", help="List the microphones and exit.")] = False,
    push_to_talk: Annotated[
        bool, typer.Option("--push-to-talk", help="Listen only after the space bar, until it is pressed again.")
    ] = False,
    pcm: Annotated[
        str | None, typer.Option(help="Raw samples from this file or pipe instead; - is standard input.")
    ] = None,
    rate: Rate = 16_000,
    format: Format = "s16le",
    channels: Channels = 1,
    grammar: Grammars = None,
    locations: Locations = None,
    robot: Robots = "simulated",
    language: Language = None,
    model: Model = "tiny.en",
    free: Free = False,
    no_reflex: NoReflex = False,
    wake_word: WakeWord = None,
    denoise: Denoise = False,
    as_json: Json = False,
    plot: Plot = None,
    draw: Draw = False,
    live: Live = False,
    journal: JournalFile = None,
    watch: Watch = False,
) -> int:
    """Listen to a microphone and drive a simulated robot, until Ctrl-C. Speak: "go forward two meters"."""
    from intent_engine.cli.session import Session
    from intent_engine.execution.clock import MonotonicClock
    from intent_engine.execution.robots.robot_file import load_robot

    if list_devices:
        return _list_devices(as_json)
    if device is not None and pcm is not None:
        raise ConfigError(Problem("a microphone and raw samples at once", hint="give --device or --pcm, not both"))
    if push_to_talk:
        from intent_engine.cli.keys import check_terminal

        check_terminal()
    session = Session(
        engine=load_engine(grammar, locations, language, wake_word),
        robot=load_robot(find("robots", robot)),
        clock=MonotonicClock(),
        model=model,
        language=language,
        free=free,
        reflex=not no_reflex,
        denoise=denoise,
        as_json=as_json,
        plot=plot,
        draw=draw,
        live=live,
        journal=journal,
    )
    source: AudioSource
    if pcm is not None:
        source, name = _pcm(pcm, rate, format, channels, live=True, session=session), pcm.replace("-", "standard input")
    else:
        from intent_engine.speech.sources.microphone import Microphone

        microphone = Microphone(device, on_report=session.report)
        source, name = microphone, f"microphone {microphone.device.name!r}"
    session.controls = functools.partial(_controls, name, push_to_talk)
    with watched(session.engine, watch):
        session.play(source)
    return 0


@contextlib.contextmanager
def _controls(name: str, push_to_talk: bool, runtime: Runtime, executor: Executor) -> Iterator[None]:
    """Say that it listens, once it does; and the keys of push-to-talk."""
    if not push_to_talk:
        note(f"listening to {name}; Ctrl-C ends it")
        yield
        return
    from intent_engine.cli.keys import keys

    talking = False

    def pressed(key: str) -> None:
        nonlocal talking
        if key == " ":
            talking = not talking
            runtime.talk(talking)
            note("listening" if talking else "not listening")
        elif key in "sS\x1b":
            executor.stop()
        elif key in "qQ":
            runtime.close()

    runtime.push_to_talk()
    with keys(pressed):
        note(f"space: begin and end talking to {name}, s: stop the robot, q: quit")
        yield


def _pcm(
    where: str, rate: int, encoding: str, channels: int, *, live: bool, session: Session | None = None
) -> AudioSource:
    from intent_engine.speech.sources.pcm import PcmFormat, PcmSource

    form = PcmFormat.of(rate, encoding, channels)
    file: BinaryIO
    if where == "-":
        if sys.stdin is None or sys.stdin.isatty():
            raise AudioError(
                "standard input is a terminal, and no sound comes from it\n"
                "    pipe sound into it: arecord -f S16_LE -r 16000 -t raw | intent-engine ..."
            )
        file, name = sys.stdin.buffer, "standard input"
    else:
        try:
            file, name = Path(where).open("rb"), where  # noqa: SIM115 - it ends with the process
        except OSError as error:
            raise AudioError(f"{where}: {(error.strerror or str(error)).lower()}\n    give a file or a pipe") from None
    source = PcmSource(file, form, live=live, name=name, on_report=session.report if session is not None else None)
    source.check()
    return source


def _list_devices(as_json: bool) -> int:
    from intent_engine.speech.sources.devices import hint_for_no_microphone, list_devices

    there = list_devices()
    if as_json:
        for one in there:
            json_line(
                {
                    "index": one.index,
                    "name": one.name,
                    "channels": one.channels,
                    "rate": one.rate,
                    "interface": one.interface,
                    "default": one.default,
                }
            )
    elif there:
        rows = ((one.index, one.name, one.channels, one.rate, one.interface, "*" * one.default) for one in there)
        table("microphones", ("number", "name", "channels", "Hz", "interface", "default"), rows)
    if not there:
        raise DeviceError(f"there is no microphone\n    {hint_for_no_microphone()}")
    return 0
