"""Why a text was understood as it was: every step of :class:`Interpreter`, told by the code that takes it.

A :class:`Witness` is an interpreter whose own methods are watched: what they are given and what they answer becomes
the explanation. Nothing is decided here, so an explanation cannot differ from a parse; and a parse that nobody wants
explained has no watcher, so it costs nothing.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any

from intent_engine.interpretation import Interpretation
from intent_engine.language.action_builder import CannotActError, build_action, defaults_of, holds
from intent_engine.language.grammar import Intent, Place
from intent_engine.language.matcher import Reading, SlotReading
from intent_engine.language.meaning import Clause, Interpreter
from intent_engine.language.normalize import tokenize
from intent_engine.language.quantities import Relative
from intent_engine.language.utterance import PhraseSet, Utterance

__all__ = ["Candidate", "Explanation", "Noticed", "SlotSource", "Step", "Witness", "Word"]

MAX_STEPS = 12
"""Steps told inside another; a correction can be tried in many ways, and nobody reads them all."""
NO_SPLIT = "no way to split it into whole commands"


@dataclass(frozen=True, slots=True)
class Word:
    """A normalised word and what it was written as."""

    word: str
    text: str
    pause: bool
    """Whether a pause or punctuation stands before it."""


@dataclass(frozen=True, slots=True)
class Noticed:
    """Words that are no content: a filler, a negation, a correction."""

    kind: str
    words: str
    start: int
    """Place of the first among the words."""


@dataclass(frozen=True, slots=True)
class SlotSource:
    """A value and where it came from."""

    name: str
    value: Any
    source: str
    """``said``, ``sentence`` (it has the value without saying it), ``default`` or ``condition``."""
    words: str = ""
    """What was said, as understood; or the condition."""
    how: str = "exact"
    """Of what was said: ``exact``, ``fuzzy``, ``ambiguous``, ``unknown`` or ``limit``."""
    score: float = 1.0
    rivals: tuple[tuple[str, float], ...] = ()
    """Names that came near, best first."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """A sentence of the grammar that has the words."""

    intent: str
    sentence: str
    """As the grammar file has it."""
    place: str
    """``file:line`` of it."""
    words: str
    """As understood: sound-alikes replaced."""
    slots: tuple[SlotSource, ...]
    score: float
    priority: int
    free_words: int
    """Words that fell into free text."""
    refused: str
    """Why it was not taken; empty: it was."""


@dataclass(frozen=True, slots=True)
class Step:
    """Something that was tried."""

    name: str
    words: str
    """What it was tried on."""
    outcome: str
    candidates: tuple[Candidate, ...] = ()
    steps: tuple[Step, ...] = ()
    """What was tried to find it out."""
    untold: int = 0
    """Further steps inside that are not listed."""


@dataclass(frozen=True, slots=True)
class Explanation:
    """The path from a text to its interpretation."""

    language: str
    words: tuple[Word, ...]
    noticed: tuple[Noticed, ...]
    steps: tuple[Step, ...]
    slots: tuple[tuple[SlotSource, ...], ...]
    """Of each command that was understood, in order: values and where they came from."""
    interpretation: Interpretation

    def to_json(self) -> dict[str, Any]:
        """A plain dictionary: the interpretation's own keys, and ``explanation``."""
        return self.interpretation.to_json() | {
            "explanation": {
                "language": self.language,
                "words": [_plain(word) for word in self.words],
                "noticed": [_plain(one) for one in self.noticed],
                "steps": [_plain(step) for step in self.steps],
                "slots": [[_plain(slot) for slot in slots] for slots in self.slots],
            }
        }


def _plain(value: Any) -> Any:
    if hasattr(value, "__dataclass_fields__"):
        return {name: _plain(getattr(value, name)) for name in value.__dataclass_fields__}
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    return value


class _Open:
    """A step that is being taken."""

    def __init__(self) -> None:
        self.candidates: list[Candidate] = []
        self.steps: list[Step] = []


class Witness(Interpreter):
    """An interpreter that remembers how it came to its last interpretation. Not thread-safe; made for one text."""

    def __init__(self, interpreter: Interpreter) -> None:
        self.__dict__.update(interpreter.__dict__)
        self._open: list[_Open] = [_Open()]
        self._clauses: list[Clause] = []
        self._found: Interpretation | None = None
        for name, tell in _TOLD.items():
            if hasattr(self, name):  # a test says when one is gone; an explanation is then only shorter
                setattr(self, name, self._watched(getattr(self, name), tell))
        for name in _CLAUSES:
            setattr(self, name, self._keeping(getattr(self, name)))
        setattr(self, "_choose", self._judging(self._choose))  # noqa: B010 - to mypy a method is no attribute

    def interpret(self, text: str, state: Collection[str] = (), *, spoken: bool = False) -> Interpretation:
        self._found = super().interpret(text, state, spoken=spoken)
        return self._found

    def explanation(self, found: Interpretation) -> Explanation:
        """How the last text came to be ``found``: what this interpreter gave, with "it" and "again" put in."""
        before = self._found
        if before is not None and before != found:
            outcome = found.reason if found.status is not before.status else "what it points back to is put in"
            self._open[0].steps.append(Step("pointing back", found.text, outcome))
        tokens = tokenize(found.text[:2000])
        words = tuple(Word(token.word, found.text[token.start : token.end], token.breaks) for token in tokens)
        return Explanation(
            self._grammar.language,
            words,
            tuple(self._noticed([token.word for token in tokens])),
            tuple(self._open[0].steps),
            tuple(_sources(clause, self.matcher.locations) for clause in self._clauses),
            found,
        )

    def _noticed(self, words: list[str]) -> list[Noticed]:
        found = []
        for kind, phrases in self._phrase_sets().items():
            position = 0
            while position < len(words):
                length = phrases.at(words, position)
                if length:
                    found.append(Noticed(kind, " ".join(words[position : position + length]), position))
                position += max(length, 1)
        return sorted(found, key=lambda one: one.start)

    def _phrase_sets(self) -> Mapping[str, PhraseSet]:
        return {
            "filler": self._fillers,
            "wake word": self._wake,
            "stop": self._stop,
            "negation": self._negation,
            "correction": self._correction,
            "cancellation": self._cancel,
            "joint": self._sequence,
            "contrast": self._contrast,
        }

    # -- watching ---------------------------------------------------------------------------------------------

    def _watched(
        self, method: Callable[..., Any], tell: Callable[..., tuple[str, str, str] | None]
    ) -> Callable[..., Any]:
        @functools.wraps(method)
        def watching(*args: Any, **kwargs: Any) -> Any:
            step = _Open()
            self._open.append(step)
            try:
                answer = method(*args, **kwargs)
            finally:
                self._open.pop()
            told = tell(answer, *args)
            if told is not None and (step.steps or told[2] != NO_SPLIT):
                inner = step.steps[:MAX_STEPS]
                whole = Step(*told, tuple(step.candidates), tuple(inner), len(step.steps) - len(inner))
                told_before = self._open[-1].steps
                again = bool(told_before) and whole.name == "refused" and told_before[-1].outcome == whole.outcome
                if whole not in told_before and not again:  # the same is asked with and without fillers
                    told_before.append(whole)
            return answer

        return watching

    def _keeping(self, method: Callable[..., Interpretation]) -> Callable[..., Interpretation]:
        @functools.wraps(method)
        def keeping(text: str, told: Clause | list[Clause], *rest: Any) -> Interpretation:
            self._clauses = [told] if isinstance(told, Clause) else list(told)
            return method(text, told, *rest)

        return keeping

    def _judging(self, method: Callable[..., Clause]) -> Callable[[list[Reading], Collection[str]], Clause]:
        @functools.wraps(method)
        def judging(readings: list[Reading], state: Collection[str]) -> Clause:
            clause = method(readings, state)
            self._open[-1].candidates.extend(
                _candidate(reading, self._why_refused(reading, clause, state)) for reading in readings
            )
            return clause

        return judging

    def _why_refused(self, reading: Reading, clause: Clause, state: Collection[str]) -> str:
        if reading is clause.reading:
            return "" if clause.accepted else clause.reason
        why = reading.problem or self._forbidden(reading, state)
        if why or clause.reading is None:
            return why or "another was nearer"
        best = clause.reading
        if reading.intent.priority != best.intent.priority:
            return f"intent {best.intent.name!r} has a higher priority"
        if reading.free_words != best.free_words:
            return "more of its words fall into free text"
        if reading.alikes != best.alikes:
            return "more of its words had to be replaced by others that sound alike"
        if reading.score != best.score:
            return "another is nearer to what was said"
        return "as good as the one above it" if clause.ambiguous else "it means the same"


def _words_of(part: Any) -> str:
    return " ".join(part.words if isinstance(part, Utterance) else part)


def _outcome(clause: Clause | None, none: str) -> str:
    if clause is None:
        return none
    if clause.accepted:
        intent = clause.reading.intent.name if clause.reading is not None else ""
        return f"understood as {intent}" + (f" ({clause.reason})" if clause.reason else "")
    return clause.reason


def _tell_clause(name: str, none: str) -> Callable[..., tuple[str, str, str] | None]:
    def tell(answer: Clause | None, part: Any, *_: Any) -> tuple[str, str, str] | None:
        return name, _words_of(part), _outcome(answer, none)

    return tell


def _tell_stop(answer: bool, said: Utterance, *_: Any) -> tuple[str, str, str]:
    return "stop", _words_of(said), "a command to stop" if answer else "no command to stop"


def _tell_wake(answer: Utterance | None, said: Utterance, *_: Any) -> tuple[str, str, str]:
    return "wake word", _words_of(said), "not said" if answer is None else f"said; then {_words_of(answer)!r}"


def _tell_numbers(answer: bool, core: Utterance, *_: Any) -> tuple[str, str, str] | None:
    return ("numbers", _words_of(core), "one number was begun twice") if answer else None


def _tell_negation(answer: tuple[Utterance | None, str], core: Utterance, *_: Any) -> tuple[str, str, str]:
    wanted, reason = answer
    return "negation", _words_of(core), reason if wanted is None else f"only this is wanted: {_words_of(wanted)!r}"


def _tell_compound(answer: list[Clause] | None, core: Utterance, *_: Any) -> tuple[str, str, str] | None:
    if answer is None:
        return "compound", _words_of(core), NO_SPLIT
    return "compound", _words_of(core), f"{len(answer)} commands" if len(answer) > 1 else "one command"


def _tell_replaced(answer: Any, said: list[str], meant: list[str], *_: Any) -> tuple[str, str, str]:
    outcome = "it is not clear what is corrected" if answer is None else f"what is meant: {_words_of(answer)!r}"
    return "correction", f"{' '.join(said)} / {' '.join(meant)}", outcome


def _tell_refused(answer: Interpretation, *_: Any) -> tuple[str, str, str]:
    return "refused", answer.text, answer.reason


def _tell_nothing(answer: Interpretation, _: str, core: Utterance, *__: Any) -> tuple[str, str, str]:
    return "otherwise", _words_of(core), f"{answer.status.value}: {answer.reason}"


_TOLD: Mapping[str, Callable[..., tuple[str, str, str] | None]] = {
    "_stops": _tell_stop,
    "_stops_between": _tell_stop,
    "_awake": _tell_wake,
    "_exact": _tell_clause("sentence", "no sentence has these words"),
    "_number_restarted": _tell_numbers,
    "_after_negation": _tell_negation,
    "_compound": _tell_compound,
    "_clause": _tell_clause("command", "no command"),
    "_corrected": _tell_clause("correction", "nothing that can be corrected"),
    "_replace": _tell_replaced,
    "_misheard": _tell_clause("misheard", "no sentence comes near"),
    "_rejected": _tell_refused,
    "_not_understood": _tell_nothing,
}
"""Methods of the interpreter that decide something, and how each is told."""
_CLAUSES = ("_accepted", "_not_accepted", "_joined")
"""Methods that are given the clauses of which the interpretation is made."""


# -- readings -------------------------------------------------------------------------------------------------


def _candidate(reading: Reading, refused: str) -> Candidate:
    return Candidate(
        reading.intent.name,
        reading.sentence.text.strip(),
        _at(reading.sentence.place or reading.intent.place),
        " ".join(reading.words),
        (*(_said(slot, reading) for slot in reading.slots), *_fixed(reading)),
        round(reading.score, 4),
        reading.intent.priority,
        reading.free_words,
        refused,
    )


def _at(place: Place | None) -> str:
    return f"{place.file}:{place.line}" if place is not None else ""


def _value(value: Any) -> Any:
    return value.factor if isinstance(value, Relative) else value


def _said(slot: SlotReading, reading: Reading) -> SlotSource:
    words = " ".join(reading.words[slot.start : slot.end])
    rivals = tuple((name, round(score, 3)) for name, score in slot.rivals)
    return SlotSource(slot.label, _value(slot.value), "said", words, slot.status, round(slot.score, 3), rivals)


def _fixed(reading: Reading) -> list[SlotSource]:
    spoken = {slot.label for slot in reading.slots}
    return [
        SlotSource(label, value, "sentence") for label, value in reading.sentence.fixed.items() if label not in spoken
    ]


def _sources(clause: Clause, locations: Any) -> tuple[SlotSource, ...]:
    """Every value of a command: said, fixed by the sentence, or a default that made a difference."""
    reading = clause.reading
    if reading is None:
        return ()
    found = [*(_said(slot, reading) for slot in reading.slots), *_fixed(reading)]
    intent, values = reading.intent, reading.values()
    for label, value in defaults_of(intent, values).items() if clause.accepted else ():
        if _mattered(intent, values, label, locations):
            condition = next(
                (one for one in reversed(intent.when) if label in one.defaults and holds(one, values)), None
            )
            words = ", ".join(f"{name}: {one}" for name, one in condition.slots.items()) if condition else ""
            found.append(SlotSource(label, _value(value), "condition" if condition else "default", words))
    return tuple(found)


def _mattered(intent: Intent, values: Mapping[str, Any], label: str, locations: Any) -> bool:
    """Whether the action would be another with another default."""

    def other(defaults: Mapping[str, Any]) -> dict[str, Any]:
        changed = dict(defaults)
        if isinstance(changed.get(label), (int, float)):
            changed[label] = changed[label] * 1.5 + 0.1
        else:
            changed.pop(label, None)
        return changed

    conditions = tuple(replace(one, defaults=other(one.defaults)) for one in intent.when)
    changed = replace(intent, defaults=other(intent.defaults), when=conditions)
    try:
        return build_action(changed, values, locations) != build_action(intent, values, locations)
    except CannotActError:
        return True
