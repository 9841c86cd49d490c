"""Text in, interpretation out: the one object that most users need."""

from __future__ import annotations

import threading
from collections.abc import Collection, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from intent_engine.engine_files import EngineFiles, Loaded, StrPath
from intent_engine.errors import ConfigError, Problem
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.context.references import Before
from intent_engine.language.context.understanding import Understanding
from intent_engine.language.grammar import Grammar
from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning import Interpreter
from intent_engine.language.meaning.comes_later import comes_later
from intent_engine.language.meaning.dictation import Dictated
from intent_engine.language.utterance import plain
from intent_engine.needs import MOVING, states_of
from intent_engine.prefix import Prefix, PrefixStatus, prefix_of

if TYPE_CHECKING:
    from intent_engine.language.explanation import Explanation
    from intent_engine.language.locations import LocationMap

__all__ = ["IntentEngine", "Prefix", "PrefixStatus"]


class IntentEngine:
    """A grammar and a map, ready to understand text.

    All methods are thread-safe; :meth:`reload` swaps everything at once.
    """

    def __init__(self, grammars: Sequence[Grammar], locations: LocationMap | None = None) -> None:
        loaded = tuple(grammars) if isinstance(grammars, Iterable) and not isinstance(grammars, str) else ()
        if not loaded or not all(isinstance(grammar, Grammar) for grammar in loaded):
            raise TypeError("IntentEngine takes grammars that are read; IntentEngine.from_files(...) reads files")
        if locations is not None:
            from intent_engine.language.locations import LocationMap

            if not isinstance(locations, LocationMap):
                how = "LocationMap.from_mapping(...) or load(path) of intent_engine.language.locations"
                raise TypeError(f"IntentEngine takes a map that is read, not {locations!r:.80}; {how} reads one")
        self._begin(EngineFiles(places=locations), Loaded.of(loaded, locations))

    def _begin(self, files: EngineFiles, loaded: Loaded) -> None:
        self._lock = threading.Lock()
        self._files = files
        self._loaded = loaded

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
        files = EngineFiles.found(grammar, locations, wake)
        engine = cls.__new__(cls)
        engine._begin(files, files.read())
        return engine

    def reload(self) -> None:
        """Read the files again. Parses under way finish with the old grammar; all later ones use the new.

        Raises:
            ConfigError: something is wrong, or the engine was not made from files; the old grammar stays in use.
        """
        if not self._files.grammars:
            hint = "IntentEngine.from_files(...) makes one that can be reloaded"
            raise ConfigError(Problem("there are no files to read again: the engine was made from grammars", hint=hint))
        with self._lock:
            self._loaded = self._files.read()

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
        return (*found, *self._files.locations)

    def matcher(self, language: str | None = None) -> Matcher:
        """The automaton of a language, for looking ahead, sampling and checking."""
        return self._interpreter(language).matcher

    def _interpreter(self, language: str | None) -> Interpreter:
        return self._loaded.parsers(language)[0]

    # -- understanding ----------------------------------------------------------------------------------------

    def parse(
        self,
        text: str,
        *,
        state: Collection[str] = (),
        language: str | None = None,
        spoken: bool = False,
        heard: bool = False,
        last: Before | None = None,
    ) -> Interpretation:
        """What a text means. Never raises on text; the same text gives the same interpretation.

        Args:
            text: an utterance, as typed or as a recogniser wrote it.
            state: states that the robot is in, for intents that require or exclude some (``moving`` makes
                every utterance that begins with a stop word a stop). A ``str`` counts as the one state of that name.
            language: which grammar to use; None: the first that accepts it.
            spoken: whether the wake word is needed, where the grammar has one. What is spoken was heard.
            heard: whether a recogniser wrote it, so that "turned left" may be "turn left". Typed, it tells of
                something, and nothing is done. For text that is no command, the nearest sentences are offered only if
                it was typed: what is heard may be talk.
            last: the interpretation of the utterance before, which "again" and "it" point to; "again" is refused in
                states in which that could not be said. If that asked something back ("bay 3 or bay 13?"), a text that
                answers it ("the second one") is understood as the sentence that it stands for; how long a question
                lasts is for the caller to say. Its actions alone, or its only action, may be given instead: then
                "again" is not refused in any state, and no question is answered. Empty if there was none; None: not
                known, then such words are left as they are.
                After an interpretation "not the kitchen" has what it denies.

        Raises:
            TypeError: ``text`` is no ``str``, or ``last`` holds what is no action.
        """
        _only_text("parse", text)
        parsers = self._loaded.parsers(language)
        return Understanding(parsers, last, states_of(state), spoken, heard).of(text)[0]

    def answer(
        self,
        asked: Interpretation,
        text: str,
        *,
        state: Collection[str] = (),
        language: str | None = None,
        spoken: bool = False,
        heard: bool = False,
    ) -> Interpretation | None:
        """What a text means as the answer to what an interpretation asks back; None: it is no answer, and :meth:`parse`
        says what it means by itself. :meth:`parse` with ``asked`` as its ``last`` understands both, but does not tell
        which of them a text was. The other arguments are those of :meth:`parse`.

        Returns:
            Accepted, if it tells one alternative: its ``text`` is the whole sentence that is meant. Else nothing is
            done: it may ask again, or say that nothing of it is meant, or cannot be done in these states.

        Raises:
            TypeError: ``asked`` is no interpretation, or ``text`` no ``str``.
            ConfigError: no grammar of that language is loaded.
        """
        if not isinstance(asked, Interpretation):
            raise TypeError(f"answer takes the interpretation that asks, as parse gave it, not {asked!r:.80}")
        _only_text("answer", text)
        parsers = self._loaded.parsers(language)
        return Understanding(parsers, asked, states_of(state), spoken, heard).answer(text)

    def explain(
        self,
        text: str,
        *,
        state: Collection[str] = (),
        language: str | None = None,
        spoken: bool = False,
        heard: bool = False,
        last: Before | None = None,
    ) -> Explanation:
        """How :meth:`parse` comes to its interpretation, step by step. The arguments are the same."""
        from intent_engine.language.explain import Witness

        _only_text("explain", text)
        witnesses = [Witness(parser) for parser in self._loaded.parsers(language)]
        found, witness = Understanding(witnesses, last, states_of(state), spoken, heard).of(text)
        return witness.explanation(found)

    def in_own_words(self, text: str, *, state: Collection[str] = (), language: str | None = None) -> tuple[str, ...]:
        """The words in which the grammar has the one command of a text that was heard: of "haul that rock over to the
        dump" those of "haul the rock to the dump". Empty: it is none, or several.

        Args:
            text: what was heard.
            state: as for :meth:`parse`.
            language: of the grammar; None: the first.
        """
        _only_text("in_own_words", text)
        found, parts = self._interpreter(language).understand(text, states_of(state), heard=True)
        if found.status is not Status.ACCEPTED or len(parts) != 1 or parts[0].reading is None:
            return ()
        return tuple(parts[0].reading.words)

    def dictated(self, text: str, *, language: str | None = None) -> Dictated | None:
        """What is dictated in a text, with the words before it; None: nothing is."""
        _only_text("dictated", text)
        return self._interpreter(language).dictated(text)

    def comes_later(self, text: str, *, language: str | None = None) -> bool:
        """Whether a text begins with words that say that something else is done first, or its first command ends with
        them: "then turn left", "when you get there, turn left", "turn left next". Fillers may stand before several such
        words, but not before one: "okay then, turn left"."""
        _only_text("comes_later", text)
        parsers = self._loaded.parsers(language)
        return any(comes_later(plain(text), parser.phrases, parser.matcher) for parser in parsers)

    def takes_back(self, text: str, *, language: str | None = None) -> bool:
        """Whether a text begins with words that take back what was said before: "no", "I mean". Whatever it means
        besides, what was said before was not meant, and nothing of it is to be done again."""
        _only_text("takes_back", text)
        parsers = self._loaded.parsers(language)
        return any(parser.phrases.takes_back(plain(text)) for parser in parsers)

    def prefix(self, text: str, *, language: str | None = None, spoken: bool = False) -> Prefix:
        """How far partial text has come, and how it may go on.

        Args:
            text: of the beginning of an utterance, or of a whole one.
            language: of the text; None: the first grammar's.
            spoken: whether a whole command may have a word that only sounds like one of the grammar ("go back for
                meters"), as a recogniser writes it.
        """
        _only_text("prefix", text)
        return prefix_of(self._interpreter(language), text, spoken=spoken)


def _only_text(method: str, text: object) -> None:
    if not isinstance(text, str):
        raise TypeError(f"{method} takes a str, not {type(text).__name__}")
