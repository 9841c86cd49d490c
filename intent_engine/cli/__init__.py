"""The command line: one verb a function; the verbs hold no rules of their own."""

from __future__ import annotations

import io
import logging
import os
import sys
from typing import Annotated

import typer

from intent_engine.cli.check import check
from intent_engine.cli.complete import complete
from intent_engine.cli.doctor import doctor
from intent_engine.cli.drill import drill
from intent_engine.cli.evaluate import evaluate
from intent_engine.cli.examples import run_examples
from intent_engine.cli.guard import DEBUG
from intent_engine.cli.listening import listen, run
from intent_engine.cli.parse import parse
from intent_engine.cli.sample import sample
from intent_engine.cli.terminal import LogNotes

__all__ = ["app", "main"]

app = typer.Typer(
    name="intent-engine",
    help="A person speaks, a robot does it.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode="rich",
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog="Exit codes: 0 done, 1 not accepted or failed, 2 wrong options or files, 3 audio, 4 microphone, 5 model "
    "weights, 6 robot, 7 text too long, 70 a fault of the program, 130 Ctrl-C, 143 terminated.",
)


def _version(wanted: bool) -> None:
    if wanted:
        from importlib import metadata

        typer.echo(f"intent-engine {metadata.version('intent-engine')}")
        raise typer.Exit


@app.callback()
def _common(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and exit.")
    ] = False,
    debug: Annotated[bool, typer.Option("--debug", envvar=DEBUG, help="Show tracebacks of errors.")] = False,
) -> None:
    if debug:
        os.environ[DEBUG] = "1"
        logging.basicConfig(level=logging.DEBUG)
    else:
        logging.getLogger("intent_engine").addHandler(LogNotes(logging.WARNING))


_DRIVE = "Speak to a robot"
_UNDERSTAND = "Understand text"

app.command(
    epilog="Examples:\n\nintent-engine run examples/demo.flac\n\n"
    "intent-engine run --plot way.png recording.wav\n\nintent-engine run --json recording.wav | jq .event",
    rich_help_panel=_DRIVE,
)(run)

app.command(
    epilog="Examples:\n\nintent-engine listen\n\nintent-engine listen --device headset --wake-word robot\n\n"
    "intent-engine listen --push-to-talk --no-reflex\n\nintent-engine listen --list-devices\n\n"
    "arecord -f S16_LE -r 16000 -t raw | intent-engine listen --pcm -",
    rich_help_panel=_DRIVE,
)(listen)

app.command(
    epilog='Examples:\n\nintent-engine parse "go to the kitchen"\n\n'
    'intent-engine parse --json "turn left ninety degrees"\n\n'
    'intent-engine parse --explain "go to the kitchen I mean the bedroom"\n\nintent-engine parse - < sentences.txt',
    rich_help_panel=_UNDERSTAND,
)(parse)

app.command(
    epilog='Examples:\n\nintent-engine complete "go to the"\n\nintent-engine complete --json "turn left n"',
    rich_help_panel=_UNDERSTAND,
)(complete)

app.command(
    epilog="Examples:\n\nintent-engine sample\n\nintent-engine sample -n 5 --intent turn --seed 7\n\n"
    "intent-engine sample --grammar my_grammar.yaml --json > sentences.jsonl",
    rich_help_panel=_UNDERSTAND,
)(sample)

_TRUST = "Measure and trust"

app.command(
    epilog="Examples:\n\nintent-engine check my_grammar.yaml\n\n"
    "intent-engine check --strict --locations warehouse en my_grammar.yaml\n\n"
    "intent-engine check --json | jq .figures",
    rich_help_panel=_TRUST,
)(check)

app.command(
    "test",
    epilog="Examples:\n\nintent-engine test my_grammar.yaml\n\n"
    "intent-engine test --locations warehouse my_grammar.yaml tests/doors.intents.yaml\n\n"
    "intent-engine test --json | jq 'select(.passed | not)'",
    rich_help_panel=_TRUST,
)(run_examples)

app.command(
    epilog="Examples:\n\nintent-engine evaluate examples/ten_commands\n\n"
    "intent-engine evaluate recordings -m tiny.en -m base --noise kitchen.wav --snr 6,12,24 --plot out/speech.png",
    rich_help_panel=_TRUST,
)(evaluate)

app.command(
    epilog="Examples:\n\nintent-engine drill\n\nintent-engine drill --quick --robot turtlebot3\n\n"
    "intent-engine drill --json | jq .passed",
    rich_help_panel=_TRUST,
)(drill)

app.command(
    epilog="Examples:\n\nintent-engine doctor\n\nintent-engine doctor --model base --device headset\n\n"
    "intent-engine doctor --no-microphone --json | jq .ok",
    rich_help_panel=_TRUST,
)(doctor)


def main() -> None:
    """What the ``intent-engine`` script runs."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # a name with odd bytes is shown, not raised about
    try:
        app()
    except KeyboardInterrupt:
        sys.exit(130)
