"""What of a grammar the tests reach: intents, sentences and slots.

Every interpretation is watched, whoever asks for it, so that a user's own tests count as well as examples. Where
several processes test, each tells what it missed, and what all of them missed is told in the end.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.grammar import Grammar, Intent, Place
from intent_engine.language.meaning import Interpreter, Understood
from intent_engine.language.reading import Reading
from intent_engine.language.templates.template_tree import Node, references
from intent_engine.language.utterance import Utterance
from intent_engine.resources import is_shipped

__all__ = ["Coverage", "Missed"]


@dataclass(frozen=True, slots=True)
class Missed:
    """A part of a grammar that no test reached."""

    kind: str
    """``intent``, ``sentence`` or ``slot``."""
    intent: str
    name: str
    """Of the intent or slot; of a sentence its template."""
    place: Place | None


@dataclass
class _Seen:
    """What was reached of one grammar."""

    grammar: Grammar
    intents: set[str] = field(default_factory=set)
    sentences: set[tuple[str, str]] = field(default_factory=set)
    slots: set[tuple[str, str]] = field(default_factory=set)


@dataclass(frozen=True, slots=True)
class _Report:
    """What was reached of one grammar."""

    title: str
    totals: Mapping[str, int]
    """By the kind of a part: how many there are."""
    missed: Sequence[Missed]
    included: Sequence[str] = ()
    """Files that come with the engine, where a grammar of somebody else includes them: they have tests of their own."""

    def beside(self, other: _Report) -> _Report:
        """What neither of two processes reached."""
        known = set(other.missed)
        return replace(self, missed=[part for part in self.missed if part in known])


class Coverage:
    """Watches every parse between :meth:`start` and :meth:`stop`."""

    def __init__(self) -> None:
        self._seen: dict[tuple[str, ...], _Seen] = {}
        self._elsewhere: list[_Report] = []
        """Of other processes."""
        self._undo: list[Callable[[], None]] = []

    def start(self) -> None:
        """Watch all interpreters of this process."""
        watch = self
        original = Interpreter.understand

        @functools.wraps(original)
        def understand(interpreter: Interpreter, text: str, *args: Any, **kwargs: Any) -> Understood:
            found, clauses = original(interpreter, text, *args, **kwargs)
            watch._asked(interpreter, text, found)
            if found.status is Status.ACCEPTED:
                watch._reached(interpreter, [clause.reading for clause in clauses])
            return found, clauses

        setattr(Interpreter, "understand", understand)  # noqa: B010 - to mypy a method is no attribute
        self._undo.append(functools.partial(setattr, Interpreter, "understand", original))

    def stop(self) -> None:
        """Watch no longer. Idempotent."""
        while self._undo:
            self._undo.pop()()

    def _of(self, grammar: Grammar) -> _Seen:
        key = tuple(str(Path(name).resolve()) for name in grammar.files) or (str(id(grammar)),)
        seen = self._seen.get(key)
        if seen is None:
            seen = self._seen[key] = _Seen(grammar)
        return seen

    def _asked(self, interpreter: Interpreter, text: str, found: Interpretation) -> None:
        seen = self._of(interpreter.matcher.grammar)
        if found.status is Status.ACCEPTED and found.intent is not None:
            seen.intents.add(found.intent)
            if not found.slots:  # a stop is heard before any sentence is looked at
                readings = interpreter.matcher.read(Utterance.of(text, interpreter.matcher.grammar.language).words)
                self._reached(interpreter, [one for one in readings[:1] if one.intent.name == found.intent])

    def _reached(self, interpreter: Interpreter, readings: Any) -> None:
        seen = self._of(interpreter.matcher.grammar)
        for reading in readings:
            if not isinstance(reading, Reading):
                continue
            name = reading.intent.name
            seen.intents.add(name)
            seen.sentences.add((name, reading.sentence.text))
            seen.slots.update((name, label) for label, value in reading.values().items() if value is not None)

    # -- telling ------------------------------------------------------------------------------------------------

    def missed(self) -> dict[str, list[Missed]]:
        """By the grammar's files: what no test reached, intents first."""
        return {report.title: list(report.missed) for report in self._reports()}

    def told(self) -> list[dict[str, Any]]:
        """The same as plain data, for :meth:`add` in another process."""
        return [asdict(report) for report in self._reports()]

    def add(self, told: Sequence[Mapping[str, Any]]) -> None:
        """Count what was reached in another process."""
        for one in told:
            missed = [Missed(**{**part, "place": part["place"] and Place(**part["place"])}) for part in one["missed"]]
            self._elsewhere.append(_Report(one["title"], one["totals"], missed, one["included"]))

    def _reports(self) -> list[_Report]:
        """One of each grammar, whoever used it."""
        found: dict[tuple[object, ...], _Report] = {}
        own = (
            _Report(_title(seen.grammar), _totals(seen.grammar), list(_missed(seen)), _included(seen.grammar))
            for seen in self._seen.values()
        )
        for report in (*own, *self._elsewhere):
            key = (report.title, *report.totals.items())
            found[key] = found[key].beside(report) if key in found else report
        return list(found.values())

    def lines(self) -> Iterator[str]:
        """The report for a terminal."""
        reports = self._reports()
        if not reports:
            yield "no grammar was used"
        for report in reports:
            counts = []
            for kind, total in report.totals.items():
                reached = total - sum(1 for item in report.missed if item.kind == kind)
                counts.append(f"{reached} of {total} {kind}s")
            yield f"{report.title}: {', '.join(counts)}"
            theirs = [item for item in report.missed if item.place is not None and item.place.file in report.included]
            known = set(theirs)
            for item in report.missed:
                if item in known:
                    continue
                where = f"{_short(item.place.file)}:{item.place.line}" if item.place is not None else ""
                name = item.name if item.kind == "intent" else f"{item.intent}: {item.name}"
                yield f"  {item.kind:<8} {where:<28} {name}"
            if theirs:
                names = ", ".join(Path(file).name for file in report.included)
                yield f"  and of the engine's own {names} {_counted(theirs)}"


def _parts(intent: Intent) -> dict[str, Place | None]:
    """The sentences and patterns of an intent."""
    found: dict[str, Place | None] = {sentence.text: sentence.place for sentence in intent.all_sentences}
    found.update(dict.fromkeys(intent.regex, intent.place))
    if intent.lark is not None:
        found[intent.lark] = intent.place
    return found


def _slot_labels(grammar: Grammar, node: Node) -> Iterator[str]:
    for reference in references(node):
        if reference.name in grammar.slots:
            yield reference.label
        elif reference.name in grammar.phrases:
            yield from _slot_labels(grammar, grammar.phrases[reference.name])


def _labels(grammar: Grammar, intent: Intent) -> tuple[str, ...]:
    said = (label for sentence in intent.all_sentences for label in _slot_labels(grammar, sentence.template))
    fixed = (label for sentence in intent.all_sentences for label in sentence.fixed)
    return tuple(dict.fromkeys((*said, *fixed)))


def _totals(grammar: Grammar) -> dict[str, int]:
    intents = grammar.intents.values()
    return {
        "intent": len(intents),
        "sentence": sum(len(_parts(intent)) for intent in intents),
        "slot": sum(len(_labels(grammar, intent)) for intent in intents),
    }


def _missed(seen: _Seen) -> Iterator[Missed]:
    intents = seen.grammar.intents
    for name, intent in intents.items():
        if name not in seen.intents:
            yield Missed("intent", name, name, intent.place)
    for name, intent in intents.items():
        for text, place in _parts(intent).items():
            if (name, text) not in seen.sentences:
                yield Missed("sentence", name, text.strip().replace("\n", " "), place)
    for name, intent in intents.items():
        for label in _labels(seen.grammar, intent):
            if (name, label) not in seen.slots:
                yield Missed("slot", name, label, intent.place)


def _included(grammar: Grammar) -> list[str]:
    files = [file for file in grammar.files if is_shipped(file)]
    return files if len(files) < len(grammar.files) else []


def _counted(parts: Sequence[Missed]) -> str:
    counts = [(sum(part.kind == kind for part in parts), kind) for kind in ("intent", "sentence", "slot")]
    return ", ".join(f"{count} {kind}{'s' * (count != 1)}" for count, kind in counts if count)


def _title(grammar: Grammar) -> str:
    return ", ".join(_short(file) for file in grammar.files) or f"grammar of {grammar.language!r}"


def _short(file: str) -> str:
    """A path as a person standing in this folder writes it."""
    path = Path(file).resolve()
    here = Path.cwd()
    return str(path.relative_to(here)) if path.is_relative_to(here) else file
