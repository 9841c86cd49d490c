"""Files that a verb writes at its end: whether they can be written is known before it begins."""

from __future__ import annotations

import importlib.util
import stat
from pathlib import Path

from intent_engine.errors import ConfigError, Problem

__all__ = ["check_file", "check_picture"]

PICTURES = [".png", ".svg", ".pdf", ".svgz", ".jpg", ".jpeg", ".webp", ".tif", ".tiff", ".eps", ".ps"]
"""Endings of the pictures that matplotlib writes."""
ENDINGS = "end its name in .png, .svg or .pdf"


def check_picture(path: Path, option: str, extra: str) -> None:
    """Whether a picture can be drawn into a file.

    Args:
        path: of the file.
        option: that named it.
        extra: of the package, which brings what draws.

    Raises:
        ConfigError: it cannot.
    """
    if importlib.util.find_spec("matplotlib") is None:
        raise ConfigError(f"{option} needs matplotlib\n    pip install 'intent-engine[{extra}]'")
    if path.is_dir():
        raise ConfigError(Problem(f"{option}: {path} is a folder", hint=f"give the name of a file: {path / 'all.png'}"))
    if path.suffix.lower() not in PICTURES:
        kind = f"{path.suffix!r} is no kind of picture" if path.suffix else "the name has no ending"
        raise ConfigError(Problem(f"{option}: {path} cannot be drawn: {kind}", hint=ENDINGS))
    check_file(path, option)


def check_file(path: Path, option: str) -> None:
    """Whether a file can be written; its folder is made. What it holds stays as it is.

    Raises:
        ConfigError: it cannot.
    """
    if path.is_dir():
        raise ConfigError(Problem(f"{option}: {path} is a folder", hint=f"give the name of a file: {path / 'all.csv'}"))
    there = path.exists()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if there and stat.S_ISFIFO(path.stat().st_mode):
            return  # to open it would wait for its reader
        with path.open("ab", buffering=0) as file:
            file.write(b"")  # no more than a device needs to say that it takes nothing
        if not there:
            path.unlink()
    except OSError as error:
        why = error.strerror or str(error)
        hint = "give a file in a folder that you may write to"
        raise ConfigError(Problem(f"{option}: {path} cannot be written: {why}", hint=hint)) from None
