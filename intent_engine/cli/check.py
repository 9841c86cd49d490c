"""``intent-engine check``: what is wrong or doubtful in grammar files, and how large they are."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from intent_engine.cli.guard import EXIT_NOT_ACCEPTED, verb
from intent_engine.cli.options import Json, Locations, NamedToo
from intent_engine.cli.terminal import json_line, say, working
from intent_engine.errors import ConfigError
from intent_engine.resources import default_locations, find

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine
    from intent_engine.language.checker import Figures, Finding, Report

__all__ = ["check"]

_STYLES = {"error": "red", "warning": "yellow", "note": "dim"}


@verb
def check(
    grammars: Annotated[
        list[str] | None, typer.Argument(help="Grammar files, or names of shipped ones.", show_default="en")
    ] = None,
    named: NamedToo = None,
    locations: Locations = None,
    together: Annotated[
        bool, typer.Option("--together", help="Take the files as one grammar, not each for itself.")
    ] = False,
    strict: Annotated[bool, typer.Option("--strict", help="Fail on warnings too.")] = False,
    notes: Annotated[
        bool,
        typer.Option(
            "--notes",
            help="Also tell of sentences that meet, though it is clear which one wins, and of what slots take.",
        ),
    ] = False,
    as_json: Json = False,
) -> int:
    """Tell what is wrong or doubtful in grammar files: sentences that meet or are never understood, examples that
    fail, names that sound alike; and how large and how ambiguous the grammars are.
    """
    names = [*(grammars or ()), *(named or ())] or ["en"]
    given = [find("locations", name) for name in locations or ()]
    count: Counter[str] = Counter()
    untried = 0
    elsewhere: Counter[str] = Counter()
    for group in [names] if together else [[name] for name in names]:
        paths = [find("grammars", name) for name in group]
        maps = given or default_locations(paths)
        found, reports = _checked(paths, maps)
        if not given:  # which map it is for was not said
            found = [replace(one, level="note") if one.topic == "place" else one for one in found]
            elsewhere[" and ".join(one.stem for one in maps)] += sum(one.topic == "place" for one in found)
        count.update(finding.level for finding in found)
        untried += sum((finding.topic, finding.level) == ("example", "note") for finding in found)
        if as_json:
            json_line(_record(group, found, reports))
        else:
            _show(group, found, reports, notes=notes)
    failed = count["error"] + (count["warning"] if strict else 0)
    if not as_json:
        rest = f"; --notes tells {_many(count['note'], 'note')}" if count["note"] and not notes else ""
        left = f", {_many(untried, 'example')} of other places not tried" if untried else ""
        away = "".join(
            f", {_many(places, 'place')} not on the map {name}" for name, places in elsewhere.items() if places
        )
        away += " (--locations FILE is yours)" if away else ""
        summary = f"{_many(count['error'], 'error')}, {_many(count['warning'], 'warning')}{left}{away}{rest}"
        say(summary, "red" if failed else "yellow" if count["warning"] else "green")
    return EXIT_NOT_ACCEPTED if failed else 0


def _checked(paths: Sequence[Path], maps: Sequence[Path]) -> tuple[list[Finding], list[Report]]:
    """What is found in files that are taken as one grammar, worst first."""
    from intent_engine.engine import IntentEngine
    from intent_engine.language.checker import Finding, check_grammar

    try:
        engine = IntentEngine.from_files(list(paths), locations=list(maps))
        with working("checking"):
            reports = [check_grammar(grammar, engine.locations) for grammar in engine.grammars]
    except ConfigError as error:
        if not all(path.is_file() for path in (*paths, *maps)):
            raise  # there is nothing to be checked
        return [Finding("error", "file", problem) for problem in error.problems], []
    found = dict.fromkeys([*_examples(engine), *(finding for report in reports for finding in report.findings)])
    return sorted(found, key=lambda finding: [*_STYLES].index(finding.level)), reports


def _examples(engine: IntentEngine) -> Iterator[Finding]:
    """Examples of the grammar that are understood otherwise, and those that are of another map."""
    from intent_engine.language.checker import Finding
    from intent_engine.language.grammar import problem_at
    from intent_engine.testing.examples import grammar_cases, run_case

    for case in grammar_cases(engine):
        outcome = run_case(engine, case)
        if outcome.missing:
            named = " or ".join(map(repr, outcome.missing))
            message = f"the example {case.text!r} was not tried: no place of the map is called {named}"
            yield Finding("note", "example", problem_at(case.place, message, "give the map that it is written for"))
        elif outcome.failed:
            differences = "; ".join(
                f"{row.part} should be {row.expected}, is {row.found}" for row in outcome.differences
            )
            message = f"the example {case.text!r} fails: {differences}"
            hint = "change the example or the sentences; parse --explain shows how it is understood"
            yield Finding("error", "example", problem_at(case.place, message, hint))


def _record(names: Sequence[str], found: Sequence[Finding], reports: Sequence[Report]) -> dict[str, Any]:
    return {
        "grammars": list(names),
        "ok": not any(finding.level == "error" for finding in found),
        "findings": [finding.to_json() for finding in found],
        "figures": [{"language": report.language, **report.figures.to_json()} for report in reports],
    }


def _show(names: Sequence[str], found: Sequence[Finding], reports: Sequence[Report], *, notes: bool) -> None:
    for finding in found:
        if finding.level != "note" or notes:
            first, *rest = str(finding.problem).splitlines()
            say(f"{finding.level}: {first}", _STYLES[finding.level])
            for line in rest:
                say(line)
    for report in reports:
        say(f"{' '.join(names)} ({report.language})", "bold")
        for line in _figures(report.figures):
            say(f"  {line}")


def _figures(figures: Figures) -> Iterator[str]:
    size = figures.size
    patterns = f", {_many(size.patterns, 'pattern')}" if size.patterns else ""
    said = f"{_many(size.sentences, 'sentence')}{patterns}"
    places = f", {_many(size.names, 'name')} of places" if size.names else ""
    yield f"{_many(size.intents, 'intent')}, {said}{places}"
    ways, spoken = _large(size.ways), _large(size.spoken)
    yield f"{ways} ways to say them, {spoken} with the values of lists and names; at most {size.longest} words"
    yield f"{figures.states:,} states and {figures.arcs:,} arcs, walked as {figures.word_states:,} sets of states"
    whole = "" if figures.complete else " (not all were walked: it is too large)"
    shared = f"{figures.shared:,} in several intents, {figures.ambiguous:,} ambiguous"
    yield f"{figures.endings:,} kinds of sentences, {shared}; at most {figures.widest} ways to go on{whole}"


def _many(count: int, what: str) -> str:
    return f"{count:,} {what}{'s' * (count != 1)}"


def _large(count: int) -> str:
    return f"{count:,}" if count < 10**12 else f"about 10^{len(str(count)) - 1}"
