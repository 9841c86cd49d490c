"""From grammar files and a map to what an engine understands with."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from intent_engine.errors import ConfigError, Problem
from intent_engine.language.grammar import Grammar
from intent_engine.language.loading.grammar_file import load_grammars
from intent_engine.language.loading.wake_stops import wake_that_stops
from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning import Interpreter
from intent_engine.language.networks.nearest import Nearest
from intent_engine.language.normalize import words_of
from intent_engine.language_tag import code_of, language_of
from intent_engine.resources import find

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["EngineFiles", "Loaded", "StrPath"]

StrPath = str | os.PathLike[str]


@dataclass(frozen=True)
class Loaded:
    """Everything made from one state of the files; replaced as a whole, so that a parse never sees two."""

    grammars: tuple[Grammar, ...]
    locations: LocationMap | None
    interpreters: Mapping[str, Interpreter]
    """By language, in the order of the files."""

    @staticmethod
    def of(grammars: tuple[Grammar, ...], locations: LocationMap | None) -> Loaded:
        """What is made of grammars and a map that are read."""
        interpreters = {}
        for grammar in grammars:
            matcher = Matcher(grammar, locations)
            interpreters[grammar.language] = Interpreter(matcher, Nearest(matcher))
        return Loaded(grammars, locations, interpreters)

    @cached_property
    def _all(self) -> tuple[Interpreter, ...]:
        return tuple(self.interpreters.values())

    def parsers(self, language: str | None) -> tuple[Interpreter, ...]:
        """The interpreter of a language; None: all of them.

        Raises:
            ConfigError: no grammar of this language is loaded; says which are.
            TypeError: it is no text.
        """
        if language is None:
            return self._all
        if not isinstance(language, str):
            raise TypeError(f"a language is given by its tag, as 'en', not as {language!r:.80}")
        interpreter = self.interpreters.get(language_of(language))
        if interpreter is None:
            there = ", ".join(self.interpreters)
            named = code_of(language)
            hint = f"ask for one of these, or load a grammar with language: {named or language or 'fr'}"
            if named in self.interpreters:
                hint = f"write {named!r}"
            raise ConfigError(Problem(f"no grammar of language {language!r} is loaded; there is {there}", hint=hint))
        return (interpreter,)


@dataclass(frozen=True)
class EngineFiles:
    """Where an engine reads from, again at each reload."""

    grammars: tuple[Path, ...] = ()
    locations: tuple[Path, ...] = ()
    places: LocationMap | None = None
    """A map that was given as one, and is not read."""
    wake: tuple[tuple[str, ...], ...] = ()
    """Wake words beside those of the grammars."""
    missing: tuple[Problem, ...] = ()
    """What was named, and there is not."""

    @staticmethod
    def found(
        grammar: StrPath | Sequence[StrPath],
        locations: StrPath | Sequence[StrPath] | LocationMap | Mapping[str, Any] | None,
        wake: str | Sequence[str],
    ) -> EngineFiles:
        """The files that :meth:`~intent_engine.engine.IntentEngine.from_files` was given, by path or name.

        Raises:
            ConfigError: a wake word has no letters, or a dictionary of places is wrong.
            TypeError: it was given something else.
        """
        missing: list[Problem] = []
        grammars = _found("grammars", grammar, missing)
        woken = tuple(words_of(text) for text in _wake_words(wake))
        maps: tuple[Path, ...] = ()
        places: LocationMap | None = None
        if isinstance(locations, os.PathLike | Sequence):  # a text is a sequence, too
            maps = _found("locations", locations, missing)
        elif locations is not None:
            from intent_engine.language.locations import LocationMap

            if not isinstance(locations, Mapping):
                raise TypeError(f"locations are files or a dictionary of places, not {type(locations).__name__}")
            places = locations if isinstance(locations, LocationMap) else LocationMap.from_mapping(locations)
        return EngineFiles(grammars, maps, places, woken, tuple(missing))

    def read(self) -> Loaded:
        """Everything in the files.

        Raises:
            ConfigError: with everything that is missing, and all that is wrong in what is not.
        """
        problems = list(self.missing)
        files: list[str] = []
        grammars: tuple[Grammar, ...] = ()
        places = self.places
        if self.grammars or not self.missing:
            try:
                grammars = load_grammars(self.grammars)
            except ConfigError as error:
                problems.extend(error.problems)
                files.extend(error.files)
        files.extend(file for grammar in grammars for file in grammar.files)
        if self.locations:
            from intent_engine.language.locations import load

            try:
                places = load(self.locations)
            except ConfigError as error:
                problems.extend(error.problems)
        for words in self.wake:
            wrong = (wake_that_stops(words, grammar.operators) for grammar in grammars)
            problems.extend(Problem(message, hint=hint) for message, hint in dict.fromkeys(filter(None, wrong)))
        if problems:
            raise ConfigError(problems, files)
        if self.wake:
            grammars = tuple(replace(grammar, wake=(*grammar.wake, *self.wake)) for grammar in grammars)
        return Loaded.of(grammars, places)


def _wake_words(given: str | Sequence[str]) -> Sequence[str]:
    """One text is a list of one: each of its letters would wake the robot, and what it is called would not."""
    words = [given] if isinstance(given, str) else given
    if isinstance(words, Mapping) or not isinstance(words, Collection) or not all(isinstance(w, str) for w in words):
        raise TypeError(f"wake words are texts in a list, as ['robot'], not {given!r:.80}")
    if silent := [word for word in words if not any(map(str.isalnum, word))]:
        raise ConfigError(Problem(f"the wake word {silent[0]!r} has no letters", hint="give a name, as 'robot'"))
    return list(words)


def _found(kind: str, value: StrPath | Sequence[StrPath], problems: list[Problem]) -> tuple[Path, ...]:
    """The files of a kind that paths and names of shipped ones stand for; what there is not is told."""
    paths: list[Path] = []
    if isinstance(value, str | os.PathLike):
        value = (value,)
    if isinstance(value, bytes | Mapping) or not isinstance(value, Iterable):
        raise TypeError(f"{kind} are given by path or name, not as {type(value).__name__}")
    for one in value:
        if not isinstance(one, str | os.PathLike):
            raise TypeError(f"{kind} are given by path or name, not as {type(one).__name__}")
        try:
            paths.append(find(kind, os.fspath(one)))
        except ConfigError as error:
            problems.extend(error.problems)
    return tuple(paths)
