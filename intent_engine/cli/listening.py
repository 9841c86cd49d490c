"""``intent-engine run`` and ``intent-engine listen``: from sound to a moving robot."""

from __future__ import annotations

import contextlib
import functools
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, BinaryIO

import typer

from intent_engine.cli.guard import EXIT_NOT_ACCEPTED, robot_verb
from intent_engine.cli.listening_options import Hearing, RawSamples, Telling, session
from intent_engine.cli.option_groups import grouped
from intent_engine.cli.options import Device
from intent_engine.cli.terminal import json_line, note, table
from intent_engine.cli.watching import watched
from intent_engine.errors import AudioError, ConfigError, DeviceError, Problem

if TYPE_CHECKING:
    from intent_engine.cli.session import Session
    from intent_engine.execution.executor import Executor
    from intent_engine.runtime.heard import Summary
    from intent_engine.runtime.runtime import Runtime
    from intent_engine.speech.audio import AudioSource
    from intent_engine.speech.sources.pcm import PcmFormat, PcmSource

__all__ = ["listen", "run"]


@robot_verb
@grouped
def run(
    file: Annotated[
        Path, typer.Argument(help="A recording: WAV or FLAC, any rate, mono or stereo; - reads raw samples or WAV.")
    ],
    *,
    hearing: Hearing,
    realtime: Annotated[
        bool, typer.Option("--realtime", help="Play at the speed of the recording, not as fast as possible.")
    ] = False,
    samples: RawSamples,
    telling: Telling,
) -> int:
    """Play a recording to a simulated robot, and tell what is heard, understood and done."""
    from intent_engine.execution.clock import MonotonicClock, VirtualClock
    from intent_engine.speech.sources.file import TAIL_SECONDS, FileSource, is_headerless

    if telling.watch and not realtime:
        raise ConfigError(
            Problem(
                "--watch needs --realtime",
                hint="give both: else the recording is over before anyone could edit the grammar",
            )
        )
    if telling.live and not realtime:
        raise ConfigError(
            Problem("--live needs --realtime", hint="give both, or --map: it draws the whole way when all is over")
        )
    form = samples.form()
    source: AudioSource
    if str(file) == "-":
        source, name = _pcm("-", form, realtime=realtime), "standard input"
    else:
        raw = form if samples.given and is_headerless(file) else None
        if samples.given and raw is None:
            note(f"--rate, --format and --channels are of raw samples; {file} says how its own lie in it")
        source, name = FileSource(file, realtime=realtime, form=raw), str(file)
    made = session(hearing, telling, MonotonicClock() if realtime else VirtualClock(), sound=file)

    def somebody_spoke(summary: Summary) -> None:
        if summary.utterances == 0 and not summary.errors and not summary.lost:
            seconds = max(summary.seconds - TAIL_SECONDS, 0.0)  # without the silence that every source adds at its end
            raise AudioError(
                f"{name}: nobody speaks in it ({seconds:.1f} s)\n"
                "    listen to it; if there is speech, it is too quiet or buried in noise"
            )

    with watched(made.engine, hearing.grammar, telling.watch):
        ended = made.play(source, check=somebody_spoke)
    return 0 if ended.summary.accepted and not ended.failed else EXIT_NOT_ACCEPTED


@robot_verb
@grouped
def listen(
    *,
    device: Device = None,
    list_devices: Annotated[bool, typer.Option("--list-devices", help="List the microphones and exit.")] = False,
    push_to_talk: Annotated[
        bool, typer.Option("--push-to-talk", help="Listen only after the space bar, until it is pressed again.")
    ] = False,
    pcm: Annotated[
        str | None, typer.Option(help="Raw samples from this pipe instead, as they come; - is standard input.")
    ] = None,
    drive: Annotated[
        Path | None,
        typer.Option(help="Drive no simulated robot: write its commands, a line of JSON each, into this file or pipe."),
    ] = None,
    in_process: Annotated[
        bool, typer.Option("--in-process", help="With --drive: no process of its own for the velocities.")
    ] = False,
    samples: RawSamples,
    hearing: Hearing,
    telling: Telling,
) -> int:
    """Listen to a microphone and drive a robot, until Ctrl-C. Speak: "go forward two meters".

    The robot is simulated, or, with --drive, whatever reads the lines. Their velocities are written by a process of its
    own, which stops the robot within 0.3 s if this one dies or hangs.
    """
    from intent_engine.execution.clock import MonotonicClock

    if list_devices:
        return _list_devices(telling.as_json)
    if device is not None and pcm is not None:
        raise ConfigError(Problem("a microphone and raw samples at once", hint="give --device or --pcm, not both"))
    form = samples.form()
    if samples.given and pcm is None:
        hint = "say where they come from: --pcm -; a microphone needs none of these"
        raise ConfigError(Problem("--rate, --format and --channels are of raw samples", hint=hint))
    if in_process and drive is None:
        raise ConfigError(
            Problem("--in-process without --drive", hint="leave it out: a simulated robot is here anyway")
        )
    if push_to_talk:
        from intent_engine.cli.keys import check_terminal

        check_terminal()
    if drive is not None and (telling.plot or telling.draw or telling.live):
        raise ConfigError(
            Problem("only a simulated robot has a way to draw", hint="leave out --plot, --map and --live")
        )
    made = session(hearing, telling, MonotonicClock(), sound=pcm, drive=drive)
    made.in_process = in_process
    source: AudioSource
    begin: Callable[[], object] | None
    if pcm is not None:
        piped = _pcm(pcm, form, session=made)
        source, name, begin = piped, "standard input" if pcm == "-" else pcm, piped.begin
    else:
        from intent_engine.speech.sources.microphone import Microphone

        microphone = Microphone(device, on_report=made.report)
        source, name, begin = microphone, f"microphone {microphone.device.name!r}", None
    made.controls = functools.partial(_controls, name, push_to_talk, begin)
    with watched(made.engine, hearing.grammar, telling.watch):
        made.play(source)
    return 0


@contextlib.contextmanager
def _controls(
    name: str, push_to_talk: bool, begin: Callable[[], object] | None, runtime: Runtime, executor: Executor
) -> Iterator[None]:
    """Say that it listens, once it does (``begin`` lets it); and the keys of push-to-talk."""
    if begin is not None:
        begin()
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

    def gone() -> None:
        """Nobody could press a key any more, to be heard or to stop the robot."""
        runtime.close()
        note("the terminal is gone, and with it the keys: the robot is stopped")

    runtime.push_to_talk()
    with keys(pressed, gone):
        note(f"space: begin and end talking to {name}, s: stop the robot, q: quit")
        yield


def _pcm(where: str, form: PcmFormat, *, realtime: bool = False, session: Session | None = None) -> PcmSource:
    """Raw samples: those that a session listens to as they come, or a recording."""
    from intent_engine.speech.sources.pcm import PcmSource

    file: BinaryIO
    if where == "-":
        if sys.stdin is None or sys.stdin.isatty():
            what = "closed" if sys.stdin is None else "a terminal"
            raise AudioError(
                f"standard input is {what}, and no sound comes from it\n"
                "    pipe sound into it: arecord -f S16_LE -r 16000 -t raw | intent-engine ..."
            )
        file, name = sys.stdin.buffer, "standard input"
    else:
        try:
            file, name = Path(where).open("rb"), where  # noqa: SIM115 - it ends with the process
        except OSError as error:
            raise AudioError(f"{where}: {(error.strerror or str(error)).lower()}\n    give a file or a pipe") from None
    if session is None:
        source = PcmSource(file, form, realtime=realtime, name=name)
    else:
        source = PcmSource(file, form, live=True, name=name, on_report=session.report)
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
