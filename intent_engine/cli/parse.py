"""``intent-engine parse``: text to its meaning, without audio or a robot."""

from __future__ import annotations

import codecs
import os
import shlex
import sys
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Annotated, Any, BinaryIO

import typer

from intent_engine.cli.describe import interpretation_lines
from intent_engine.cli.explaining import explanation_lines
from intent_engine.cli.guard import EXIT_NOT_ACCEPTED, verb
from intent_engine.cli.options import (
    Grammars,
    Json,
    Language,
    Locations,
    States,
    known_states,
    load_engine,
    tell_doubts,
)
from intent_engine.cli.terminal import json_line, note, say
from intent_engine.cli.typed import MAX_TEXT, check_length, readable, too_long
from intent_engine.cli.watching import Watch, watched
from intent_engine.errors import ConfigError, Problem
from intent_engine.interpretation import Interpretation, Status

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = ["parse"]


@verb
def parse(
    text: Annotated[str, typer.Argument(help="What was said; - reads one sentence a line from standard input.")],
    grammar: Grammars = None,
    locations: Locations = None,
    language: Language = None,
    state: States = None,
    explain: Annotated[bool, typer.Option("--explain", help="Show every step from the words to the actions.")] = False,
    watch: Watch = False,
    as_json: Json = False,
) -> int:
    """Say what a sentence means, and which actions it gives. No audio is touched and nothing moves."""
    engine = load_engine(grammar, locations, language)
    tell_doubts(engine, grammar)
    states = known_states(engine, state)
    if text == "-":
        with watched(engine, grammar, watch):
            return _parse_lines(engine, states, language, explain)
    if watch:
        hint = "leave it out, or read from there: intent-engine parse --watch -"
        raise ConfigError(Problem("--watch is for sentences from standard input", hint=hint))
    text = readable(text)
    check_length(text)
    if as_json:
        found, data = _understood(engine, text, states, language, explain)
        json_line(data)
    elif explain:
        explanation = engine.explain(text, state=states, language=language)
        found = explanation.interpretation
        _show(explanation_lines(explanation))
    else:
        found = engine.parse(text, state=states, language=language)
        _show(interpretation_lines(found))
    if found.status is Status.ACCEPTED:
        return 0
    if os.path.isfile(text):  # noqa: PTH113 - of a text that can be no path too
        note(f"{text} is a file; for the sentences in it, one a line: intent-engine parse - < {shlex.quote(text)}")
    return EXIT_NOT_ACCEPTED


def _parse_lines(engine: IntentEngine, states: tuple[str, ...], language: str | None, explain: bool) -> int:
    if sys.stdin is None:
        hint = "give it sentences: intent-engine parse - < sentences.txt"
        raise ConfigError(Problem("standard input is closed", hint=hint))
    accepted, number, overlong, odd = True, 0, 0, 0
    for number, (line, is_text) in enumerate(_lines(sys.stdin.buffer), start=1):
        found, data = _understood(engine, line[:MAX_TEXT], states, language, explain)
        json_line(data)
        accepted = accepted and found.status is Status.ACCEPTED
        overlong = overlong or (number if len(line) > MAX_TEXT else 0)
        odd = odd or (0 if is_text else number)
    if odd:
        note(f"line {odd} of standard input is not UTF-8 text: save the sentences as UTF-8")
    if not number:
        note("standard input is empty: no sentence was given")
    if overlong:
        raise too_long(f"line {overlong} of standard input")
    return 0 if accepted and number else EXIT_NOT_ACCEPTED


def _understood(
    engine: IntentEngine, text: str, states: tuple[str, ...], language: str | None, explain: bool
) -> tuple[Interpretation, dict[str, Any]]:
    if explain:
        explanation = engine.explain(text, state=states, language=language)
        return explanation.interpretation, explanation.to_json()
    found = engine.parse(text, state=states, language=language)
    return found, found.to_json()


def _show(lines: Iterable[tuple[str, str | None]]) -> None:
    for line, style in lines:
        say(line, style)


def _lines(stream: BinaryIO) -> Iterator[tuple[str, bool]]:
    """Lines of any bytes as text, and whether they are UTF-8. A line without end is read to its end, but only its
    beginning is kept. The mark that some editors put before UTF-8 is no part of what was said."""
    mark = codecs.BOM_UTF8
    limit = 4 * (MAX_TEXT + 1)  # bytes; UTF-8 needs at most 4 for a character
    while line := stream.readline(limit):
        rest = line
        while not rest.endswith(b"\n") and (rest := stream.readline(limit)):
            pass
        line = line.removeprefix(mark)
        mark = b""
        try:
            yield line.decode("utf-8").strip(), True
        except UnicodeDecodeError:
            cut = len(line) >= MAX_TEXT and not line.endswith(b"\n")  # perhaps within a character
            yield line.decode("utf-8", errors="replace").strip(), cut
