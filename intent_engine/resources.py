"""The files that come with the engine: grammars, maps and robots that work before a user writes their own.

A name is looked for in the folder one stands in, so that a user's copy wins; then in the installed package; then in
the repository that the package is run from.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from pathlib import Path

from intent_engine.errors import ConfigError, Problem

__all__ = ["default_grammar", "default_locations", "default_robot", "find", "is_shipped", "names", "shipped"]

PACKAGE = Path(__file__).parent
_SUFFIX = ".yaml"
_HOMES = {"de": "zuhause"}
"""Maps of the tutorials' home, by the language in which they name its places; ``home`` is English."""
_LANGUAGE = re.compile(r"^language:[ \t]*[\"']?([a-z]{2,3})\b", re.MULTILINE | re.IGNORECASE)


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
    if "\n" in name:
        what = f"the text of a file stands where a path or a name belongs: {name[:40]!r}"
        raise ConfigError(Problem(what, hint="write it to a file, and give its path"))
    given = Path(name)
    if given.suffix or os.sep in name or "/" in name or os.path.isfile(name):  # noqa: PTH113 - a name may be too long
        return given
    for folder in _folders(kind):
        path = folder / f"{name}{_SUFFIX}"
        if os.path.isfile(path):  # noqa: PTH113
            return path
    known = names(kind)
    if not name or os.path.isdir(name):  # noqa: PTH112
        what = "is a folder, not a file" if name else f"a name of one of the {kind} is empty"
        raise ConfigError(Problem(what, name or None, hint=f"there is {', '.join(known)}; or give the path of a file"))
    here = Path(f"{name}{_SUFFIX}")
    if os.path.isfile(here):  # noqa: PTH113
        raise ConfigError(Problem(f"{name!r} is the name of no file in {kind}/", hint=f"there is a file here: {here}"))
    hint = f"there is {', '.join(known)}; or give the path of a file" if known else "give the path of a file"
    raise ConfigError(Problem(f"no file {name}{_SUFFIX} in {kind}/", hint=hint))


def names(kind: str) -> list[str]:
    """The names that ``find`` knows."""
    return sorted({path.stem for folder in _folders(kind) for path in folder.glob(f"*{_SUFFIX}")})


def shipped(kind: str, name: str) -> Path | None:
    """A file that comes with the engine, by its full name; None where it was left out."""
    return next((folder / name for folder in _folders(kind)[1:] if (folder / name).is_file()), None)


def is_shipped(file: str | Path) -> bool:
    """Whether a file is one of those that come with the engine, and no copy of a user."""
    folder = Path(file).resolve().parent
    return any(folder == known.resolve() for known in _folders(folder.name)[1:])


def default_grammar(language: str = "en") -> Path:
    """The grammar of a language that comes with the engine."""
    return find("grammars", language)


def default_locations(grammars: Iterable[str | Path] = ()) -> list[Path]:
    """The maps of the tutorials' home that name its places in the languages of some grammars; in English, where there
    is none.

    Args:
        grammars: paths of files, which need not be right: whoever loads them says what is wrong.
    """
    languages = [_language(Path(grammar)) for grammar in grammars] or ["en"]
    return [find("locations", name) for name in dict.fromkeys(_HOMES.get(one, "home") for one in languages)]


def _language(grammar: Path) -> str:
    """The language that a grammar file names; empty: none, or it is no file that can be read twice."""
    try:
        found = _LANGUAGE.search(grammar.read_text("utf-8")) if grammar.is_file() else None
    except (OSError, ValueError):
        return ""
    return found.group(1).lower() if found else ""


def default_robot() -> Path:
    """The robot file of the simulated robot."""
    return find("robots", "simulated")
