"""The command line: one verb a function; the verbs hold no rules of their own."""

from __future__ import annotations

import logging
import os
import sys
from typing import Annotated

import typer

from intent_engine.cli.guard import DEBUG, EXIT_PIPE_CLOSED, output_lost
from intent_engine.cli.streams import OutputError, prepare, reader_gone
from intent_engine.cli.terminal import LogNotes
from intent_engine.cli.verbs import MARKUP, Verbs

__all__ = ["app", "main"]

app = typer.Typer(
    name="intent-engine",
    cls=Verbs,
    help="A person speaks, a robot does it.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=MARKUP,
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


def main() -> None:
    """What the ``intent-engine`` script runs."""
    prepare()
    if not os.environ.get("COLUMNS", "").strip("0"):  # some editors and containers say 0, and Rich would show nothing
        os.environ.pop("COLUMNS", None)
    try:
        try:
            app()
        finally:
            sys.stdout.flush()
    except SystemExit:
        if reader_gone():  # of the help, which Typer writes and ends in its own way
            sys.exit(EXIT_PIPE_CLOSED)
        raise
    except KeyboardInterrupt:
        sys.exit(130)
    except OutputError as error:
        sys.exit(output_lost(error))
