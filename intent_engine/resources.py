"""The files that come with the engine: grammars, maps and robots that work before a user writes their own.

A name is looked for in the folder one stands in, so that a user's copy wins; then in the installed package; then in
the repository that the package is run from.
"""

from __future__ import annotations

import os
from pathlib import Path

from intent_engine.errors import ConfigError, Problem

__all__ = ["default_grammar", "default_locations", "default_robot", "find", "names", "shipped"]

PACKAGE = Path(__file__).parent
_SUFFIX = ".yaml"


def _folders(kind: str) -> list[Path]:
    return [Path(kind), PACKAGE / "share" / kind, PACKAGE.parent / kind]


def find(kind: str, name: str) -> Path:
    """The file of a kind (``grammars``, ``locations``, ``robots``) with a name (``en``, ``home``).

    Args:
        kind: the folder's name.
        name: the file's name without its suffix; or the path of a file, which is given back as it is.

    Raises:
        ConfigError: there is none; the message lists those that there are.
    """
    given = Path(name)
    if given.suffix or os.sep in name or "/" in name or given.is_file():
        return given
    for folder in _folders(kind):
        path = folder / f"{name}{_SUFFIX}"
        if path.is_file():
            return path
    known = names(kind)
    if given.is_dir() or not name:
        what = "is a folder, not a file" if name else f"a name of one of the {kind} is empty"
        raise ConfigError(Problem(what, name or None, hint=f"there is {', '.join(known)}; or give the path of a file"))
    here = Path(f"{name}{_SUFFIX}")
    if here.is_file():
        raise ConfigError(Problem(f"{name!r} is the name of no file in {kind}/", hint=f"there is a file here: {here}"))
    hint = f"there is {', '.join(known)}; or give the path of a file" if known else "give the path of a file"
    raise ConfigError(Problem(f"no file {name}{_SUFFIX} in {kind}/", hint=hint))


def names(kind: str) -> list[str]:
    """The names that ``find`` knows."""
    return sorted({path.stem for folder in _folders(kind) for path in folder.glob(f"*{_SUFFIX}")})


def shipped(kind: str, name: str) -> Path | None:
    """A file that comes with the engine, by its full name; None where it was left out."""
    return next((folder / name for folder in _folders(kind)[1:] if (folder / name).is_file()), None)


def default_grammar(language: str = "en") -> Path:
    """The grammar of a language that comes with the engine."""
    return find("grammars", language)


def default_locations() -> Path:
    """The map of the tutorials' home."""
    return find("locations", "home")


def default_robot() -> Path:
    """The robot file of the simulated robot."""
    return find("robots", "simulated")
