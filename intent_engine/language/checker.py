"""What is doubtful in a grammar that loads: sentences that meet, that are never understood, names that sound alike."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from itertools import combinations
from typing import TYPE_CHECKING, Any

from intent_engine.errors import Problem
from intent_engine.interpretation import Status
from intent_engine.language.checking.grammar_figures import Size, grammar_size
from intent_engine.language.checking.lost_opposites import lost_opposites
from intent_engine.language.checking.map_fit import name_or_command, named_like_commands, one_is_a_name, places_missing
from intent_engine.language.checking.slot_notes import slot_notes
from intent_engine.language.grammar import FREE_KINDS, QUANTITY_KINDS, Grammar, Intent, Place, Sentence, problem_at
from intent_engine.language.meaning import Interpreter
from intent_engine.language.names import MIN_SCORE
from intent_engine.language.networks.exploration import Exploration, Meeting, explore
from intent_engine.language.networks.nearest import Nearest
from intent_engine.language.pattern.pattern_checks import pattern_findings
from intent_engine.language.reading import Reading
from intent_engine.language.slots.name_words import is_identifier, name_words
from intent_engine.language.templates.spellings import spellings

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["Figures", "Finding", "Report", "alike", "check_grammar"]

MAX_PAIRS = 400
"""Names that are all compared with each other; of more, only those that have the same consonants."""
MAX_SPELLINGS = 64


@dataclass(frozen=True, slots=True)
class Finding:
    """Something that its author should know."""

    level: str
    """``error``: it cannot be used; ``warning``: it is hardly meant; ``note``: it works, and this is how."""
    topic: str
    """``file``, ``ambiguous``, ``shadowed``, ``unreachable``, ``overlap``, ``pattern``, ``alike``, ``slot``, ``place``
    (of a map) or ``example``."""
    problem: Problem

    def to_json(self) -> dict[str, Any]:
        return {"level": self.level, "topic": self.topic, **asdict(self.problem)}


@dataclass(frozen=True, slots=True)
class Figures:
    """How large and how ambiguous a grammar is."""

    size: Size
    states: int
    """Of the word networks, with numbers as one word and a few hundred names at most."""
    arcs: int
    word_states: int
    """Of the automaton made deterministic, as far as it was walked."""
    widest: int
    """Most ways to go on after the same words: what one word of an utterance can cost."""
    endings: int
    """Word states that end a sentence."""
    shared: int
    """Those of them that end sentences of several intents."""
    ambiguous: int
    """Those of them where nobody could tell which was meant."""
    complete: bool
    """Whether all sentences were walked."""

    def to_json(self) -> dict[str, Any]:
        data = asdict(self)
        size: dict[str, Any] = data.pop("size")
        return size | data


@dataclass(frozen=True, slots=True)
class Report:
    """What was found in the grammar of one language."""

    language: str
    files: tuple[str, ...]
    findings: tuple[Finding, ...]
    figures: Figures

    def to_json(self) -> dict[str, Any]:
        return {
            "language": self.language,
            "files": list(self.files),
            "findings": [finding.to_json() for finding in self.findings],
            "figures": self.figures.to_json(),
        }


def check_grammar(grammar: Grammar, locations: LocationMap | None) -> Report:
    """Walk a grammar that has loaded, and tell what is doubtful in it and how large it is.

    Raises:
        ConfigError: it has more than 20,000 ways to go on after the same words.
    """
    walk = explore(grammar, locations)
    met = _Meetings(walk)
    findings = [Finding("warning", "file", problem) for problem in grammar.warnings]
    findings += met.findings()
    findings += [Finding(*found) for found in pattern_findings(grammar, locations)]
    findings += [Finding("warning", "alike", problem) for problem in _alike_values(grammar)]
    findings += [Finding("warning", "slot", problem) for problem in lost_opposites(grammar)]
    findings += [Finding("note", "slot", problem) for problem in slot_notes(grammar)]
    if locations is not None:
        findings += [Finding("warning", "file", problem) for problem in locations.warnings]
        findings += [Finding("warning", "alike", problem) for problem in _alike_places(locations)]
        findings += [Finding("warning", "place", problem) for problem in places_missing(grammar, locations)]
        findings += met.names(locations)
    states, arcs = walk.matcher.networks.size()
    figures = Figures(
        size=grammar_size(grammar, locations),
        states=states,
        arcs=arcs,
        word_states=walk.states,
        widest=walk.widest,
        endings=len(walk.meetings),
        shared=met.shared,
        ambiguous=met.ambiguous,
        complete=walk.complete,
    )
    order = {"error": 0, "warning": 1, "note": 2}
    findings.sort(key=lambda one: (order[one.level], one.problem.file or "", one.problem.line or 0))
    return Report(grammar.language, grammar.files, tuple(findings), figures)


# -- sentences that meet --------------------------------------------------------------------------------------


@dataclass
class _Meetings:
    """Which sentences share words, and who wins."""

    walk: Exploration
    shared: int = 0
    ambiguous: int = 0
    _won: set[int] = field(default_factory=set)
    """Sentences (by identity) that are the meaning of some words."""
    _lost: dict[int, tuple[Reading, Meeting]] = field(default_factory=dict)
    """Sentence that was read, though another won: who, and on which words first."""
    _unclear: set[int] = field(default_factory=set)
    """Sentences of which an amount was not clear as it was walked, and may be as somebody says it: "7 7"."""
    _told: set[tuple[int, int]] = field(default_factory=set)

    _names: dict[str, tuple[str, Reading]] = field(default_factory=dict)
    """Places whose name may be a part of a command: the first words that may be both, and the command."""

    def names(self, locations: LocationMap) -> Iterator[Finding]:
        """Names of places that are in the way of commands; after ``findings``."""
        for name, (words, command) in self._names.items():
            yield Finding("warning", "ambiguous", name_or_command(locations, name, words, command))
        told = (*self._names, *locations.doubtful)
        for problem in named_like_commands(self.walk.matcher, locations, told):
            yield Finding("warning", "place", problem)

    def findings(self) -> list[Finding]:
        interpreter = Interpreter(self.walk.matcher, Nearest(self.walk.matcher))
        found: list[Finding] = []
        for meeting in self.walk.meetings:
            readings = [one for one in meeting.readings if not any(slot.status == "unknown" for slot in one.slots)]
            if not readings:
                self._unclear.update(id(one.sentence) for one in meeting.readings if _only_amounts_unclear(one))
                continue
            first, *others = readings
            self._won.add(id(first.sentence))
            rivals = [one for one in others if one.intent is not first.intent]
            self.shared += bool(rivals)
            for other in others:
                self._lost.setdefault(id(other.sentence), (first, meeting))
            level = [one for one in others if _rank(one) == _rank(first) and not _means_the_same(one, first)]
            self._won.update(id(one.sentence) for one in level)
            if level and interpreter.interpret(" ".join(meeting.words)).status is Status.AMBIGUOUS:
                self.ambiguous += 1
                rows = [self._ambiguous(first, other, meeting) for other in level if self._new(first, other)]
                found.extend(row for row in rows if row is not None)
            found.extend(self._overlap(first, other, meeting) for other in rivals if self._new(first, other))
        self._see_later()
        return [*found, *self._never()]

    def _see_later(self) -> None:
        """Which of the sentences that are one only behind another are understood: what is a command by itself wins."""
        for meeting in self.walk.later:
            readings = [one for one in meeting.readings if not any(slot.status == "unknown" for slot in one.slots)]
            whole = [one for one in self.walk.matcher.read(list(meeting.words)) if not one.problem]
            winners = [*whole, *readings]
            for reading in readings:
                if reading is winners[0] or one_is_a_name(reading, winners[0]) is not None:
                    self._won.add(id(reading.sentence))
                else:
                    self._lost.setdefault(id(reading.sentence), (winners[0], meeting))

    def _new(self, one: Reading, other: Reading) -> bool:
        pair = (id(one.sentence), id(other.sentence))
        if pair in self._told:
            return False
        self._told.update((pair, pair[::-1]))
        return True

    def _ambiguous(self, first: Reading, other: Reading, meeting: Meeting) -> Finding | None:
        words = " ".join(meeting.words)
        message = (
            f"{words!r} could be this sentence of {other.intent.name!r} or that of {first.intent.name!r}"
            f"{_at(first.sentence.place, other.sentence.place)}: the robot would ask"
        )
        if self._far_fetched(first) or self._far_fetched(other):
            return Finding("note", "ambiguous", problem_at(other.sentence.place, message))
        if (named := one_is_a_name(first, other)) is not None:
            self._names.setdefault(named[0], (words, named[1]))
            return None
        hint = "let one of them need another word, or "
        hint += "remove it" if other.intent is first.intent else "give one intent a priority"
        return Finding("warning", "ambiguous", problem_at(other.sentence.place, message, hint))

    def _far_fetched(self, reading: Reading) -> bool:
        """Whether free text in it is made of the words of sentences: "put down on down"."""
        return any(
            set(reading.words[slot.start : slot.end]) != {self.walk.free}
            for slot in reading.slots
            if slot.slot.type in FREE_KINDS
        )

    @staticmethod
    def _overlap(first: Reading, other: Reading, meeting: Meeting) -> Finding:
        words = " ".join(meeting.words)
        message = (
            f"{words!r} is also a sentence of {first.intent.name!r}"
            f"{_at(first.sentence.place, other.sentence.place)}, which wins: {_reason(first, other)}"
        )
        return Finding("note", "overlap", problem_at(other.sentence.place, message))

    def _never(self) -> Iterator[Finding]:
        """Sentences that no words mean."""
        for intent in self.walk.matcher.grammar.intents.values():
            for sentence in intent.all_sentences:
                if id(sentence) not in self._won and (id(sentence) in self._lost or id(sentence) not in self._unclear):
                    yield from self._never_one(intent, sentence)

    def _never_one(self, intent: Intent, sentence: Sentence) -> Iterator[Finding]:
        if id(sentence) in self._lost:
            first, meeting = self._lost[id(sentence)]
            where = _at(first.sentence.place, sentence.place)
            words = " ".join(meeting.words)
            if first.intent is intent and dict(first.sentence.fixed) == dict(sentence.fixed):
                message = f"all that this sentence says, others of {intent.name!r} say: {words!r} is one before{where}"
                yield Finding("note", "shadowed", problem_at(sentence.place, message, "it can be removed"))
                return
            message = f"this sentence is never understood: {words!r} is one of {first.intent.name!r}{where}"
            if self.walk.complete:
                yield Finding(
                    "warning", "shadowed", problem_at(sentence.place, message, "reword one, or give a priority")
                )
        elif self.walk.complete:
            message = "nothing that anybody says is this sentence"
            if self.walk.matcher.locations is None or not len(self.walk.matcher.locations):
                hint = "a place is asked for, and there is no map"
            else:
                hint = "a list in it is empty, or no place of the map has the tags that it asks for"
            yield Finding("warning", "unreachable", problem_at(sentence.place, message, hint))


def _only_amounts_unclear(reading: Reading) -> bool:
    return all(slot.slot.type in QUANTITY_KINDS for slot in reading.slots if slot.status == "unknown")


def _rank(reading: Reading) -> tuple[int, int, int]:
    """What decides between readings that have no problem."""
    return -reading.intent.priority, reading.free_words, reading.alikes


def _means_the_same(one: Reading, other: Reading) -> bool:
    return one.intent is other.intent and one.values() == other.values()


def _reason(first: Reading, other: Reading) -> str:
    if any(slot.problem for slot in other.slots):
        return next(slot.problem for slot in other.slots if slot.problem)
    if first.intent.priority != other.intent.priority:
        return "its priority is higher"
    if first.free_words != other.free_words:
        return "fewer of its words fall into free text"
    return "it stands first" if (first.intent.requires, first.intent.excludes) == (
        other.intent.requires, other.intent.excludes
    ) else "where the robot's state allows both"  # fmt: skip


def _at(place: Place | None, seen_from: Place | None) -> str:
    if place is None:
        return ""
    same = seen_from is not None and seen_from.file == place.file
    return f" (line {place.line})" if same else f" ({place.file}:{place.line})"


# -- names that sound alike -----------------------------------------------------------------------------------


def alike(names: Sequence[tuple[tuple[str, ...], str]]) -> Iterator[tuple[tuple[str, ...], tuple[str, ...], str, str]]:
    """Pairs of names of different things of which one may be heard for the other.

    Args:
        names: (words, what they name).

    Yields:
        The words of both, and what they name.
    """
    from intent_engine.language.words.likeness import compare, sound

    groups: dict[tuple[str, ...], list[tuple[tuple[str, ...], str]]] = {}
    for words, name in names:
        groups.setdefault(tuple(word for word in words if is_identifier(word)), []).append((words, name))
    for group in groups.values():
        buckets: Mapping[Any, list[tuple[tuple[str, ...], str]]] = {(): group}
        if len(group) > MAX_PAIRS:
            sounding: dict[Any, list[tuple[tuple[str, ...], str]]] = {}
            for row in group:
                sounding.setdefault(tuple(sound(word) for word in row[0]), []).append(row)
            buckets = sounding
        for bucket in buckets.values():
            for (one, name), (other, rival) in combinations(bucket[: 4 * MAX_PAIRS], 2):
                if name != rival and abs(len("".join(one)) - len("".join(other))) <= 4:
                    found = compare(one, other)
                    if found.passes and found.score >= MIN_SCORE:
                        yield one, other, name, rival


def _alike_places(locations: LocationMap) -> Iterator[Problem]:
    names = [(name_words(" ".join(words)), name) for words, name in locations.names()]
    for one, other, name, rival in alike(names):
        said = f"{' '.join(one)!r} ({name})" if " ".join(one) != name else repr(name)
        told = f"{' '.join(other)!r} ({rival})" if " ".join(other) != rival else repr(rival)
        message = f"{said} and {told} sound alike: either may be heard for the other"
        yield locations.problem(rival, message, "rename one, or give it a number or letter of its own")


def _alike_values(grammar: Grammar) -> Iterator[Problem]:
    for slot in grammar.slots.values():
        if slot.type not in ("choice", "boolean") or not slot.fuzzy:
            continue
        names = [
            (name_words(" ".join(words)), str(value))
            for value, node in slot.values
            for words in spellings(node, grammar.phrases, MAX_SPELLINGS)
        ]
        for one, other, name, rival in alike(names):
            message = (
                f"slot {slot.name!r}: {' '.join(one)!r} ({name}) and {' '.join(other)!r} ({rival}) sound alike: "
                "either may be heard for the other"
            )
            yield problem_at(slot.place, message, "reword one, or give the slot fuzzy: false")
