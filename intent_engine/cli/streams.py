"""The standard streams, such that every verb can write: closed ones too, and with errors that are told apart."""

from __future__ import annotations

import io
import os
import select
import stat
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer

__all__ = ["OutputError", "drop_output", "prepare", "reader_gone"]

LOOK = 0.1
"""s after which it is seen whether a line that nobody reads is still wanted."""
ODD = "backslashreplace"
"""A name with odd bytes is shown, not raised about."""


class OutputError(OSError):
    """Standard output cannot be written; says why."""


def _may_stand_still(out: io.RawIOBase) -> bool:
    """Whether a reader is behind it, as of a pipe or a terminal, and it can be seen whether that reads."""
    if os.name == "nt":
        return False
    try:
        mode = os.fstat(out.fileno()).st_mode
    except (OSError, ValueError):
        return False
    return stat.S_ISFIFO(mode) or stat.S_ISCHR(mode) or stat.S_ISSOCK(mode)


class _Output(io.RawIOBase):
    """Standard output, whose errors say that they are its own.

    Args:
        under: what it is written to; None: it was closed before the program began.
    """

    name = "<stdout>"

    def __init__(self, under: io.RawIOBase | None) -> None:
        self._under = under
        self.dropped = False
        """Whether what is still written is for nobody."""
        self.gone = False
        """Whether its reader went away."""
        self._waits = under is not None and _may_stand_still(under)

    def writable(self) -> bool:
        return True

    def isatty(self) -> bool:
        return self._under is not None and self._under.isatty()

    def fileno(self) -> int:
        if self._under is None:
            raise io.UnsupportedOperation("standard output is closed")
        return self._under.fileno()

    def write(self, data: ReadableBuffer, /) -> int | None:
        if self.dropped:
            return memoryview(data).nbytes
        if self._under is None:
            raise OutputError("it is closed")
        try:
            return self._under.write(data) if not self._waits else self._write_when_read(self._under, data)
        except BrokenPipeError:
            self.gone = True
            raise
        except OSError as error:
            raise OutputError(error.strerror or str(error)) from None

    def _write_when_read(self, under: io.RawIOBase, data: ReadableBuffer) -> int:
        """Write all, a piece whenever somebody reads, until it is for nobody any more. A write that blocks could not be
        given up, and would abort the program at its end."""
        left = memoryview(data).cast("B")
        size = left.nbytes
        while left.nbytes:
            while not select.select([], [under.fileno()], [], LOOK)[1]:
                if self.dropped:
                    return size
            left = left[under.write(left[: select.PIPE_BUF]) or 0 :]
        return size


class _Errors(io.RawIOBase):
    """Standard error. What cannot be told there is told nowhere, and changes nothing: least of all the exit code."""

    name = "<stderr>"

    def __init__(self, under: io.RawIOBase) -> None:
        self._under = under

    def writable(self) -> bool:
        return True

    def isatty(self) -> bool:
        return self._under.isatty()

    def fileno(self) -> int:
        return self._under.fileno()

    def write(self, data: ReadableBuffer, /) -> int | None:
        size = memoryview(data).nbytes
        try:
            return self._under.write(data) or size
        except OSError:  # a full disk, a reader that went away, a file that was opened to read
            return size


def prepare() -> None:
    """Make the streams of this process such; once, before anything is written."""
    # Of a stream that is closed Python makes None.
    if sys.stderr is None:
        sys.stderr = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115 - it ends with the process
    elif isinstance(sys.stderr, io.TextIOWrapper):
        sys.stderr = _rewrapped(sys.stderr, _Errors)
    if sys.stdout is None:
        sys.stdout = io.TextIOWrapper(io.BufferedWriter(_Output(None)), "utf-8", errors=ODD)
    elif isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout = _rewrapped(sys.stdout, _Output)


def _rewrapped(before: io.TextIOWrapper, raw: Callable[[Any], io.RawIOBase]) -> io.TextIOWrapper:
    """The same stream, written through a raw one of ours."""
    before.flush()
    under = getattr(before.buffer, "raw", None)
    # Without buffers (python -u) there is nothing between text and file.
    ours = raw(before.buffer if under is None else under)
    return io.TextIOWrapper(
        ours if under is None else io.BufferedWriter(ours),  # type: ignore[arg-type]
        before.encoding,
        errors=ODD,
        line_buffering=before.line_buffering,
        write_through=before.write_through,
    )


def drop_output() -> None:
    """Give what is still to be written to nobody: Python writes it once more at exit, and would complain."""
    out = _output()
    if out is not None:
        out.dropped = True


def reader_gone() -> bool:
    """Whether the reader of standard output went away."""
    out = _output()
    return out is not None and out.gone


def _output() -> _Output | None:
    buffer = getattr(sys.stdout, "buffer", None)
    out = getattr(buffer, "raw", buffer)
    return out if isinstance(out, _Output) else None
