"""The files with the words of a language, by kind: ``numbers/de.yaml``, ``operators/de.yaml`` and ``things/de.yaml``.

A language that has no file of a kind has none of its words. A key that nobody reads is refused: with a slip in its name
a list of negations would be missing, and the robot would do what it was told not to do.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from typing import Any, TypeAlias

import yaml

from intent_engine.errors import ConfigError, Problem
from intent_engine.hints import did_you_mean

__all__ = ["Keys", "checked", "language_file", "languages_of"]

Keys: TypeAlias = Mapping[str, Any]
"""What may stand in a file -> the keys that may stand below it, or :data:`Keys` again; None: words, or keys that are
words."""

_ROOM = Path(__file__).parent


def language_file(
    kind: str, language: str, keys: Keys, needed: Mapping[str, Collection[str]] | None = None
) -> dict[str, Any] | None:
    """What a file holds; None: the language has none of this kind.

    Args:
        kind: its folder: "numbers".
        language: two letters, its name.
        keys: that it may have.
        needed: those at its top that must have some keys below them, and these.

    Raises:
        ConfigError: as :func:`checked`.
    """
    file = _ROOM / kind / f"{language}.yaml"
    return checked(file, keys, needed) if file.is_file() else None


def languages_of(kind: str) -> tuple[str, ...]:
    """The languages that have a file of a kind."""
    return tuple(sorted(file.stem for file in (_ROOM / kind).glob("*.yaml")))


def checked(file: Path, keys: Keys, needed: Mapping[str, Collection[str]] | None = None) -> dict[str, Any]:
    """What a file holds; arguments as those of :func:`language_file`.

    Raises:
        ConfigError: it has other keys, or words that YAML reads as true or false ("no", "on"), or lacks a key that is
            needed. Holds all of them.
    """
    text = file.read_text("utf-8")
    data: dict[str, Any] = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader)) or {}
    problems = [
        Problem(f"unknown key {key!r}", str(file), _line_of(str(key), text), hint=did_you_mean(str(key), known))
        for key, known in _unknown(data, keys)
    ]
    problems += [
        Problem(f"a word under {key!r} is read as {'true' if value else 'false'}", str(file), hint="quote it")
        for key, value in _truths(data)
    ]
    problems += [
        Problem(f"{key!r} has no {inner!r}", str(file), hint="see the same file of another language")
        for key, wanted in (needed or {}).items()
        for inner in sorted(set(wanted).difference(data.get(key, ())))
    ]
    if problems:
        raise ConfigError(problems)
    return data


def _unknown(data: Mapping[Any, Any], keys: Keys) -> Iterator[tuple[Any, list[str]]]:
    """The keys that are not known, each with those that are."""
    for key, value in data.items():
        if key not in keys:
            yield key, [*keys]
        elif isinstance(known := keys[key], Mapping) and isinstance(value, Mapping):
            yield from _unknown(value, known)
        elif known is not None and isinstance(value, Mapping):
            yield from ((inner, [*known]) for inner in value if inner not in known)


def _truths(value: Any, key: Any = "") -> Iterator[tuple[Any, bool]]:
    if isinstance(value, bool):
        yield key, value
    elif isinstance(value, Mapping):
        for inner, item in value.items():
            if isinstance(inner, bool):
                yield key, inner
            yield from _truths(item, inner)
    elif isinstance(value, list):
        for item in value:
            yield from _truths(item, key)


def _line_of(key: str, text: str) -> int | None:
    """The line on which a key stands, counted from 1."""
    found = re.search(rf"(?m)^.*?(?<![\w]){re.escape(key)}['\"]?\s*:", text)
    return text.count("\n", 0, found.start()) + 1 if found else None
