"""Options that several verbs share, and what they stand for."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from intent_engine.cli.terminal import note
from intent_engine.errors import ConfigError, Problem
from intent_engine.grammar_states import unknown_states
from intent_engine.language_tag import code_of, language_of
from intent_engine.resources import default_grammar, default_locations, find, names

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = [
    "Device",
    "Grammars",
    "Json",
    "Language",
    "Locations",
    "NamedToo",
    "Robots",
    "States",
    "filled",
    "known_states",
    "load_engine",
    "tell_doubts",
]


def filled(given: str | list[str] | None, param: typer.CallbackParam) -> str | list[str] | None:
    """What an option was given, which is not empty: as a shell makes it of a variable that is not set.

    Raises:
        ConfigError: it is.
    """
    if "" in ([given] if isinstance(given, str) else given or ()):
        raise ConfigError(Problem(f"{param.opts[0]} is empty", hint="give a name, or leave the option out"))
    return given


Grammars = Annotated[
    list[str] | None,
    typer.Option(
        "--grammar", "-g", help="Grammar file, or the name of a shipped one; may be repeated.", show_default="en"
    ),
]
NamedToo = Annotated[
    list[str] | None, typer.Option("--grammar", "-g", help="The same, as other verbs take it.", show_default=False)
]
"""Of verbs whose arguments are grammars."""
Locations = Annotated[
    list[str] | None,
    typer.Option(
        "--locations",
        "-l",
        help="Map file, or the name of a shipped one; may be repeated.",
        show_default="home, zuhause in German",
    ),
]
Device = Annotated[
    str | None,
    typer.Option(callback=filled, help="Microphone: its number, name, or a part of the name.", show_default="default"),
]
Robots = Annotated[
    str,
    typer.Option("--robot", "-r", help="Robot file, or the name of a shipped one: limits, rates and capabilities."),
]
Language = Annotated[
    str | None,
    typer.Option(
        callback=lambda tag: tag and language_of(tag),
        help="Language of the speech, also with its region (en-US): en or de, whose grammar is taken; another with a "
        "--grammar of your own.",
        show_default="en",
    ),
]
States = Annotated[
    list[str] | None,
    typer.Option("--state", help="A state that the robot is in: moving, or one of the grammar; may be repeated."),
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

    paths = [find("grammars", name) for name in grammars] if grammars else [_grammar_of(language)]
    grammar_paths = [_readable(path) for path in paths]
    map_paths = [_readable(find("locations", name)) for name in locations or ()] or default_locations(grammar_paths)
    if wake and not all(re.search(r"\w", word) for word in wake):
        raise ConfigError(Problem("the wake word has no letters", hint='give a name: --wake-word "robot"'))
    return IntentEngine.from_files(grammar_paths, locations=map_paths, wake=wake or ())


def tell_doubts(engine: IntentEngine, given: list[str] | None) -> None:
    """A line on standard error each, if loading the grammars found what is hardly meant, and if they go to places that
    the map has not; ``check`` looks for more.

    Args:
        engine: that was loaded.
        given: the grammars as the option named them; None: the shipped one.
    """
    names = given or [file for grammar in engine.grammars for file in grammar.files]
    check = f"intent-engine check {shlex.join([*(['--together'] if len(names) > 1 else []), *names])}"
    which = f"grammar{'s' * (len(names) > 1)} {' and '.join(names)}"
    if count := sum(len(grammar.warnings) for grammar in engine.grammars):
        shows = "shows it" if count == 1 else "shows them"
        note(f"{count} warning{'s' * (count != 1)} in {which}: {check} {shows}")
    if missing := _places_missing(engine):
        places = "1 place" if missing == 1 else f"{missing} places"
        who = f"{which} {'name' if len(names) > 1 else 'names'}"
        where = f"{'is' if missing == 1 else 'are'} not on {_maps_of(engine)}"
        note(f"{places} that {who} {where}: --locations FILE gives a map of your own")


def _places_missing(engine: IntentEngine) -> int:
    """How many places the grammars go to that the map has not."""
    from intent_engine.language.checking.map_fit import places_missing

    places = engine.locations
    return sum(1 for grammar in engine.grammars for _ in places_missing(grammar, places)) if places is not None else 0


def _maps_of(engine: IntentEngine) -> str:
    """The maps of an engine, by the names of their files."""
    files = [Path(file).name for file in (engine.locations.files if engine.locations is not None else ())]
    return f"the map{'s' * (len(files) > 1)} {' and '.join(files)}".rstrip()


def known_states(engine: IntentEngine, given: list[str] | None) -> tuple[str, ...]:
    """The states of the option.

    Raises:
        ConfigError: some change nothing: they are misspelled, or of another grammar.
    """
    if problems := unknown_states(given or (), engine.states, "--state"):
        raise ConfigError(problems)
    return tuple(given or ())


def _grammar_of(language: str | None) -> Path:
    if language is None:
        return default_grammar()
    known = names("grammars")
    if language not in known:
        named = code_of(language)
        name = language if re.fullmatch("[a-z]{2,3}", language) else named or "fr"
        hint = (
            f"write --language {named}"
            if named in known
            else (
                f"there is one for {', '.join(known)}; for another language give your own, with language: {name} in "
                f"it: --grammar my_grammar.yaml --language {name}"
            )
        )
        raise ConfigError(Problem(f"--language: there is no grammar for {language!r}", hint=hint))
    return default_grammar(language)


def _readable(path: Path) -> Path:
    if path.is_dir():
        raise ConfigError(Problem("is a folder, not a file", file=str(path), hint="name a YAML file in it"))
    return path
