"""Grammar files: YAML to a checked :class:`Grammar`. Everything wrong is found at load, and all of it at once."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from typing import Any

from intent_engine.errors import ConfigError, Problem
from intent_engine.language.grammar import Grammar, Intent, Operators, Place, Slot
from intent_engine.language.loading.contracted import with_contractions
from intent_engine.language.loading.file_kind import given_for
from intent_engine.language.loading.grammar_checks import check_meaning
from intent_engine.language.loading.grammar_intents import merged, read_intent
from intent_engine.language.loading.grammar_parts import Draft, PartReader, Places
from intent_engine.language.loading.grammar_slots import read_slot
from intent_engine.language.loading.language_words import (
    default_another,
    default_around,
    default_counted,
    default_counting,
    default_denying,
    default_fillers,
    default_heard,
    default_operators,
    default_wording,
)
from intent_engine.language.loading.schema_problems import schema_problems
from intent_engine.language.loading.wake_stops import wake_that_stops
from intent_engine.language.loading.yaml_source import YamlPath, YamlSource, near_file, read_yaml
from intent_engine.language.normalize import words_of
from intent_engine.language.templates.spellings import own_homophones, own_words, stops_by_sound
from intent_engine.language.templates.template_tree import Node
from intent_engine.language.wording import Wording
from intent_engine.language.words.as_written import as_written, texts_in
from intent_engine.language_tag import language_of

__all__ = ["load_grammars", "schema"]

_ROOM = Path(__file__).parent.parent
"""Where the files of languages lie."""


@cache
def schema() -> dict[str, Any]:
    """The JSON Schema of a grammar file."""
    text = (_ROOM / "grammar.schema.json").read_text("utf-8")
    loaded: dict[str, Any] = json.loads(text)
    return loaded


def load_grammars(paths: str | Path | Sequence[str | Path]) -> tuple[Grammar, ...]:
    """Read grammar files and what they include; files of one language make one grammar.

    Returns:
        One grammar for each language, in the order in which the languages are first met.

    Raises:
        ConfigError: with every problem of every file.
    """
    names = [paths] if isinstance(paths, (str, Path)) else list(paths)
    if not names:
        raise ConfigError("no grammar file was given")
    sources, blind = _gather([Path(name) for name in names])
    builders: dict[str, _Builder] = {}
    for source in sources:
        if isinstance(source.data, dict):
            language = _language(source)
            builders.setdefault(language, _Builder(language, blind)).add(source)
    for builder in builders.values():
        builder.add_intents()
    finished = [builder.finish() for builder in builders.values()]
    order = {source.file: place for place, source in enumerate(sources)}
    problems = [problem for source in sources for problem in source.problems]
    problems.extend(problem for _, found in finished for problem in found)
    if problems:
        problems.sort(key=lambda problem: (order.get(problem.file or "", -1), problem.line or 0, problem.column or 0))
        raise ConfigError(problems, [file for source in sources for file in (source.file, *source.absent)])
    return tuple(grammar for grammar, _ in finished)


# -- files ----------------------------------------------------------------------------------------------------


def _gather(paths: Sequence[Path]) -> tuple[list[YamlSource], bool]:
    """The files and those that they include, each once; an included file comes before the one that includes it.

    Returns:
        The files, and whether names may be defined where nobody could read them.
    """
    done: dict[Path, YamlSource] = {}
    blind = False

    def visit(path: Path, above: tuple[Path, ...]) -> None:
        nonlocal blind
        try:
            resolved = path.resolve()
        except (OSError, RuntimeError, ValueError):  # links that lead to themselves, bytes that no name can have
            resolved = path.absolute()
        if resolved in done:
            return
        source = read_yaml(path)
        if (other := given_for("grammar", source.data, source.file)) is not None:
            source.problems.append(other)
            source.data = None
        if source.data is not None:
            source.problems.extend(schema_problems(source, schema()))
        if isinstance(source.data, dict):
            for at, _, name in source.entries(("include",), source.data.get("include")):
                if ("include",) in source.broken:
                    break
                onward = _included(source, at, name)
                if onward is None:
                    blind = True
                    continue
                chain = (*above, resolved)
                if onward.resolve() in chain:
                    names = " -> ".join(one.name for one in (*chain[chain.index(onward.resolve()) :], onward))
                    source.problem(at, f"files include each other in a circle: {names}", "remove one of the includes")
                else:
                    visit(onward, chain)
        hidden = any(path[:1] == ("include",) or path[-1:] in (("slots",), ("phrases",)) for path in source.broken)
        blind = blind or hidden or not isinstance(source.data, dict)
        done[resolved] = source

    for path in paths:
        visit(path, ())
    return list(done.values()), blind


def _shipped(path: Path, name: str) -> str | None:
    """The name of the grammar that comes with the engine and that ``grammars/en.yaml`` or ``en.yaml`` means; None for
    other files."""
    from intent_engine.resources import find

    if path.suffix != ".yaml" or (path.parent.name != "grammars" and name != path.name):
        return None
    try:
        return path.stem if find("grammars", path.stem).is_file() else None
    except ConfigError:
        return None


def _included(source: YamlSource, at: YamlPath, name: str) -> Path | None:
    """The file that an ``include`` names: beside the file that names it, or a shipped grammar by its bare name."""
    path = Path(source.file).parent / name
    try:
        if path.is_file():
            return path
        if path.is_symlink():
            source.absent.append(str(path))
            message = f"{path} is a link to {path.readlink()}, which is not there"
            source.problem(at, message, "mend the link, or include another file")
            return None
    except OSError as error:  # a name that is longer than any file's
        source.problem(at, f"this file cannot be included: {error.strerror}", "give the path of a grammar file")
        return None
    source.absent.append(str(path))
    if Path(name).suffix == "" and "/" not in name:
        from intent_engine.resources import find

        try:
            return find("grammars", name)
        except ConfigError as error:
            hint = near_file(path) or error.problems[0].hint
            source.problem(at, f"there is no grammar {name!r} to include", hint)
            return None
    if (shipped := _shipped(path, name)) is not None:
        source.problem(at, f"there is no file {path} to include", f"the one that comes with the engine is {shipped!r}")
        return None
    hint = near_file(path) or "the path is taken from this file's folder"
    source.problem(at, f"there is no file {path} to include", hint)
    return None


def _language(source: YamlSource) -> str:
    language = source.data.get("language", "en")
    return language_of(language) if isinstance(language, str) and ("language",) not in source.broken else "en"


def _said_in(language: str, phrases: Iterable[str]) -> tuple[tuple[str, ...], ...]:
    """Plain phrases as normalised words, in every form in which they are said."""
    return with_contractions(map(words_of, phrases), language)


@cache
def _usual_wording(language: str) -> Wording:
    """How commands are put, which no grammar changes: made once for all of a language."""
    return default_wording(language, partial(_said_in, language))


class _Builder:
    """Gathers the files of one language."""

    def __init__(self, language: str, blind: bool) -> None:
        self.language = language
        self.draft = Draft(language, blind=blind)
        self.fillers: list[str] | None = None
        """None: no file says anything of them."""
        self.wake: list[str] = []
        self.phrases: dict[str, Node] = {}
        self.slots: dict[str, Slot] = {}
        self.intents: dict[str, Intent] = {}
        self.operators: dict[str, list[str]] = {key: list(items) for key, items in default_operators(language).items()}
        self.alikes: dict[str, tuple[str, ...]] = {}
        self.parts: list[PartReader] = []

    def add(self, source: YamlSource) -> None:
        """Read all of a file but its intents."""
        parts = PartReader(source, self.draft)
        self.parts.append(parts)
        for at, name, templates in _section(source, "phrases"):
            if self._once(source, at, name):
                node = parts.alternatives(at, templates, "phrase", name)
                if node is not None:
                    self.phrases[name] = node
                else:
                    self.draft.broken.add(name)
        for at, name, spec in _section(source, "slots"):
            if self._once(source, at, name):
                slot = read_slot(parts, at, name, spec)
                if slot is not None:
                    self.slots[name] = slot
                else:
                    self.draft.broken.add(name)
        for section in ("phrases", "slots"):
            self.draft.broken.update(str(path[1]) for path in source.broken if path[:1] == (section,) and len(path) > 1)
        if "fillers" in source.data:
            self.fillers = [*(self.fillers or ()), *parts.plain(("fillers",), source.data["fillers"])]
        self.wake.extend(parts.plain(("wake",), source.data.get("wake")))
        for at, key, items in _section(source, "operators"):
            self.operators.setdefault(key, []).extend(parts.plain(at, items))
        for at, heard, meant in _section(source, "sound_alikes"):
            words = [heard, *(text for _, _, text in source.entries(at, meant))]
            if any(len(words_of(word)) != 1 for word in words):
                source.problem(at, "sound-alikes are single words", "heard: [meant, meant]", key=True)
            else:
                self.alikes[words_of(heard)[0]] = tuple(words_of(word)[0] for word in words[1:])
        lost = (path for path in source.broken if len(path) == 1 or (len(path) == 2 and "intents" in path))
        self.draft.mute = self.draft.mute or any(lost)

    def add_intents(self) -> None:
        """Read the intents of all files, once the slots of all files are known."""
        known = Grammar(self.language, (), self.phrases, self.slots, self.intents, Operators())
        for parts in self.parts:
            for at, name, spec in _section(parts.source, "intents"):
                intent = read_intent(parts, at, name, spec, known)
                old = self.intents.get(name)
                if old is None:
                    self.intents[name] = intent
                    continue
                if old.action != intent.action and name not in self.draft.partial:
                    message = f"intent {name!r} already exists with another action{_where(old.place, parts.source)}"
                    hint = "write its action as there to add to it, or give this one another name"
                    parts.source.problem(at, message, hint, key=True)
                if old.lark and intent.lark:
                    message = f"intent {name!r} has a lark grammar already"
                    parts.source.problem((*at, "lark"), message, "one intent has one; add rules to that", key=True)
                self.intents[name] = merged(old, intent)

    def _once(self, source: YamlSource, path: YamlPath, name: str) -> bool:
        kind = "slot" if name in self.slots else "phrase" if name in self.phrases else None
        if kind is not None:
            at = (f"{kind}s", name)
            first = next((parts.source for parts in self.parts if at in parts.source.key_marks), source)
            message = f"{name!r} is already the name of a {kind}{_where(first.place(at, key=True), source)}"
            hint = "give it another name"
            if first.file != source.file:
                hint += ", and use it in sentences of your own; the other can be changed only in a copy of its file"
            source.problem(path, message, hint, key=True)
        return kind is None

    def _alikes_of(self, grammar: Grammar) -> dict[str, tuple[str, ...]]:
        """Words that recognisers write for others, but for those of every grammar of the language that this one has a
        use for: where something can be lifted, "lift" is no "left"."""
        heard_for = default_heard(self.language)
        own = own_words(grammar) - heard_for.maybe_numbers
        usual = {**heard_for.meant, **default_another(self.language)}
        return {**{heard: meant for heard, meant in usual.items() if heard not in own}, **self.alikes}

    def finish(self) -> tuple[Grammar, list[Problem]]:
        """The grammar, and what is wrong with its meaning."""
        operators = {key: self._said(texts) for key, texts in self.operators.items()}
        closed = {
            words[0]
            for key in ("negation", "closed", "sequence", "contrast", "stop", "correction")
            for words in operators.get(key, ())
            if len(words) == 1
        }
        grammar = Grammar(
            language=self.language,
            fillers=self._said(self._fillers()),
            around=self._beside_numbers(default_around(self.language)),
            counting=self._beside_numbers(default_counting(self.language)),
            counted=self._beside_numbers(default_counted(self.language)),
            wording=self._wording(),
            phrases=self.phrases,
            slots=self.slots,
            intents=self.intents,
            operators=Operators(
                **{key: tuple(words for words in rows if words) for key, rows in operators.items() if key != "closed"},
                closed=frozenset(closed),
            ),
            sound_alikes=self.alikes,
            wake=tuple(words_of(text) for text in self.wake),
            as_written=self._as_written(),
            files=tuple(parts.source.file for parts in self.parts),
        )
        for parts in self.parts:
            for at, _, text in _section(parts.source, "wake"):
                if wrong := wake_that_stops(words_of(text), grammar.operators):
                    parts.source.problem(at, *wrong)
        problems, warnings = check_meaning(grammar, Places([parts.source for parts in self.parts]), self.draft)
        return replace(
            grammar,
            operators=replace(grammar.operators, stop_by_sound=stops_by_sound(grammar)),
            sound_alikes=self._alikes_of(grammar),
            homophones=own_homophones(grammar),
            warnings=tuple(warnings),
        ), problems

    def _fillers(self) -> tuple[str, ...]:
        """What says nothing, wherever it stands: a file's own, or those of the language; none where it wants none."""
        if self.fillers == []:
            return ()
        own = default_fillers(self.language) if self.fillers is None else self.fillers
        apart = map(" ".join, _usual_wording(self.language).fillers_apart)
        return (*own, *default_denying(self.language), *apart)

    def _wording(self) -> Wording:
        """The usual one, in which fillers of a file's own are no others."""
        usual, own = _usual_wording(self.language), frozenset(self._said(self.fillers or ()))
        if own.isdisjoint(usual.fillers_apart):
            return usual
        return replace(usual, fillers_apart=tuple(words for words in usual.fillers_apart if words not in own))

    def _said(self, phrases: Iterable[str]) -> tuple[tuple[str, ...], ...]:
        return _said_in(self.language, phrases)

    def _beside_numbers(self, phrases: Iterable[str]) -> tuple[tuple[str, ...], ...]:
        """What says nothing beside a number, whatever a file has for fillers: none where it wants none at all. A filler
        of its own says nothing anywhere."""
        own = frozenset(self._said(self.fillers or ()))
        return () if self.fillers == [] else tuple(words for words in self._said(phrases) if words not in own)

    def _as_written(self) -> dict[str, str]:
        """Words that are written with a capital or an apostrophe in values, sentences and examples."""
        found: dict[str, str] = {}
        for parts in self.parts:
            sections = [parts.source.data.get(name) for name in ("slots", "phrases", "intents")]
            slots, phrases, intents = ([*one.values()] if isinstance(one, dict) else [] for one in sections)
            specs = [spec for spec in intents if isinstance(spec, dict)]
            said = [*phrases, *(spec.get(key) for spec in specs for key in ("sentences", "then", "examples"))]
            found |= as_written(texts_in(slots)) | as_written(texts_in(said), sentences=True)
        return found


def _where(place: Place | None, source: YamlSource) -> str:
    """Where something stands, seen from a file."""
    if place is None:
        return ""
    return f" (line {place.line})" if place.file == source.file else f" ({place.file}:{place.line})"


def _section(source: YamlSource, name: str) -> list[tuple[YamlPath, Any, Any]]:
    """The sound entries of a section of a file."""
    return [] if (name,) in source.broken else list(source.entries((name,), source.data.get(name)))
