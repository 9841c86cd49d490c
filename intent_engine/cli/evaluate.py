"""``intent-engine evaluate``: how well a folder of recordings is understood, how fast, and in what noise."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from intent_engine.cli.guard import EXIT_NOT_ACCEPTED, verb
from intent_engine.cli.listening_options import NoNoiseFilter, NoReflex, SecondModel, Wait, waits
from intent_engine.cli.options import Grammars, Json, Language, Locations, Robots, load_engine
from intent_engine.cli.outputs import check_file, check_picture
from intent_engine.cli.terminal import json_line, note, progress, say, table
from intent_engine.errors import ConfigError, IntentEngineError, Problem
from intent_engine.pauses import avoid_pauses
from intent_engine.resources import find

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine
    from intent_engine.evaluation.hearing import Listener
    from intent_engine.evaluation.scoring import Outcome, Score
    from intent_engine.speech.endpoint import Settings
    from intent_engine.speech.recognizer import Recognizer
    from intent_engine.speech.reflex import Reflex

__all__ = ["evaluate"]

SHOWN = 12
"""Rows of what went wrong; a CSV file holds all."""
DEFAULT_SNRS = "6,12,24"


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
        list[Path] | None, typer.Option("--noise", help="Recording of noise to mix in; may be repeated.")
    ] = None,
    snr: Annotated[
        str | None,
        typer.Option("--snr", help="Signal to noise in dB, several with commas.", show_default=DEFAULT_SNRS),
    ] = None,
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
    """Measure on labelled recordings how many commands are understood, how fast, and what is done by mistake."""
    _needs_jiwer()
    from intent_engine.evaluation.labels import evenly, find_labels, read_labels
    from intent_engine.evaluation.sound import Noise, check
    from intent_engine.evaluation.trial import Trial, scores
    from intent_engine.speech.models import usual_model

    snrs = _snrs(snr) if noise else []
    settings = waits(wait)
    if snr and not noise:
        raise ConfigError(Problem("--snr without --noise", hint="name a recording of noise: --noise kitchen.wav"))
    if csv is not None:
        check_file(csv, "--csv")
    if plot is not None:
        check_picture(plot, "--plot", "evaluate")
    engine = load_engine(grammar, locations, language)
    labels = find_labels(folder)
    rows = evenly(read_labels(labels, engine), limit)
    check(rows, labels)
    trial = Trial(Noise.read(noise) if noise else None, snrs)
    models = model or [usual_model(engine.languages, language)]
    outcomes: list[Outcome] = []
    with progress("hearing", len(rows) * len(set(models)) * (1 + free)) as step:
        for name, recognizer in _recognizers(engine, models, second_model, language, free):
            reflex = None if no_reflex else _reflex(engine, language, recognizer)
            listener = _listener(engine, recognizer, robot, settings, reflex, not no_noise_filter)
            avoid_pauses()
            for found in trial.hear(rows, listener, name):
                outcomes += found
                step()
                if as_json:
                    _tell(found)
            recognizer.close()
    results = scores(outcomes)
    _show(results, outcomes, as_json, all_in=csv)
    if csv is not None:
        from intent_engine.evaluation.report import write_csv

        write_csv(csv, outcomes)
        note(f"every recording is in {csv}")
    goal = at_least / 100 if at_least is not None else None
    if plot is not None:
        from intent_engine.evaluation.plot import plot_scores

        plot_scores(results, outcomes, plot, goal=goal)
        note(f"accuracy and latency are drawn in {plot}")
    failed = goal is not None and any(found.accuracy is None or found.accuracy < goal for found in results)
    return EXIT_NOT_ACCEPTED if failed else 0


def _needs_jiwer() -> None:
    try:
        import jiwer  # noqa: F401
    except ImportError:
        raise IntentEngineError("evaluate needs jiwer\n    pip install 'intent-engine[evaluate]'") from None


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
    """One at a time: a large model fills the memory."""
    from intent_engine.speech.free import free_recognizer
    from intent_engine.speech.models import NONE, recognizer_for, second_model

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
    robot: str,
    settings: Settings,
    reflex: Reflex | None,
    noise_filter: bool,
) -> Listener:
    from intent_engine.evaluation.hearing import Listener
    from intent_engine.execution.robots.robot_file import load_robot

    return Listener(
        engine,
        recognizer,
        load_robot(find("robots", robot)),
        settings=settings,
        reflex=reflex,
        noise_filter="auto" if noise_filter else None,
    )


def _tell(outcomes: list[Outcome]) -> None:
    from intent_engine.evaluation.report import outcome_json

    for outcome in outcomes:
        json_line({"event": "recording", **outcome_json(outcome)})


def _show(results: list[Score], outcomes: list[Outcome], as_json: bool, all_in: Path | None) -> None:
    from intent_engine.evaluation.report import MISS_COLUMNS, miss_cells, misses, reflex_text, score_table

    if as_json:
        for found in results:
            json_line({"event": "score", **found.to_json()})
        return
    table("", *score_table(results))
    for text in filter(None, map(reflex_text, results)):
        say(text)
    failed = misses(outcomes)
    if failed:
        say()
        table("what did not go right", MISS_COLUMNS, map(miss_cells, failed[:SHOWN]))
        if len(failed) > SHOWN:
            note(f"and {len(failed) - SHOWN} more" + ("" if all_in else "; --csv FILE writes them all"))
    errors = {error for outcome in outcomes for error in outcome.errors}
    for error in sorted(errors):
        note(f"warning: {error}")
