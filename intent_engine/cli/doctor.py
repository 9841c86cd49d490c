"""``intent-engine doctor``: does this machine have what speech needs?"""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Annotated

import typer

from intent_engine.cli.guard import EXIT_NOT_ACCEPTED, verb
from intent_engine.cli.options import Device, Json, filled
from intent_engine.cli.terminal import json_line, level_meter, note, say

if TYPE_CHECKING:
    from intent_engine.speech.doctor import Check

__all__ = ["doctor"]

_STYLES = {"ok": "green", "warning": "yellow", "missing": "bold red"}


@verb
def doctor(
    model: Annotated[
        str, typer.Option("--model", "-m", callback=filled, help="Whisper model: a name or a folder.")
    ] = "tiny.en",
    device: Device = None,
    no_microphone: Annotated[
        bool, typer.Option("--no-microphone", help="Leave the microphone out: this machine only plays recordings.")
    ] = False,
    as_json: Json = False,
) -> int:
    """Look at everything that speech needs on this machine, and say what to do about what is missing.

    Speak while the level of the microphone is measured, for two seconds. The exit code is 1 when something needed is
    missing.
    """
    from intent_engine.speech.doctor import Verdict, examine

    found: list[Check] = []
    with _meter(shown=not as_json) as on_level:
        for check in examine(model, microphone=not no_microphone, device=device, on_level=on_level):
            found.append(check)
            if not as_json:
                _show(check)
                if check.name == "microphones" and check.verdict is Verdict.OK:
                    note("say something: the level of the microphone is measured for two seconds")
    missing = [check.name for check in found if check.verdict is Verdict.MISSING]
    if as_json:
        json_line({"ok": not missing, "checks": [check.to_json() for check in found]})
    elif missing:
        say(f"missing: {', '.join(missing)}", "bold red")
    else:
        say("everything needed is there", "green")
    return EXIT_NOT_ACCEPTED if missing else 0


def _show(check: Check) -> None:
    say(f"{check.verdict.value:<8} {check.name:<15} {check.found}", _STYLES[check.verdict.value])
    if check.advice:
        say(f"{'':<8} {'':<15} -> {check.advice}")


@contextlib.contextmanager
def _meter(*, shown: bool) -> Iterator[Callable[[float], None] | None]:
    """A level meter on standard error, where that is a terminal."""
    if not shown or not sys.stderr.isatty():
        yield None
        return
    with level_meter("level") as move:
        yield move
