"""Run the benchmarks, merge their rows into ``results.json``, and write ``docs/benchmarks.md`` from it.

Every module of this folder with a function ``run(quick: bool)`` is a benchmark. It gives a list of rows, or a
:class:`~benchmarks.report.Report`: rows, tables and plots; or an iterator of these, so that each part is kept as soon
as it was measured, whatever becomes of the others. What an unfinished benchmark did not come to stays as it was
measured before. A row has these keys:

``figure``      what was measured, in words
``value``       the number (the smaller the better, unless the words say otherwise)
``unit``        its unit
``peer``        what it is compared with, measured in the same run; None if there is nothing
``peer_value``  the peer's number, in the same unit
``ratio``       ``peer_value / value``: how many times better than the peer
``spread``      [low, high] of the value over the runs, or None
``runs``        how many
``command``     how to repeat it
"""

from __future__ import annotations

import argparse
import importlib
import importlib.util
import json
import os
import platform
import signal
import sys
import time
import traceback
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from benchmarks.report import Report, draw, markdown

HERE = Path(__file__).resolve().parent
RESULTS = HERE / "results.json"
PAGE = HERE.parent / "docs" / "benchmarks.md"
KEYS = ("figure", "value", "unit", "peer", "peer_value", "ratio", "spread", "runs", "command")

HEAD = """# Benchmarks

Written by `make bench` from `benchmarks/results.json`; do not edit. Each figure stands beside its peer, measured in the
same run on the same machine, because a ratio travels further than a time. *Better* is peer divided by value.
"""


def modules() -> list[str]:
    """Names of the benchmarks, in alphabetical order."""
    names = sorted(path.stem for path in HERE.glob("*.py") if not path.stem.startswith("_"))
    return [name for name in names if "def run(" in (HERE / f"{name}.py").read_text("utf-8")]


def machine() -> dict[str, Any]:
    """What the figures were measured on, as far as it matters."""
    model = ""
    info = Path("/proc/cpuinfo")
    if info.exists():
        lines = [
            line.split(":", 1)[1].strip() for line in info.read_text().splitlines() if line.startswith("model name")
        ]
        model = lines[0] if lines else ""
    return {
        "processor": model or platform.processor(),
        "cores": os.cpu_count(),
        "system": platform.system(),
        "python": platform.python_version(),
    }


def checked(name: str, rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The rows, if each has what it needs.

    Raises:
        ValueError: a row is wrong; the module's mistake.
    """
    for row in rows:
        wrong = set(row) ^ set(KEYS)
        if wrong:
            raise ValueError(f"{name}: a row has wrong keys {sorted(wrong)}: {row.get('figure')}")
    day = time.strftime("%Y-%m-%d", time.gmtime())
    return [{"module": name, **row, "measured": day, "machine": machine()} for row in rows]


def merge(old: dict[str, Any], name: str, report: Report, quick: bool, *, whole: bool = True) -> dict[str, Any]:
    """Replace what one module found and leave that of the others; not ``whole``: also what it has not come to."""
    tables, plots = report.extras(name)
    fresh = {"rows": [{**row, "quick": quick} for row in report.rows], "tables": tables, "plots": plots}
    merged = {}
    for kind, found in fresh.items():
        mine = [one for one in old.get(kind, []) if one["module"] == name]
        others = [one for one in old.get(kind, []) if one["module"] != name]
        again = {_identity(one) for one in found}
        earlier = [] if whole else [one for one in mine if _identity(one) not in again]
        merged[kind] = sorted([*others, *found, *earlier], key=lambda one: str(one["module"]))
    return merged


def _identity(one: dict[str, Any]) -> tuple[Any, ...]:
    """What a row, table or plot is about, whatever was measured."""
    return tuple(one.get(key) for key in ("figure", "peer", "title"))


def number(value: Any) -> str:
    """A number with three digits that mean something."""
    if value is None:
        return ""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return f"{value:,.0f}" if float(value).is_integer() or abs(value) >= 1000 else f"{value:.3g}"
    return str(value)


def spread(row: dict[str, Any]) -> str:
    return " .. ".join(number(value) for value in row["spread"]) if row["spread"] else ""


def cells(row: dict[str, Any]) -> list[str]:
    """A row of the table."""
    return [
        row["figure"],
        f"{number(row['value'])} {row['unit']}".strip(),
        spread(row),
        row["peer"] or "",
        f"{number(row['peer_value'])} {row['unit']}".strip() if row["peer_value"] is not None else "",
        f"{number(row['ratio'])}x" if row["ratio"] is not None else "",
        number(row["runs"]),
    ]


COLUMNS = ("what", "value", "spread", "peer", "peer's value", "better", "runs")


def page(results: dict[str, Any]) -> str:
    """``docs/benchmarks.md``."""
    parts = [HEAD]
    for name in dict.fromkeys(row["module"] for row in results["rows"]):
        rows = [row for row in results["rows"] if row["module"] == name]
        on = rows[0]["machine"]
        quick = " Quick runs: few samples." if any(row["quick"] for row in rows) else ""
        parts.append(f"\n## {name.replace('_', ' ').capitalize()}\n\n")
        parts.append(
            f"Measured {rows[0]['measured']} on {on['cores']} cores ({on['processor']}), {on['system']}, "
            f"Python {on['python']}.{quick}\n\n"
        )
        parts.append("| " + " | ".join(COLUMNS) + " |\n|" + "---|" * len(COLUMNS) + "\n")
        parts += ["| " + " | ".join(cell.replace("|", "\\|") for cell in cells(row)) + " |\n" for row in rows]
        parts += ["\n" + markdown(table) for table in results.get("tables", []) if table["module"] == name]
        for file in dict.fromkeys(plot["file"] for plot in results.get("plots", []) if plot["module"] == name):
            parts.append(f"\n![{name.replace('_', ' ')}: cost over size](images/{file})\n")
        commands = list(dict.fromkeys(row["command"] for row in rows if row["command"]))
        parts.append("\nRepeat: " + ", ".join(f"`{command}`" for command in commands) + "\n")
    return "".join(parts)


def illustrate(results: dict[str, Any], name: str) -> None:
    """Draw the pictures of one module."""
    plots = [plot for plot in results["plots"] if plot["module"] == name]
    for file in dict.fromkeys(plot["file"] for plot in plots):
        draw([plot for plot in plots if plot["file"] == file], PAGE.parent / "images" / file)


def show(rows: list[dict[str, Any]]) -> None:
    from rich.console import Console
    from rich.table import Table

    grid = Table(show_edge=False, pad_edge=False)
    for index, name in enumerate(COLUMNS):
        grid.add_column(name, justify="left" if index in (0, 3) else "right", overflow="fold")
    for row in rows:
        grid.add_row(*cells(row))
    console = Console(highlight=False)
    (console if console.is_terminal else Console(highlight=False, width=180)).print(grid)


def measure(name: str, quick: bool, results: dict[str, Any]) -> dict[str, Any]:
    """Run one benchmark, and write down each part as it comes.

    Returns:
        All results.

    Raises:
        Whatever the benchmark raises; what was measured before is written down.
    """
    print(f"{name} ...", file=sys.stderr, flush=True)
    begun = last = time.monotonic()
    found = importlib.import_module(f"benchmarks.{name}").run(quick)
    whole = Report([])
    merged = results
    for number, part in enumerate(parts(found), start=1):
        report = replace(part, rows=checked(name, part.rows))
        now = time.monotonic()
        print(f"  {name}, part {number}: {now - last:.0f} s", file=sys.stderr, flush=True)
        last = now
        if report.rows:
            show(report.rows)
        whole = Report(whole.rows + report.rows, whole.tables + report.tables, whole.plots + report.plots)
        merged = merge(results, name, whole, quick, whole=False)
        write(merged)
    merged = merge(results, name, whole, quick)
    write(merged)
    print(f"  {name}: {time.monotonic() - begun:.0f} s", file=sys.stderr, flush=True)
    return merged


def parts(found: Any) -> Iterator[Report]:
    """What a benchmark gives, part by part."""
    if isinstance(found, (Report, list)):
        found = (found,)
    for part in found:
        yield Report.of(part)


def write(results: dict[str, Any]) -> None:
    """Write ``results.json`` so that it is whole at any time."""
    draft = RESULTS.with_suffix(".part")
    draft.write_text(json.dumps(results, indent=1) + "\n", "utf-8")
    draft.replace(RESULTS)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description="Run the benchmarks.")
    parser.add_argument("--only", action="append", metavar="NAME", help=f"one of: {', '.join(modules())}; repeatable")
    parser.add_argument("--quick", action="store_true", help="few runs: to see that it works, not to quote")
    parser.add_argument("--page", action="store_true", help="only write docs/benchmarks.md from results.json")
    options = parser.parse_args()
    names = [] if options.page else options.only or modules()
    for name in names:
        if name not in modules():
            parser.error(f"there is no benchmark {name!r}; there are: {', '.join(modules())}")
    results = recorded()
    endings: dict[str, str] = {}
    before = signal.signal(signal.SIGTERM, terminate)
    try:
        for name in names:
            endings[name] = "stopped"
            endings[name] = ending(name, options.quick, results)
            results = recorded()
    finally:  # also after Ctrl-C and SIGTERM: the page says what was measured
        results = recorded()
        for name in names:
            illustrate(results, name)
        PAGE.parent.mkdir(parents=True, exist_ok=True)
        PAGE.write_text(page(results), "utf-8")
        for name, end in endings.items():
            print(f"{name}: {end}", file=sys.stderr)
        signal.signal(signal.SIGTERM, before)
    return 1 if any(end.startswith("failed") for end in endings.values()) else 0


def terminate(number: int, frame: object) -> None:
    """End as Ctrl-C does, with the exit code of shells: what was measured is kept."""
    sys.exit(128 + number)


def recorded() -> dict[str, Any]:
    """What ``results.json`` holds."""
    empty: dict[str, Any] = {"rows": []}
    return json.loads(RESULTS.read_text("utf-8")) if RESULTS.exists() else empty


def ending(name: str, quick: bool, results: dict[str, Any]) -> str:
    """Run one benchmark; how it ended."""
    try:
        measure(name, quick, results)
    except FileNotFoundError as error:
        # Recordings, voices or a ROS that this machine does not have: told, and no failure of ours.
        return f"skipped: {error}"
    except ImportError as error:
        return f"failed: {error}; make bench installs what the benchmarks need"
    except Exception as error:
        # One that cannot run must not cost the others their hour.
        traceback.print_exc()
        return f"failed: {type(error).__name__}: {error}"
    return "measured"


if __name__ == "__main__":
    sys.exit(main())
