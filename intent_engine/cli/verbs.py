"""The verbs of the command line, each loaded when it is asked for: one that reads text never waits for the others."""

from __future__ import annotations

import functools
import sys
from collections.abc import Iterator, MutableMapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Any, Final

import typer
from typer.core import TyperGroup
from typer.main import get_command

from intent_engine.cli.terminal import error_block
from intent_engine.cli.usage import UsageError, usage_problem
from intent_engine.errors import ConfigError, Problem
from intent_engine.hints import did_you_mean

__all__ = ["VERBS", "Verb", "Verbs"]

MARKUP: Final = "rich"
_DRIVE = "Speak to a robot"
_UNDERSTAND = "Understand text"
_TRUST = "Measure and trust"


@dataclass(frozen=True)
class Verb:
    """Where a verb is, and how the help shows it."""

    module: str
    """In this package."""
    function: str
    """In the module."""
    panel: str
    """Of the help: the heading it is listed under."""
    examples: tuple[str, ...]
    """Whole command lines, shown at the end of its own help."""


VERBS = {
    "run": Verb(
        "listening",
        "run",
        _DRIVE,
        (
            "intent-engine run examples/demo.flac",
            "intent-engine run --plot way.png recording.wav",
            "intent-engine run --json recording.wav | jq .event",
        ),
    ),
    "listen": Verb(
        "listening",
        "listen",
        _DRIVE,
        (
            "intent-engine listen",
            "intent-engine listen --device headset --wake-word robot",
            "intent-engine listen --push-to-talk --no-reflex",
            "intent-engine listen --list-devices",
            "arecord -f S16_LE -r 16000 -t raw | intent-engine listen --pcm -",
            "intent-engine listen --drive >(python robot.py)",
        ),
    ),
    "parse": Verb(
        "parse",
        "parse",
        _UNDERSTAND,
        (
            'intent-engine parse "go to the kitchen"',
            'intent-engine parse --json "turn left ninety degrees"',
            'intent-engine parse --explain "go to the kitchen I mean the bedroom"',
            "intent-engine parse - < sentences.txt",
        ),
    ),
    "complete": Verb(
        "complete",
        "complete",
        _UNDERSTAND,
        ('intent-engine complete "go to the"', 'intent-engine complete --json "turn left n"'),
    ),
    "sample": Verb(
        "sample",
        "sample",
        _UNDERSTAND,
        (
            "intent-engine sample",
            "intent-engine sample -n 5 --intent turn --seed 7",
            "intent-engine sample --grammar my_grammar.yaml --json > sentences.jsonl",
        ),
    ),
    "check": Verb(
        "check",
        "check",
        _TRUST,
        (
            "intent-engine check my_grammar.yaml",
            "intent-engine check --strict --locations warehouse my_grammar.yaml",
            "intent-engine check --json | jq .figures",
        ),
    ),
    "test": Verb(
        "examples",
        "run_examples",
        _TRUST,
        (
            "intent-engine test my_grammar.yaml",
            "intent-engine test --locations warehouse my_grammar.yaml tests/doors.intents.yaml",
            "intent-engine test --json | jq 'select(.passed | not)'",
        ),
    ),
    "evaluate": Verb(
        "evaluate",
        "evaluate",
        _TRUST,
        (
            "intent-engine evaluate examples/ten_commands",
            "intent-engine evaluate recordings -m tiny.en -m base --noise kitchen.wav --snr 6,12,24 "
            "--plot out/speech.png",
        ),
    ),
    "drill": Verb(
        "drill",
        "drill",
        _TRUST,
        (
            "intent-engine drill",
            "intent-engine drill --quick --robot turtlebot3",
            "intent-engine drill --json | jq .passed",
        ),
    ),
    "doctor": Verb(
        "doctor",
        "doctor",
        _TRUST,
        (
            "intent-engine doctor",
            "intent-engine doctor --model base --device headset",
            "intent-engine doctor --no-microphone --json | jq .ok",
        ),
    ),
}
"""In the order of the help."""


class _Commands(MutableMapping[str, Any]):
    """Name -> command, made at the first question."""

    def __init__(self) -> None:
        self._made: dict[str, Any] = {}

    def __getitem__(self, name: str) -> Any:
        if name not in self._made:
            self._made[name] = _command(name, VERBS[name])
        return self._made[name]

    def __setitem__(self, name: str, command: Any) -> None:
        self._made[name] = command

    def __delitem__(self, name: str) -> None:
        del self._made[name]

    def __iter__(self) -> Iterator[str]:
        return iter({**VERBS, **self._made})

    def __len__(self) -> int:
        return len({**VERBS, **self._made})


def _command(name: str, verb: Verb) -> Any:
    function = getattr(import_module(f"intent_engine.cli.{verb.module}"), verb.function)
    alone = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=MARKUP)
    alone.command(name, epilog="\n\n".join(("Examples:", *verb.examples)), rich_help_panel=verb.panel)(function)
    return get_command(alone)


class Verbs(TyperGroup):
    """The group of all verbs."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings)
        self.commands = _Commands()
        self._asked = ""
        """The verb of the command line that is run."""

    def list_commands(self, ctx: Any) -> list[str]:
        return list(self.commands)

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        if args and not args[0].startswith("-") and args[0] not in self.commands:
            asked = "intent-engine --help tells of all verbs" if args[0] == "help" else None
            hint = asked or did_you_mean(args[0], self.commands) or f"there is {', '.join(self.commands)}"
            raise ConfigError(Problem(f"there is no verb {args[0]!r}", hint=hint))
        self._asked = args[0] if args else ""
        return super().resolve_command(ctx, args)

    def main(
        self,
        args: Sequence[str] | None = None,
        prog_name: str | None = None,
        complete_var: str | None = None,
        standalone_mode: bool = True,
        windows_expand_args: bool = True,
        **settings: Any,
    ) -> Any:
        """Run a command line; what is wrong with it is told as every other error is, not as Typer would."""
        run = functools.partial(
            super().main, args, prog_name, complete_var, False, windows_expand_args=windows_expand_args, **settings
        )
        if not standalone_mode:
            return run()
        self._asked = ""
        try:
            code = run()
        except ConfigError as error:
            error_block(str(error))
            code = error.exit_code
        except UsageError as error:
            verb = VERBS.get(self._asked)
            problem = usage_problem(error, self._asked, verb.examples[0] if verb is not None else "")
            if problem is not None:
                error_block(str(problem))
            code = ConfigError.exit_code
        sys.exit(code if isinstance(code, int) else 0)
