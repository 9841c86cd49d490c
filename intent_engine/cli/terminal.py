"""What a person or a program reads: text and JSON lines on standard output, errors and progress on standard error."""

from __future__ import annotations

import contextlib
import functools
import json
import logging
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, TextIO

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import Progress
    from rich.table import Table

__all__ = [
    "LogNotes",
    "error_block",
    "json_line",
    "level_meter",
    "note",
    "paragraph",
    "progress",
    "redrawn",
    "say",
    "table",
    "working",
]


_CONTROL = re.compile(r"[\x00-\x09\x0b-\x1f\x7f-\x9f]")
"""What Rich replaces or leaves out."""
_FORCING = ("FORCE_COLOR", "TTY_COMPATIBLE", "TTY_INTERACTIVE", "JUPYTER_COLUMNS")
"""Variables by which somebody asks Rich to take what is no terminal for one."""
PIPE_WIDTH = 120
"""Columns of a table in a file or pipe, unless COLUMNS says another width."""
GAP = 3
"""Columns between two of a table."""


def _out() -> Console:
    # Made for each use: rich looks at the stream, NO_COLOR and the width when a console is made, and tests swap both.
    return _console()(highlight=False, soft_wrap=not sys.stdout.isatty())


def _err() -> Console:
    return _console()(stderr=True, highlight=False, soft_wrap=not sys.stderr.isatty())


@functools.cache
def _console() -> type[Console]:
    from rich.console import Console

    class Quiet(Console):
        """Rich would end the program by itself where the reader of a pipe goes away, with an exit code of its own."""

        def on_broken_pipe(self) -> None:
            raise BrokenPipeError

    return Quiet


def _plainly(stream: TextIO, text: str) -> bool:
    """Write a line into a pipe or file as Rich would; False where Rich has to.

    Loading Rich takes as long as understanding the sentence.
    """
    if stream.isatty() or any(os.environ.get(name) for name in _FORCING) or _CONTROL.search(text):
        return False
    stream.write(text + "\n")
    return True


def say(text: str = "", style: str | None = None) -> None:
    """One line on standard output, at once. ``text`` is shown as it is: what people said may hold brackets."""
    if not _plainly(sys.stdout, text):
        from rich.text import Text

        _out().print(Text(text, style=style or ""))
    sys.stdout.flush()


def json_line(data: Any) -> None:
    """One JSON object on one line of standard output, at once, so that a program can follow.

    ASCII alone: some readers end a line at U+2028 or U+0085 as well, and not every terminal is UTF-8.
    """
    sys.stdout.write(json.dumps(data, allow_nan=False) + "\n")
    sys.stdout.flush()


def note(text: str) -> None:
    """A line for the person at the terminal that is no result; on standard error."""
    if not _plainly(sys.stderr, text):
        from rich.text import Text

        _err().print(Text(text, style="dim"))


def redrawn(view: Any) -> contextlib.AbstractContextManager[object]:
    """Something that is drawn again and again below what is printed; nothing where standard output is no terminal."""
    if not sys.stdout.isatty():  # colours may be forced into a file, what moves may not
        return contextlib.nullcontext()
    from rich.live import Live

    return Live(view, console=_out(), refresh_per_second=8, transient=True)


def error_block(message: str) -> None:
    """What went wrong, on standard error."""
    from rich.text import Text

    console = _err()
    first, *rest = message.splitlines() or [""]
    console.print(Text.assemble(("error: ", "bold red"), first))
    for line in rest:
        console.print(Text(line))


class LogNotes(logging.Handler):
    """Warnings of the package as one dim line each; their tracebacks are for ``--debug``."""

    def emit(self, record: logging.LogRecord) -> None:
        note(f"{record.levelname.lower()}: {record.getMessage()}")


def table(
    title: str, columns: Sequence[str], rows: Iterable[Sequence[object]], *, keys: int = 0, listed: bool = False
) -> None:
    """A table on standard output; columns of numbers stand to the right.

    Args:
        title: stands above it; may be empty.
        columns: their heads.
        rows: their cells.
        keys: so many columns at the left say which row it is. Where the table is wider than the terminal, it is cut
            into several that stand below each other, each with these columns; 0: its cells are folded.
        listed: it is not cut, but every row is listed, a line for each of its other cells: they are sentences.
    """
    from rich.cells import cell_len

    body = [[str(cell) for cell in row] for row in rows]
    console = _table_console()
    widths = [max(map(cell_len, column)) for column in zip(columns, *body, strict=True)]
    if keys and listed and _width(widths) > console.width:
        _list(console, title, columns, body, keys)
        return
    blocks = _blocks(widths, keys, console.width) if keys else [range(len(columns))]
    for number, block in enumerate(blocks):
        if number:
            console.print()
        heads, cells = [columns[index] for index in block], [[row[index] for index in block] for row in body]
        console.print(_grid("" if number else title, heads, cells))


def paragraph(text: str) -> None:
    """Text on standard output that belongs to a table, in lines no longer than one of its."""
    from rich.text import Text

    _table_console().print(Text(text))


def _table_console() -> Console:
    console = _out()
    if console.is_terminal:
        return console
    wanted = os.environ.get("COLUMNS", "")
    return _console()(highlight=False, width=int(wanted) if wanted.isdecimal() and int(wanted) else PIPE_WIDTH)


def _width(widths: Sequence[int]) -> int:
    return sum(widths) + GAP * (len(widths) - 1)


def _blocks(widths: Sequence[int], keys: int, width: int) -> list[list[int]]:
    """The columns of each table that is as wide at most, or has one column beside its keys."""
    first = list(range(keys))
    blocks: list[list[int]] = []
    block = first
    for index in range(keys, len(widths)):
        if len(block) > keys and _width([widths[one] for one in [*block, index]]) > width:
            blocks.append(block)
            block = first
        block = [*block, index]
    return [*blocks, block]


def _grid(title: str, columns: Sequence[str], body: Sequence[Sequence[str]]) -> Table:
    from rich import box
    from rich.table import Table
    from rich.text import Text

    grid = Table(title=title or None, title_justify="left", show_edge=False, pad_edge=False, box=box.SIMPLE_HEAD)
    for index, name in enumerate(columns):
        numeric = bool(body) and all(_is_number(row[index]) for row in body)
        grid.add_column(name, justify="right" if numeric else "left", overflow="fold")
    for row in body:
        grid.add_row(*(Text(cell) for cell in row))
    return grid


def _list(console: Console, title: str, columns: Sequence[str], body: Sequence[Sequence[str]], keys: int) -> None:
    from rich.table import Table
    from rich.text import Text

    if title:
        console.print(Text(title, style="italic"))
    for row in body:
        if any(row[:keys]):  # else it is more of the row before
            console.print(Text(", ".join(row[:keys]), style="bold"))
        grid = Table.grid(padding=(0, 2), pad_edge=False)
        grid.add_column()
        grid.add_column(overflow="fold")
        for name, cell in zip(columns[keys:], row[keys:], strict=True):
            grid.add_row(Text(f"  {name}"), Text(cell))
        console.print(grid)


def _is_number(cell: str) -> bool:
    try:
        float(cell.removesuffix("%").removesuffix("ms").strip() or "0")
    except ValueError:
        return False
    return True


@contextlib.contextmanager
def working(what: str) -> Iterator[Callable[[str], None]]:
    """A spinner on standard error where that is a terminal; call what it gives with what has just been done."""
    if not sys.stderr.isatty():
        yield lambda text: None
        return
    console = _err()
    with console.status(what) as status:
        yield lambda text: status.update(f"{what} ({text})")


@contextlib.contextmanager
def progress(what: str, steps: int) -> Iterator[Callable[[], None]]:
    """A progress bar on standard error where that is a terminal; call what it gives after each step."""
    if not sys.stderr.isatty():
        yield lambda: None
        return
    with _bar() as bar:
        task = bar.add_task(what, total=steps)
        yield lambda: bar.advance(task)


def _bar() -> Progress:
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    return Progress(*columns, console=_err(), transient=True)


@contextlib.contextmanager
def level_meter(what: str) -> Iterator[Callable[[float], None]]:
    """A bar on standard error that follows a level in dBFS, -60 to 0."""
    from rich.progress import BarColumn, Progress, TextColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TextColumn("{task.fields[level]}"))
    with Progress(*columns, console=_err(), transient=True) as progress:
        bar = progress.add_task(what, total=60, level="", visible=False)

        def move(level: float) -> None:
            progress.update(bar, completed=min(max(60 + level, 0), 60), level=f"{level:4.0f} dBFS", visible=True)

        yield move
