"""``intent-engine evaluate``: how well a folder of recordings is understood, how fast, and in what noise."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from decimal import Decimal
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from intent_engine.cli.guard import EXIT_INTERRUPTED, EXIT_NOT_ACCEPTED, EXIT_TERMINATED, Terminated, verb
from intent_engine.cli.listening_options import NoNoiseFilter, NoReflex, SecondModel, Wait, waits
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
)
from intent_engine.cli.outputs import check_apart, check_picture, check_table
from intent_engine.cli.terminal import error_block, json_line, note, paragraph, progress, say, table
from intent_engine.errors import ConfigError, Problem
from intent_engine.pauses import avoid_pauses
from intent_engine.resources import find

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine
    from intent_engine.evaluation.hearing import Listener
    from intent_engine.evaluation.labels import Row
    from intent_engine.evaluation.scoring import Outcome, Score
    from intent_engine.speech.endpoint import Settings
    from intent_engine.speech.recognizer import Recognizer
    from intent_engine.speech.reflex import Reflex

__all__ = ["evaluate"]

SHOWN = 12
"""Rows of what went wrong; a CSV file holds all."""
DEFAULT_SNRS = "6,12,24"


@dataclass
class _Run:
    """What was heard so far: all of it, unless Ctrl-C, SIGTERM or an error has ended it."""

    rows: int
    """Recordings of each condition."""
    passes: int
    """How often each is heard: by every model, with the grammar and without."""
    outcomes: list[Outcome] = field(default_factory=list)
    heard: int = 0
    ended_by: KeyboardInterrupt | Terminated | Exception | None = None

    @property
    def interrupted(self) -> bool:
        """Whether it was ended before all was heard."""
        return self.ended_by is not None

    @property
    def code(self) -> int:
        """Of a run that was interrupted."""
        return EXIT_TERMINATED if isinstance(self.ended_by, Terminated) else EXIT_INTERRUPTED

    @property
    def ended(self) -> str:
        """What is said of a run that was interrupted; empty of one that was not."""
        if not self.interrupted:
            return ""
        how = "terminated" if isinstance(self.ended_by, Terminated) else "interrupted"
        if isinstance(self.ended_by, Exception):
            how = "ended by an error"
        if not self.outcomes:
            return f"{how} before anything was measured"
        what = "recordings" if self.passes == 1 else f"hearings ({self.rows} recordings, {self.passes} times each)"
        return f"{how} after {self.heard} of {self.rows * self.passes} {what}"


@verb
def evaluate(
    folder: Annotated[
        Path, typer.Argument(metavar="DIR", help="Folder with audio and labels.jsonl, or a labels file.")
    ],
    grammar: Grammars = None,
    locations: Locations = None,
    robot: Robots = "simulated",
    language: Language = None,
    model: Annotated[
        list[str] | None,
        typer.Option(
            "--model",
            "-m",
            callback=filled,
            help="Whisper model, a name or a folder; may be repeated.",
            show_default="tiny.en; base for other languages",
        ),
    ] = None,
    second_model: SecondModel = None,
    free: Annotated[
        bool, typer.Option("--free", help="Hear with each model without the help of the grammar too, to compare.")
    ] = False,
    no_reflex: NoReflex = False,
    no_noise_filter: NoNoiseFilter = False,
    wait: Wait = None,
    noise: Annotated[
        list[Path] | None,
        typer.Option("--noise", help="Recording of noise to hear everything in, besides as it is; may be repeated."),
    ] = None,
    snr: Annotated[
        str | None,
        typer.Option(
            "--snr",
            callback=filled,
            help="Signal to noise in dB, several with commas.",
            show_default=DEFAULT_SNRS,
        ),
    ] = None,
    no_clean: Annotated[
        bool, typer.Option("--no-clean", help="Hear the recordings in noise alone, not as they are.")
    ] = False,
    state: States = None,
    limit: Annotated[
        int | None, typer.Option("--limit", min=1, help="Hear only so many recordings, spread over the labels.")
    ] = None,
    at_least: Annotated[
        float | None,
        typer.Option(
            "--at-least", min=0, max=100, help="Fail unless so many per cent of commands are right, everywhere."
        ),
    ] = None,
    as_json: Json = False,
    csv: Annotated[Path | None, typer.Option("--csv", help="Write every recording's outcome into this file.")] = None,
    plot: Annotated[
        Path | None, typer.Option("--plot", help="Draw accuracy and latency into this file (PNG, SVG or PDF).")
    ] = None,
) -> int:
    """Measure on labelled recordings how many commands are understood, how fast, and what is done by mistake.

    Slots that a label does not list are not held against it, as they are by test; list those that must be right.
    """
    _needs_jiwer()
    from intent_engine.evaluation.label_files import find_labels, read_labels
    from intent_engine.evaluation.labels import evenly
    from intent_engine.evaluation.sound import Noise, check
    from intent_engine.evaluation.trial import Trial, scores
    from intent_engine.speech.models import usual_model

    snrs = _snrs(snr) if noise else []
    settings = waits(wait)
    _check_noise(noise, snr, no_clean)
    _check_share(at_least)
    if csv is not None:
        check_table(csv, "--csv")
    if plot is not None:
        check_picture(plot, "--plot", "evaluate")
    robot_file = find("robots", robot)
    engine = load_engine(grammar, locations, language)
    states = known_states(engine, state)
    labels = find_labels(folder)
    rows = evenly(read_labels(labels, engine), limit)
    files = [robot_file, labels, *engine.files, *(row.audio for row in rows), *(noise or ())]
    check_apart({"--csv": csv, "--plot": plot}, files)
    check(rows, labels)
    _doubt(rows)
    silent: set[int] = set()
    trial = Trial(
        Noise.read(noise) if noise else None, snrs, clean=not no_clean, doubt=lambda row: _doubt_sound(row, silent)
    )
    models = model or [usual_model(engine.languages, language)]
    run = _Run(len(rows), len(set(models)) * (1 + free))
    with progress("hearing", run.rows * run.passes) as step:
        try:
            for name, recognizer in _recognizers(engine, models, second_model, language, free):
                with contextlib.closing(recognizer):
                    reflex = None if no_reflex else _reflex(engine, language, recognizer)
                    listener = _listener(engine, recognizer, robot_file, settings, reflex, not no_noise_filter, states)
                    avoid_pauses()
                    for found in trial.hear(rows, listener, name):
                        run.outcomes += found
                        run.heard += 1
                        step()
                        if as_json:
                            _tell(found)
        except (KeyboardInterrupt, Terminated) as ending:  # hours of it may be measured already
            # What it was raised through holds models and resamplers, which complain when they outlive the interpreter.
            run.ended_by = ending.with_traceback(None)
        except Exception as error:  # of one recording, as a file that went away meanwhile
            run.ended_by = error
            if not run.outcomes:
                raise
    results = scores(run.outcomes)
    goal = _share(at_least) if at_least is not None else None
    _show(results, run, as_json, all_in=csv)
    if run.outcomes:
        _keep(results, run, csv, plot, goal)
    if isinstance(run.ended_by, Exception):
        note(run.ended)
        failure, run.ended_by = run.ended_by, None
        raise failure
    if run.interrupted:
        error_block(run.ended)
        return run.code
    failed = goal is not None and any(found.accuracy is None or found.accuracy < goal for found in results)
    return EXIT_NOT_ACCEPTED if failed else 0


def _needs_jiwer() -> None:
    try:
        import jiwer  # noqa: F401
    except ImportError:
        hint = "pip install 'intent-engine[evaluate]'"
        raise ConfigError(Problem("evaluate needs jiwer, which is not installed", hint=hint)) from None


def _check_noise(noise: list[Path] | None, snr: str | None, no_clean: bool) -> None:
    """See that there is noise, where an option is about it.

    Raises:
        ConfigError: there is none.
    """
    if snr and not noise:
        raise ConfigError(Problem("--snr without --noise", hint="name a recording of noise: --noise kitchen.wav"))
    if no_clean and not noise:
        raise ConfigError(
            Problem("--no-clean without --noise leaves nothing to hear", hint="name a recording: --noise kitchen.wav")
        )


def _check_share(at_least: float | None) -> None:
    """See that the share of commands that must be right is one in per cent.

    Raises:
        ConfigError: it is none, or probably one of 1.
    """
    if at_least is not None and math.isnan(at_least):  # no accuracy is less than that
        raise ConfigError(Problem("--at-least: nan is no share", hint="give a number from 0 to 100"))
    if at_least is not None and 0 < at_least <= 1:
        hint = f"for {at_least * 100:g} %: --at-least {at_least * 100:g}"
        raise ConfigError(Problem(f"--at-least {at_least:g} is {at_least:g} % of the commands", hint=hint))


def _share(percent: float) -> float:
    """Of so many per cent. The one divided by 100 may be more: 0.9 / 100 of 1000 commands is more than 9 of them."""
    return float(Decimal(str(percent)) / 100)


def _snrs(text: str | None) -> list[float]:
    found = []
    for part in (text or DEFAULT_SNRS).split(","):
        try:
            value = float(part)
        except ValueError:
            value = math.nan
        if not -60 <= value <= 120:
            hint = f"numbers of dB with commas between: --snr {DEFAULT_SNRS}"
            raise ConfigError(Problem(f"--snr: {part.strip()!r} is no signal-to-noise ratio", hint=hint))
        found.append(value)
    return found


def _recognizers(
    engine: IntentEngine, models: list[str], second: str | None, language: str | None, free: bool
) -> Iterator[tuple[str, Recognizer]]:
    """One at a time: a large model fills the memory. That one of them is missing is told before hours of hearing."""
    from intent_engine.speech.free import free_recognizer
    from intent_engine.speech.models import NONE, find_model, recognizer_for, second_model

    for model in models:
        find_model(model)
    for model, name in _names(models).items():
        other = second_model(engine, model, second, language=language)
        label = name if other is None else f"{name}+{Path(other).name}"
        yield label, recognizer_for(engine, model, second=other or NONE, language=language, tell=note)
        if free:
            yield f"{name} free", free_recognizer(model, language=language or engine.languages[0], tell=note)


def _names(models: list[str]) -> dict[str, str]:
    """Each model once, with a short name; in full where two have the same."""
    short = {model: Path(model).name or model for model in models}
    return {model: name if list(short.values()).count(name) == 1 else model for model, name in short.items()}


def _reflex(engine: IntentEngine, language: str | None, beside: Recognizer) -> Reflex:
    from intent_engine.speech.reflex import reflex_for

    return reflex_for(engine, language=language, background=False, beside=beside)


def _listener(
    engine: IntentEngine,
    recognizer: Recognizer,
    robot_file: Path,
    settings: Settings,
    reflex: Reflex | None,
    noise_filter: bool,
    states: tuple[str, ...],
) -> Listener:
    from intent_engine.evaluation.hearing import Listener
    from intent_engine.execution.robots.robot_file import load_robot

    return Listener(
        engine,
        recognizer,
        load_robot(robot_file),
        settings=settings,
        reflex=reflex,
        noise_filter="auto" if noise_filter else None,
        states=states,
    )


def _doubt(rows: list[Row]) -> None:
    """Say which labels can hardly be meant as they are: they count, and nothing that is heard can be right."""
    doubts = [doubt for row in rows for doubt in row.doubts]
    for doubt in doubts[:SHOWN]:
        note(f"warning: {doubt}")
    if len(doubts) > SHOWN:
        note(f"warning: and {len(doubts) - SHOWN} labels more like these")


def _doubt_sound(row: Row, told: set[int]) -> None:
    """Say of a command that nothing can be heard in it, once for all models."""
    if row.line not in told and len(told) < SHOWN:
        note(f"warning: {row.audio} is silent, and cannot be heard as what line {row.line} says")
        note("    listen to it; 16-bit samples in 32 bits are silent, and two channels may cancel each other")
    told.add(row.line)


def _tell(outcomes: list[Outcome]) -> None:
    from intent_engine.evaluation.report import outcome_json

    for outcome in outcomes:
        json_line({"event": "recording", **outcome_json(outcome)})


def _keep(results: list[Score], run: _Run, csv: Path | None, plot: Path | None, goal: float | None) -> None:
    """Write the table and the picture that were asked for, and say so."""
    if csv is not None:
        from intent_engine.evaluation.report import write_csv

        write_csv(csv, run.outcomes)
        note(f"every recording{' that was heard' if run.interrupted else ''} is in {csv}")
    if plot is not None:
        from intent_engine.evaluation.plot import plot_scores

        plot_scores(results, run.outcomes, plot, goal=goal, title=run.ended)
        note(f"accuracy and latency are drawn in {plot}")


def _show(results: list[Score], run: _Run, as_json: bool, all_in: Path | None) -> None:
    from intent_engine.evaluation.report import (
        SCORE_KEYS,
        miss_table,
        misses,
        reflex_text,
        score_table,
    )

    if as_json:
        for found in results:
            json_line({"event": "score", **found.to_json(), "complete": found.recordings == run.rows})
        if run.interrupted:
            json_line({"event": "interrupted", "heard": run.heard, "of": run.rows * run.passes})
        return
    if not results:
        return
    table(f"incomplete: {run.ended}" if run.interrupted else "", *score_table(results), keys=SCORE_KEYS)
    for text in filter(None, map(reflex_text, results)):
        paragraph(text)
    failed = misses(run.outcomes)
    if failed:
        say()
        heads, rows, keys = miss_table(failed[:SHOWN], run.outcomes)
        table("what did not go right", heads, rows, keys=keys, listed=True)
        if len(failed) > SHOWN:
            note(f"and {len(failed) - SHOWN} more" + ("" if all_in else "; --csv FILE writes them all"))
    errors = {error for outcome in run.outcomes for error in outcome.errors}
    for error in sorted(errors):
        note(f"warning: {error}")
