"""Files that a verb writes at its end: whether they can be written is known before it begins."""

from __future__ import annotations

import importlib.util
import stat
from collections.abc import Iterable, Mapping
from pathlib import Path

from intent_engine.errors import ConfigError, Problem

__all__ = ["check_apart", "check_file", "check_picture", "check_table"]

PICTURES = [".png", ".svg", ".pdf", ".svgz", ".jpg", ".jpeg", ".webp", ".tif", ".tiff", ".eps", ".ps"]
"""Endings of the pictures that matplotlib writes."""
ENDINGS = "end its name in .png, .svg or .pdf"

SPREADSHEETS = [".xlsx", ".xls", ".xlsm", ".ods", ".numbers"]
"""Endings of workbooks. Their programs refuse a file of that name that holds plain rows."""


def check_table(path: Path, option: str) -> None:
    """Whether a table can be written into a file as CSV.

    Raises:
        ConfigError: it cannot, or its name is that of a workbook.
    """
    if path.suffix.lower() in SPREADSHEETS and not path.is_dir():
        why = f"{option}: {path} is the name of a workbook, and CSV is written"
        hint = f"any spreadsheet opens that: {option} {path.with_suffix('.csv')}"
        raise ConfigError(Problem(why, hint=hint))
    check_file(path, option)


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
        raise ConfigError(Problem(f"{option}: {path} is a folder", hint="give the name of a file in it"))
    there = path.exists()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if there and stat.S_ISFIFO(path.stat().st_mode):
            return  # to open it would wait for its reader
        with path.open("ab", buffering=0) as file:
            file.write(b"")  # no more than a device needs to say that it takes nothing
        if not there:
            path.resolve().unlink()  # the file, not a link that leads to it
    except OSError as error:
        why = error.strerror or str(error)
        hint = "give a file in a folder that you may write to"
        raise ConfigError(Problem(f"{option}: {path} cannot be written: {why}", hint=hint)) from None


def check_apart(outputs: Mapping[str, Path | None], inputs: Iterable[Path]) -> None:
    """Whether each file that is written is one, and neither read by the same command nor written twice: a recording or
    a grammar would be lost. Devices and pipes are nobody's only copy.

    Args:
        outputs: option -> the file that it names; None: it was not given.
        inputs: files that are read, by whatever name.

    Raises:
        ConfigError: a file is both, or is called ``-``, which would be a file of that name and no stream.
    """
    taken = {path.resolve(): "is read by the same command" for path in inputs if path.is_file()}
    for option, path in outputs.items():
        if path is None or (path.exists() and not path.is_file()):
            continue
        if str(path) == "-":
            raise ConfigError(
                Problem(
                    f"{option}: - is no file, and standard output is not written to", hint="give the name of a file"
                )
            )
        if why := taken.get(path.resolve()):
            raise ConfigError(Problem(f"{option}: {path} {why}, and would be lost", hint="give another name"))
        taken[path.resolve()] = f"is what {option} writes"
