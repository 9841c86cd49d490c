"""Text in, interpretation out: the one object that most users need."""

from __future__ import annotations

import os
import threading
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from intent_engine.actions import actions_of
from intent_engine.errors import ConfigError, Problem
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.grammar import Grammar
from intent_engine.language.loading.grammar_file import load_grammars
from intent_engine.language.loading.grammar_parts import plain_phrase
from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning import Interpreter
from intent_engine.language.meaning.dictation import Dictated
from intent_engine.language.nearest import Nearest
from intent_engine.language.references import Before, resolve
from intent_engine.language.utterance import Utterance, plain
from intent_engine.language_tag import code_of, language_of
from intent_engine.needs import MOVING, states_of
from intent_engine.resources import find

if TYPE_CHECKING:
    from intent_engine.language.explanation import Explanation
    from intent_engine.language.locations import LocationMap
    from intent_engine.language.word_state import WordState

__all__ = ["IntentEngine", "Prefix", "PrefixStatus"]

StrPath = str | os.PathLike[str]


class PrefixStatus(StrEnum):
    """How far words that may go on have come."""

    IMPOSSIBLE = "impossible"
    """No utterance of the grammar begins so; commands with nothing between them are not looked ahead to."""
    INCOMPLETE = "incomplete"
    """More words are needed."""
    EXTENDABLE = "extendable"
    """A whole command, that further words could still change ("turn left" + "ninety degrees")."""
    COMPLETE = "complete"
    """A whole command that nothing can change; only another command can follow."""


@dataclass(frozen=True, slots=True)
class Prefix:
    """What :meth:`IntentEngine.prefix` says of partial text."""

    status: PrefixStatus
    next_words: tuple[str, ...] = ()
    """Words that may follow, in alphabetical order; ``<number>`` where a numeral may, ``<any>`` where any word may."""
    known_words: int = 0
    """How many of the words could be followed."""
    settled: bool = False
    """A whole command of which further words could only change the manner, as a speed does: what is to be done is
    said."""
    resting: bool = False
    """A whole command that ends in a quantity which people like to add to after a rest: "in an hour", "and a half"."""


@dataclass(frozen=True)
class _Loaded:
    """Everything made from one state of the files; replaced as a whole, so that a parse never sees two."""

    grammars: tuple[Grammar, ...]
    locations: LocationMap | None
    interpreters: Mapping[str, Interpreter]


class IntentEngine:
    """A grammar and a map, ready to understand text.

    All methods are thread-safe; :meth:`reload` swaps everything at once.
    """

    def __init__(self, grammars: Sequence[Grammar], locations: LocationMap | None = None) -> None:
        self._lock = threading.Lock()
        self._grammar_paths: tuple[Path, ...] = ()
        self._location_paths: tuple[Path, ...] = ()
        self._wake: tuple[tuple[str, ...], ...] = ()
        loaded = tuple(grammars) if not isinstance(grammars, str | os.PathLike) else ()
        if not loaded or not all(isinstance(grammar, Grammar) for grammar in loaded):
            raise TypeError("IntentEngine takes grammars that are read; IntentEngine.from_files(...) reads files")
        if locations is not None:
            from intent_engine.language.locations import LocationMap

            if not isinstance(locations, LocationMap):
                how = "LocationMap.from_mapping(...) or load(path) of intent_engine.language.locations"
                raise TypeError(f"IntentEngine takes a map that is read, not {locations!r:.80}; {how} reads one")
        self._use(_build(loaded, locations))

    @classmethod
    def from_files(
        cls,
        grammar: StrPath | Sequence[StrPath],
        *,
        locations: StrPath | Sequence[StrPath] | LocationMap | Mapping[str, Any] | None = None,
        wake: str | Sequence[str] = (),
    ) -> IntentEngine:
        """Load grammar files and a map.

        Args:
            grammar: one path or several, or bare names of shipped grammars (``"en"``); files of one language make one
                grammar.
            locations: a map file or several, or names of shipped ones (``"home"``); a map already loaded; or a
                dictionary of places (``{"kitchen": (5.0, 2.0, 0.0)}``).
            wake: with one of these a spoken command must begin, beside the ``wake`` of the files. A stop never must.

        Raises:
            ConfigError: with everything that is wrong in any file.
            TypeError: ``grammar`` or ``locations`` is nothing that names files, nor a map; or ``wake`` holds no text.
        """
        engine = cls.__new__(cls)
        engine._lock = threading.Lock()
        problems: list[Problem] = []
        engine._grammar_paths = _found("grammars", grammar, problems)
        engine._location_paths = ()
        engine._wake = tuple(plain_phrase(text) for text in _wake_words(wake))
        given: LocationMap | None = None
        if isinstance(locations, (str, os.PathLike)) or (
            isinstance(locations, Sequence) and not isinstance(locations, Mapping)
        ):
            engine._location_paths = _found("locations", locations, problems)
        elif locations is not None:
            from intent_engine.language.locations import LocationMap

            if not isinstance(locations, Mapping):
                raise TypeError(f"locations are files or a dictionary of places, not {type(locations).__name__}")
            given = locations if isinstance(locations, LocationMap) else LocationMap.from_mapping(locations)
        engine._use(engine._load(given, problems))
        return engine

    def _load(self, given: LocationMap | None, missing: Sequence[Problem] = ()) -> _Loaded:
        """Everything in the files, but for those that are ``missing``.

        Raises:
            ConfigError: with these, and with everything that is wrong in the others.
        """
        problems = list(missing)
        grammars: tuple[Grammar, ...] = ()
        places = given
        if self._grammar_paths or not missing:
            try:
                grammars = load_grammars(self._grammar_paths)
            except ConfigError as error:
                problems.extend(error.problems)
        if self._location_paths:
            from intent_engine.language.locations import load

            try:
                places = load(self._location_paths)
            except ConfigError as error:
                problems.extend(error.problems)
        if problems:
            raise ConfigError(problems)
        if self._wake:
            grammars = tuple(replace(grammar, wake=(*grammar.wake, *self._wake)) for grammar in grammars)
        return _build(grammars, places)

    def _use(self, loaded: _Loaded) -> None:
        self._loaded = loaded
        self._parsers = tuple(loaded.interpreters.values())

    def reload(self) -> None:
        """Read the files again. Parses under way finish with the old grammar; all later ones use the new.

        Raises:
            ConfigError: something is wrong; the old grammar stays in use.
        """
        with self._lock:
            given = None if self._location_paths else self._loaded.locations
            self._use(self._load(given))

    def __reduce__(self) -> str:
        raise TypeError(
            "an IntentEngine holds a lock and cannot be copied or pickled: share it between threads, and "
            "make one with IntentEngine.from_files(...) in each process"
        )

    # -- what it holds ----------------------------------------------------------------------------------------

    @property
    def grammars(self) -> tuple[Grammar, ...]:
        return self._loaded.grammars

    @property
    def grammar(self) -> Grammar:
        """The grammar of the first language."""
        return self._loaded.grammars[0]

    @property
    def languages(self) -> tuple[str, ...]:
        return tuple(self._loaded.interpreters)

    @property
    def states(self) -> frozenset[str]:
        """States of a robot that change what is understood: those of ``requires`` and ``excludes``, and ``moving``."""
        named = (intent.requires | intent.excludes for one in self.grammars for intent in one.intents.values())
        return frozenset({MOVING}).union(*named)

    @property
    def locations(self) -> LocationMap | None:
        return self._loaded.locations

    @property
    def files(self) -> tuple[Path, ...]:
        """Every file that was read, for watching."""
        found = [Path(name) for grammar in self._loaded.grammars for name in grammar.files]
        return (*found, *self._location_paths)

    def matcher(self, language: str | None = None) -> Matcher:
        """The automaton of a language, for looking ahead, sampling and checking."""
        return self._interpreter(language).matcher

    def _interpreter(self, language: str | None) -> Interpreter:
        if language is None:
            return self._parsers[0]
        if not isinstance(language, str):
            raise TypeError(f"a language is given by its tag, as 'en', not as {language!r:.80}")
        interpreter = self._loaded.interpreters.get(language_of(language))
        if interpreter is None:
            there = ", ".join(self.languages)
            named = code_of(language)
            hint = f"ask for one of these, or load a grammar with language: {named or language or 'fr'}"
            if named in self.languages:
                hint = f"write {named!r}"
            raise ConfigError(Problem(f"no grammar of language {language!r} is loaded; there is {there}", hint=hint))
        return interpreter

    # -- understanding ----------------------------------------------------------------------------------------

    def parse(
        self,
        text: str,
        *,
        state: Collection[str] = (),
        language: str | None = None,
        spoken: bool = False,
        last: Before | None = None,
    ) -> Interpretation:
        """What a text means. Never raises on text; the same text gives the same interpretation.

        Args:
            text: an utterance, as typed or as a recogniser wrote it.
            state: states that the robot is in, for intents that require or exclude some (``moving`` makes
                every utterance that begins with a stop word a stop). A text is the one state of that name.
            language: which grammar to use; None: the first that accepts it.
            spoken: whether the wake word is needed, where the grammar has one.
            last: the interpretation of the utterance before, which "again" and "it" point to; "again" is refused in
                states in which that could not be said. Or only its actions, or the one that it was: then nobody asks.
                Empty if there was none; None: not known, then such words are left as they are.

        Raises:
            TypeError: ``text`` is no ``str``, or ``last`` holds what is no action.
        """
        _only_text("parse", text)
        parsers = self._parsers if language is None else (self._interpreter(language),)
        return _understood(parsers, text, state, spoken, last)[0]

    def explain(
        self,
        text: str,
        *,
        state: Collection[str] = (),
        language: str | None = None,
        spoken: bool = False,
        last: Before | None = None,
    ) -> Explanation:
        """How :meth:`parse` comes to its interpretation, step by step. The arguments are the same."""
        from intent_engine.language.explain import Witness

        _only_text("explain", text)
        parsers = self._parsers if language is None else (self._interpreter(language),)
        found, witness = _understood([Witness(parser) for parser in parsers], text, state, spoken, last)
        return witness.explanation(found)

    def dictated(self, text: str, *, language: str | None = None) -> Dictated | None:
        """What is dictated in a text, with the words before it; None: nothing is."""
        _only_text("dictated", text)
        return self._interpreter(language).dictated(text)

    def comes_later(self, text: str, *, language: str | None = None) -> bool:
        """Whether a text begins with words that say that something else is done first: "then turn left", "when you get
        there, turn left". Fillers may stand before several such words, but not before one: "okay then, turn left"."""
        _only_text("comes_later", text)
        parsers = self._parsers if language is None else (self._interpreter(language),)
        return any(parser.phrases.comes_later(plain(text)) for parser in parsers)

    def prefix(self, text: str, *, language: str | None = None) -> Prefix:
        """How far partial text has come, and how it may go on."""
        _only_text("prefix", text)
        matcher = self.matcher(language)
        said = Utterance.of(text, matcher.grammar.language) if len(text) < 2000 else Utterance(["\0"], [False])
        words = said.words
        try:
            count, reached = matcher.prefix(words)
            if reached is None and (otherwise := matcher.spacing.otherwise(said)) is not None:
                words = otherwise.words
                count, reached = matcher.prefix(words)
        except ConfigError:  # see parse
            count, reached = 0, None
        if reached is None:
            return (
                Prefix(PrefixStatus.EXTENDABLE, (), len(words))
                if self._interpreter(language).dictates(text)
                else Prefix(PrefixStatus.IMPOSSIBLE, (), count)
            )
        status = _status(matcher, reached)
        settled = status is not PrefixStatus.INCOMPLETE and matcher.settled(words)
        resting = status is PrefixStatus.EXTENDABLE and matcher.resting(words)
        return Prefix(status, next_words(matcher, reached), count, settled, resting)


def _wake_words(given: str | Sequence[str]) -> Sequence[str]:
    """One text is a list of one: each of its letters would wake the robot, and what it is called would not."""
    words = [given] if isinstance(given, str) else given
    if isinstance(words, Mapping) or not isinstance(words, Collection) or not all(isinstance(w, str) for w in words):
        raise TypeError(f"wake words are texts in a list, as ['robot'], not {given!r:.80}")
    if silent := [word for word in words if not any(map(str.isalnum, word))]:
        raise ConfigError(Problem(f"the wake word {silent[0]!r} has no letters", hint="give a name, as 'robot'"))
    return list(words)


def _only_text(method: str, text: object) -> None:
    if not isinstance(text, str):
        raise TypeError(f"{method} takes a str, not {type(text).__name__}")


class _Parses(Protocol):
    """What understands the text of one language: an interpreter, or a witness of one."""

    matcher: Matcher

    def interpret(self, text: str, state: Collection[str] = (), *, spoken: bool = False) -> Interpretation: ...


_Parser = TypeVar("_Parser", bound=_Parses)


def _understood(
    parsers: Sequence[_Parser],
    text: str,
    state: Collection[str],
    spoken: bool,
    last: Before | None,
) -> tuple[Interpretation, _Parser]:
    """What a text means, with what it points back to, and the parser that says so."""
    state = states_of(state)
    asked = last.needs if isinstance(last, Interpretation) else ()
    if isinstance(last, Interpretation):
        last = last.actions
    before = None if last is None else actions_of("last", last)
    parser = parsers[0]
    try:
        if len(parsers) == 1:
            found = parser.interpret(text, state, spoken=spoken)
        else:
            found, parser = _first_accepted(parsers, text, state, spoken)
    except ConfigError as error:  # a grammar too ambiguous to be walked; a text is never the cause
        return Interpretation(text, Status.REJECTED, reason=str(error)), parser
    if before is not None or len(found.actions) > 1:
        found = resolve(found, before, parser.matcher.grammar.operators.pronoun, asked, state)
    return found, parser


def _first_accepted(
    parsers: Sequence[_Parser], text: str, state: Collection[str], spoken: bool
) -> tuple[Interpretation, _Parser]:
    """The interpretation of the first language that accepts a text; else the one that says most about it."""
    first: tuple[Interpretation, _Parser] | None = None
    for parser in parsers:
        found = parser.interpret(text, state, spoken=spoken)
        if found.status is Status.ACCEPTED:
            return found, parser
        if first is None or (first[0].status is Status.REJECTED and found.status is not Status.REJECTED):
            first = found, parser
    assert first is not None
    return first


def _status(matcher: Matcher, reached: WordState) -> PrefixStatus:
    automaton = matcher.spoken
    if not automaton.accepting(reached):
        return PrefixStatus.INCOMPLETE
    return PrefixStatus.EXTENDABLE if automaton.inside(reached) else PrefixStatus.COMPLETE


def next_words(matcher: Matcher, reached: WordState) -> tuple[str, ...]:
    """The words that may follow a state, for showing."""
    automaton = matcher.spoken
    words = sorted(word for word in automaton.next_words(reached) if word and word[0] != "\0")
    if automaton.allows_digits(reached):
        words.append("<number>")
    if automaton.free(reached):
        words.append("<any>")
    return tuple(words)


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


def _build(grammars: tuple[Grammar, ...], locations: LocationMap | None) -> _Loaded:
    interpreters = {}
    for grammar in grammars:
        matcher = Matcher(grammar, locations)
        interpreters[grammar.language] = Interpreter(matcher, Nearest(matcher))
    return _Loaded(grammars, locations, interpreters)
