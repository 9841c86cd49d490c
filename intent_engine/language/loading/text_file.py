"""The text of a file that somebody names, who may name anything: a device that never ends, too."""

from __future__ import annotations

from pathlib import Path

__all__ = ["MAX_BYTES", "TooLargeError", "text_of"]

MAX_BYTES = 64 * 1024 * 1024
"""A file beyond this is not one that a person wrote for us."""


class TooLargeError(OSError):
    """A file has more than :data:`MAX_BYTES`, or no end at all."""


def text_of(file: Path) -> str:
    """The text of a file, its lines ended as Python ends them.

    No more is read than a file may have, and what is no file but a pipe is read once.

    Raises:
        TooLargeError: it has more than that.
        OSError: it cannot be read.
        UnicodeDecodeError: it is no UTF-8.
        ValueError: no file has such a path.
    """
    with file.open("rb") as stream:
        data = stream.read(MAX_BYTES + 1)
    if len(data) > MAX_BYTES:
        raise TooLargeError(f"{file} is larger than 64 MiB")
    return data.decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n")
