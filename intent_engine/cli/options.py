"""Options that several verbs share, and what they stand for."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from intent_engine.errors import ConfigError, Problem
from intent_engine.resources import default_locations, find

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = ["Grammars", "Json", "Language", "Locations", "Robots", "load_engine"]

Grammars = Annotated[
    list[str] | None,
    typer.Option(
        "--grammar", "-g", help="Grammar file, or the name of a shipped one; may be repeated.", show_default="en"
    ),
]
Locations = Annotated[
    list[str] | None,
    typer.Option(
        "--locations", "-l", help="Map file, or the name of a shipped one; may be repeated.", show_default="home"
    ),
]
Robots = Annotated[
    str,
    typer.Option("--robot", "-r", help="Robot file, or the name of a shipped one: limits, rates and capabilities."),
]
Language = Annotated[
    str | None, typer.Option(help="Language of the speech and of the grammar: en, de, es, fr, it.", show_default="en")
]
Json = Annotated[bool, typer.Option("--json", help="JSON lines instead of text.")]


def load_engine(
    grammars: list[str] | None,
    locations: list[str] | None,
    language: str | None,
    wake: list[str] | None = None,
) -> IntentEngine:
    """The engine that the options describe.

    Raises:
        ConfigError: a file is missing or wrong.
    """
    from intent_engine.engine import IntentEngine

    grammar_paths = [_readable(find("grammars", name)) for name in grammars or [language or "en"]]
    map_paths = [_readable(find("locations", name)) for name in locations] if locations else [default_locations()]
    if wake and not all(re.search(r"\w", word) for word in wake):
        raise ConfigError(Problem("the wake word has no letters", hint='give a name: --wake-word "robot"'))
    return IntentEngine.from_files(grammar_paths, locations=map_paths, wake=wake or ())


def _readable(path: Path) -> Path:
    if path.is_dir():
        raise ConfigError(Problem("is a folder, not a file", file=str(path), hint="name a YAML file in it"))
    return path
