"""The options that ``run`` and ``listen`` share."""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from intent_engine.cli.options import (
    Grammars,
    Json,
    Language,
    Locations,
    Robots,
    States,
    filled,
    known_states,
    load_engine,
    tell_doubts,
)
from intent_engine.cli.outputs import check_apart, check_file, check_picture
from intent_engine.cli.watching import Watch
from intent_engine.errors import AudioError, ConfigError, Problem
from intent_engine.hints import did_you_mean
from intent_engine.language.grammar import LONGEST_WAIT
from intent_engine.resources import find

if TYPE_CHECKING:
    from intent_engine.cli.session import Session
    from intent_engine.execution.clock import Clock
    from intent_engine.speech.endpoint import Settings
    from intent_engine.speech.sources.pcm import PcmFormat

__all__ = ["Hearing", "NoNoiseFilter", "NoReflex", "RawSamples", "SecondModel", "Telling", "Wait", "session", "waits"]

Model = Annotated[
    str | None,
    typer.Option(
        "--model",
        "-m",
        callback=filled,
        help="Whisper model: a name (tiny.en, base, ...) or a folder.",
        show_default="tiny.en; base for other languages",
    ),
]
SecondModel = Annotated[
    str | None,
    typer.Option(
        callback=filled,
        help="Another model for what the first is not sure of: a name, a folder, or none.",
        show_default="moonshine-base or base, if installed",
    ),
]
Free = Annotated[bool, typer.Option("--free", help="Decode without the help of the grammar, to compare.")]
NoReflex = Annotated[
    bool, typer.Option("--no-reflex", help="Do not hold the robot while a stop word is still being said.")
]
WakeWord = Annotated[
    list[str] | None,
    typer.Option("--wake-word", help='A command must begin with it, "stop" never must; may be repeated.'),
]
Denoise = Annotated[
    bool,
    typer.Option("--denoise", help="Take steady noise out by spectral gating instead; seldom better, see the docs."),
]
NoNoiseFilter = Annotated[bool, typer.Option("--no-noise-filter", help="Recognise the sound as it is, noise and all.")]
Wait = Annotated[
    list[str] | None,
    typer.Option(
        metavar="NAME=SECONDS",
        help="Silence that ends what was said, as extendable=0.5; may be repeated. Names: complete, settled, "
        "amendable, extendable, doubtful, incomplete, other, unknown; and continued: in which time words begin that "
        "may belong to a motion before them, 0 for none.",
    ),
]
Plot = Annotated[Path | None, typer.Option(help="Draw the way of the robot into this file (PNG, SVG or PDF).")]
Draw = Annotated[bool, typer.Option("--map", help="Draw the way of the robot in the terminal at the end.")]
Live = Annotated[bool, typer.Option("--live", help="Draw the way of the robot in the terminal while it goes.")]
JournalFile = Annotated[
    Path | None, typer.Option("--journal", help="Add what the robot did to this file, as JSON lines.")
]
Rate = Annotated[int | None, typer.Option(help="Samples a second, of raw samples.", show_default="16000")]
Format = Annotated[
    str | None,
    typer.Option(help="Format of raw samples, as ffmpeg or ALSA names it: s16le, f32le, ...", show_default="s16le"),
]
Channels = Annotated[int | None, typer.Option(help="Interleaved channels of raw samples.", show_default="1")]


@dataclass(frozen=True)
class Hearing:
    """What is understood, by which robot, and with what ears."""

    grammar: Grammars = None
    locations: Locations = None
    state: States = None
    robot: Robots = "simulated"
    language: Language = None
    model: Model = None
    second_model: SecondModel = None
    free: Free = False
    no_reflex: NoReflex = False
    wake_word: WakeWord = None
    denoise: Denoise = False
    no_noise_filter: NoNoiseFilter = False
    wait: Wait = None


@dataclass(frozen=True)
class RawSamples:
    """The form of sound that has no header."""

    rate: Rate = None
    format: Format = None
    channels: Channels = None

    @property
    def given(self) -> bool:
        """Whether somebody said anything of it."""
        return self != RawSamples()

    def form(self) -> PcmFormat:
        """What was said, and the usual for the rest.

        Raises:
            ConfigError: there is no such format.
        """
        from intent_engine.speech.sources.pcm import PcmFormat

        usual = PcmFormat()
        rate = usual.rate if self.rate is None else self.rate
        encoding = usual.encoding if self.format is None else self.format
        channels = usual.channels if self.channels is None else self.channels
        options = {
            "--rate": functools.partial(PcmFormat, rate),
            "--format": functools.partial(PcmFormat, encoding=encoding),
            "--channels": functools.partial(PcmFormat, channels=channels),
        }
        problems = []
        for option, form in options.items():
            try:
                form()
            except AudioError as error:  # of a sound it would be one; here it is an option
                message, _, hint = str(error).partition("\n")
                problems.append(Problem(f"{option}: {message}", hint=hint.strip()))
        if problems:
            raise ConfigError(problems)
        return PcmFormat(rate, encoding, channels)


@dataclass(frozen=True)
class Telling:
    """What a person sees of it, and what is kept."""

    as_json: Json = False
    plot: Plot = None
    draw: Draw = False
    live: Live = False
    journal: JournalFile = None
    watch: Watch = False


def session(
    hearing: Hearing, telling: Telling, clock: Clock, *, sound: str | Path | None = None, drive: Path | None = None
) -> Session:
    """The session that the options describe.

    Args:
        hearing: what is understood, and how it is heard.
        telling: what is told and kept.
        clock: of the robot.
        sound: the file or pipe that is listened to; None: a microphone.
        drive: where the commands for another process go; None: the robot is simulated.

    Raises:
        ConfigError: a file is missing or wrong, or cannot be written.
    """
    from intent_engine.cli.session import Session
    from intent_engine.execution.robots.robot_file import load_robot

    if telling.plot is not None:
        check_picture(telling.plot, "--plot", "plot")
    if telling.journal is not None:
        check_file(telling.journal, "--journal")
    if hearing.denoise and hearing.no_noise_filter:
        hint = "give one: --denoise takes noise out in another way, --no-noise-filter takes out none"
        raise ConfigError(Problem("--denoise and --no-noise-filter at once", hint=hint))
    engine = load_engine(hearing.grammar, hearing.locations, hearing.language, hearing.wake_word)
    tell_doubts(engine, hearing.grammar)
    robot_file = find("robots", hearing.robot)
    outputs = {"--plot": telling.plot, "--journal": telling.journal, "--drive": drive}
    check_apart(outputs, [robot_file, *engine.files, *([] if sound is None else [Path(sound)])])
    return Session(
        engine=engine,
        states=known_states(engine, hearing.state),
        robot=load_robot(robot_file),
        clock=clock,
        model=hearing.model,
        second_model=hearing.second_model,
        language=hearing.language,
        free=hearing.free,
        reflex=not hearing.no_reflex,
        denoise=hearing.denoise,
        noise_filter=not (hearing.no_noise_filter or hearing.denoise),
        settings=waits(hearing.wait),
        as_json=telling.as_json,
        plot=telling.plot,
        draw=telling.draw,
        live=telling.live,
        journal=telling.journal,
        drive=drive,
    )


def waits(texts: list[str] | None) -> Settings:
    """The endpoint with these waits, each as ``extendable=0.5``.

    Raises:
        ConfigError: one is unknown, or no time.
    """
    from intent_engine.speech.endpoint import Settings

    waits = (field.name for field in fields(Settings))
    names = [name.removeprefix("wait_") for name in waits if name.startswith("wait_")]
    changed: dict[str, Any] = {}
    for text in texts or ():
        name, _, number = (part.strip() for part in text.partition("="))
        if name not in names:
            hint = did_you_mean(name, names) or f"the waits are {', '.join(names)}"
            raise ConfigError(Problem(f"--wait: there is no wait {name!r}", hint=hint))
        try:
            seconds = float(number.removesuffix("s"))
        except ValueError:
            seconds = math.nan
        if not 0 <= seconds <= LONGEST_WAIT:
            hint = f"seconds of silence, 0 to {LONGEST_WAIT:g}: --wait {name}=0.5"
            raise ConfigError(Problem(f"--wait: {number!r} is no time to wait", hint=hint))
        changed[f"wait_{name}"] = seconds
    return replace(Settings(), **changed)
