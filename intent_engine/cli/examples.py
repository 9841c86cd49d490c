"""``intent-engine test``: the examples of grammar files, and test files."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from intent_engine.cli.guard import EXIT_NOT_ACCEPTED, verb
from intent_engine.cli.options import Json, Locations, NamedToo
from intent_engine.cli.terminal import json_line, note, say, table
from intent_engine.resources import find

if TYPE_CHECKING:
    from intent_engine.testing.examples import Outcome

__all__ = ["run_examples"]


@verb
def run_examples(
    files: Annotated[
        list[str] | None,
        typer.Argument(help="Grammar files, names of shipped ones, or test files (*.intents.yaml).", show_default="en"),
    ] = None,
    named: NamedToo = None,
    locations: Locations = None,
    as_json: Json = False,
) -> int:
    """Run the examples that stand in grammar files, and the sentences of test files.

    Slots are compared all together: one that comes out and that an example does not name is a failure.
    """
    from intent_engine.testing.examples import load_examples, run_case

    maps = [find("locations", name) for name in locations or ()]
    loaded = [load_examples(find("grammars", name), maps) for name in [*(files or ()), *(named or ())] or ["en"]]
    outcomes = []
    for outcome, file in ((run_case(one.engine, case), one.file) for one in loaded for case in one.cases):
        outcomes.append((outcome, file))
        if as_json:
            json_line(_record(outcome, file))
    failed = [(outcome, file) for outcome, file in outcomes if outcome.failed]
    missing = sorted({name for outcome, _ in outcomes for name in outcome.missing})
    if not as_json:
        if failed:
            rows = [row for outcome, file in failed for row in _rows(outcome, file)]
            table("", ("where", "sentence", "part", "expected", "found"), rows, keys=2, listed=True)
        style = "red" if failed else "green"
        passed = sum(outcome.passed for outcome, _ in outcomes)
        left = len(outcomes) - passed - len(failed)
        rest = f", {left} not tried" if left else ""
        count = f"{len(outcomes)} example{'s' * (len(outcomes) != 1)}"
        say(f"{count}: {passed} passed, {len(failed)} failed{rest}", style)
    if missing:
        note(f"not tried are examples of places that the map has not: {', '.join(missing)}; --locations names another")
    if not outcomes:
        note("there are none: in a grammar they are examples: of an intent, in a test file tests:")
    return EXIT_NOT_ACCEPTED if failed else 0


def _where(outcome: Outcome, file: Path) -> str:
    place = outcome.case.place
    return f"{file}:{place.line}" if place is not None else str(file)


def _rows(outcome: Outcome, file: Path) -> Iterator[tuple[str, str, str, str, str]]:
    head = (_where(outcome, file), outcome.case.text)
    for row in outcome.differences:
        yield (*head, row.part, row.expected, row.found)
        head = ("", "")


def _record(outcome: Outcome, file: Path) -> dict[str, object]:
    place = outcome.case.place
    return {
        "file": str(file),
        "line": place.line if place is not None else None,
        "text": outcome.case.text,
        "passed": outcome.passed,
        "missing": list(outcome.missing),
        "differences": [
            {"part": row.part, "expected": row.expected, "found": row.found} for row in outcome.differences
        ],
        "found": outcome.found.to_json(),
    }
